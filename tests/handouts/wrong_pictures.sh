#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Draws the pictures of wrong runs that handouts show: on the left the reference's run, on the right
# the wrong one at the same moment. Each is the last frame of a scene that ends earlier than the one
# that ships, from a camera that is near what differs. In the wrong run a mistake of tests/mistakes
# replaces one function of the reference. Where "-" stands for the mistake, the scene itself goes
# wrong, and the engine's own contact is the right one.
#
#   tests/handouts/wrong_pictures.sh             draws all of them, into assignments/
#   tests/handouts/wrong_pictures.sh a7-fracture draws those of one handout
#
# A test reads the table below, see pictures_test.cpp.
set -euo pipefail

# handout, picture, mistake, scene, end [s], size; then camera: position, target, field of view; and
# what is drawn
table='
a1-kinematics wrong.png kinematics/net_wrench/about_origin one_wrench 1.2 360x360 3,4,7 -1.3,1,0 34 "axes":true,"angular_velocity":true
a2-inertia wrong.png inertia/combine/midpoint hammer 0.67 360x300 -0.3,5.7,6 -0.3,5.4,0 38 "axes":true
a4-collision wrong.png collision/impulse_matrix/transpose_forgotten hundred_boxes 0.34 360x360 5,4.2,7 0,1.25,0 42 "contacts":true
a5-contact wrong.png - rattling_stack 3.34 360x400 3.5,3.2,7.5 0,2.4,0 40 "contacts":true
a6-plasticity wrong.png plasticity/plastic_flow/old_strain_forgotten paper_clip 5 360x300 1.9,1.3,3.6 1.3,0.3,0 52 "solids":"plastic_strain","solids_range":[0,0.3],"labels":true
a7-fracture wrong.png fracture/split_along_faces/rim_opened notched_plate 0.6 360x300 0.3,0.2,1.9 0,0,0 45 "labels":true
a7-fracture wrong_direction.png fracture/crack_plane/along_the_load notched_plate 0.5 360x300 0.3,0.2,1.9 0,0,0 45 "labels":true
'

root=$(cd "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# with_mistake MISTAKE FOLDER: the reference with one function renamed and the wrong one behind it.
# fracture_vertices.cpp becomes a part of fracture.cpp, since a folder has one file for each topic.
with_mistake() {
    local mistake=$1 folder=$2 topic formula
    IFS=/ read -r topic formula _ <<< "$mistake"
    cp "$root"/reference/*.cpp "$root"/reference/*.hpp "$folder"
    cat "$folder/fracture_vertices.cpp" >> "$folder/fracture.cpp"
    rm "$folder/fracture_vertices.cpp"
    sed -i -E "s/^([A-Za-z_:<>0-9 &]+ )$formula\(/\1right_$formula(/" "$folder/$topic.cpp"
    mkdir -p "$folder/mistakes/$topic"
    local header
    for header in "$root/tests/mistakes/$topic"/*.hpp; do
        [[ ! -e $header ]] || cp "$header" "$folder/mistakes/$topic"
    done
    cat "$root/tests/mistakes/$mistake.cpp" >> "$folder/$topic.cpp"
}

# scene_for HANDOUT SCENE END POSITION TARGET FIELD_OF_VIEW DRAW: the scene, with another end
scene_for() {
    sed -E -e "s/^  \"end\": [0-9.]+/  \"end\": $3/" -e '/^  "(camera|draw)":/d' \
        -e "1a \\  \"camera\": {\"position\": [$4], \"target\": [$5], \"field_of_view\": $6},\n  \"draw\": {$7}," \
        "$root/assignments/$1/scenes/$2.json" | sed -z -E 's/,[[:space:]]*\}[[:space:]]*$/\n}\n/'
}

# last_frame SCENE_FILE WHO SIZE: renders the scene and names its last picture
last_frame() {
    "$root/rigor" render "$1" --with "$2" --size "$3" --out "${1%.json}" < /dev/null >&2
    local frames=("${1%.json}"/frame_*.png)
    echo "${frames[-1]}"
}

# draw HANDOUT PICTURE MISTAKE SCENE END SIZE POSITION TARGET FIELD_OF_VIEW DRAW
draw() {
    local folder=$work/$1-$2 who=reference right wrong
    mkdir -p "$folder/with"
    scene_for "$1" "$4" "$5" "${@:7}" > "$folder/wrong.json"
    cp "$folder/wrong.json" "$folder/right.json"
    if [[ $3 == - ]]; then
        sed -i -E 's/^  "contact": .*$/  "contact": "built_in",/' "$folder/right.json"
    else
        who=$folder/with
        with_mistake "$3" "$who"
    fi
    right=$(last_frame "$folder/right.json" reference "$6")
    wrong=$(last_frame "$folder/wrong.json" "$who" "$6")
    "$root/build/release/bin/side_by_side" "$right" "$wrong" "$root/assignments/$1/$2"
}

ninja -C "$root/build/release" side_by_side > /dev/null
while read -r handout row; do
    [[ -n $handout && ${1:-$handout} == "$handout" ]] || continue
    read -r -a fields <<< "$row"
    draw "$handout" "${fields[@]}"
done <<< "$table"
