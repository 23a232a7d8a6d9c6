#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Draws the pictures of wrong runs that handouts show. Each is the last frame of a scene that ends
# earlier than the one that ships. It runs with the reference, in which a mistake of tests/mistakes
# replaces one function. Where "-" stands for the mistake, the scene itself shows what goes wrong.
#
#   tests/handouts/wrong_pictures.sh             draws all of them, into assignments/
#   tests/handouts/wrong_pictures.sh a7-fracture draws those of one handout
#
# A test reads the table below, see pictures_test.cpp.
set -euo pipefail

# handout, picture, mistake, scene, end [s], size
table='
a1-kinematics wrong.png kinematics/net_wrench/about_origin one_wrench 1.5 480x300
a2-inertia wrong.png inertia/combine/midpoint hammer 0.67 480x300
a4-collision wrong.png collision/impulse_matrix/transpose_forgotten hundred_boxes 0.34 720x450
a5-contact wrong.png - rattling_stack 3.34 720x450
a6-plasticity wrong.png plasticity/plastic_flow/old_strain_forgotten paper_clip 5 480x300
a7-fracture wrong.png fracture/split_along_faces/rim_opened notched_plate 0.6 480x300
a7-fracture wrong_direction.png fracture/crack_plane/along_the_load notched_plate 0.6 480x300
'

root=$(cd "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# with_mistake MISTAKE FOLDER: the reference with one function renamed and the wrong one behind it.
# The file fracture_vertices.cpp becomes a part of fracture.cpp, because a folder has one file for
# each topic; the names that both of them have get a prefix there.
with_mistake() {
    local mistake=$1 folder=$2 topic formula
    IFS=/ read -r topic formula _ <<< "$mistake"
    cp "$root"/reference/*.cpp "$folder"
    local twice='is_index|is_mesh|corner_of|Face|face_of|Cut|Piece'
    sed -E "s/\b($twice)\b/v_\1/g" "$folder/fracture_vertices.cpp" >> "$folder/fracture.cpp"
    rm "$folder/fracture_vertices.cpp"
    sed -i -E "s/^([A-Za-z_:<>0-9 &]+ )$formula\(/\1right_$formula(/" "$folder/$topic.cpp"
    mkdir -p "$folder/mistakes/$topic"
    local header
    for header in "$root/tests/mistakes/$topic"/*.hpp; do
        [[ ! -e $header ]] || cp "$header" "$folder/mistakes/$topic"
    done
    cat "$root/tests/mistakes/$mistake.cpp" >> "$folder/$topic.cpp"
}

# draw HANDOUT PICTURE MISTAKE SCENE END SIZE
draw() {
    local folder=$work/$1-$2 scene=$4.json who=reference
    mkdir -p "$folder"
    if [[ $3 != - ]]; then
        who=$folder
        with_mistake "$3" "$folder"
    fi
    sed -E "s/^  \"end\": [0-9.]+/  \"end\": $5/" \
        "$root/assignments/$1/scenes/$scene" > "$folder/$scene"
    "$root/rigor" render "$folder/$scene" --with "$who" --size "$6" --out "$folder/frames" \
        < /dev/null
    local frames=("$folder"/frames/frame_*.png)
    cp "${frames[-1]}" "$root/assignments/$1/$2"
}

while read -r handout picture mistake scene end size; do
    [[ -n $handout && ${1:-$handout} == "$handout" ]] || continue
    draw "$handout" "$picture" "$mistake" "$scene" "$end" "$size"
done <<< "$table"
