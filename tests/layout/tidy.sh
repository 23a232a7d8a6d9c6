#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs clang-tidy over the framework, the reference and the tests' support, with the checks of
# .clang-tidy.
#
#   tests/layout/tidy.sh             the sources that differ from the last commit
#   tests/layout/tidy.sh --recent    those that the last twenty commits changed, or all where the
#                                    history is not known; so the test checks, which runs more often
#   tests/layout/tidy.sh --all       all of them
#
# Eigen takes longer to read than our own code. The sources therefore go into a few files, one for
# each processor, that include them one after the other. A source waits for the next round if the
# compiler refuses it there because two helpers have the same name.
# Ends with 0 if all is well, 1 if something was found, 77 if clang-tidy is not installed.
set -euo pipefail

root=$(cd "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root"
for program in clang-tidy clang++; do
    if ! command -v "$program" >/dev/null; then
        echo "skipped: $program is not installed"
        exit 77
    fi
done

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

options=(-std=c++20 -w -ferror-limit=0 "-I$root/framework" "-I$root/tests"
         -isystem /usr/include/eigen3)
for text in SOURCE_DIR BINARY_DIR MODULE_DIR GL FONT VERSION COMPILER LAUNCHER UNPACK; do
    options+=("-DRIGOR_$text=\"\"") # CMake fills these in
done

folders=()
for folder in framework reference tests/support; do
    [[ ! -d $folder ]] || folders+=("$folder")
done

# Lists the sources that differ from a commit. A changed header is checked through the source of its
# name or, without one, through one of the sources that include it; `--all` reads the others.
changed_sources() {
    local file
    git diff --name-only --diff-filter=d "$1" -- "${folders[@]}" >"$work/changed"
    git ls-files --others --exclude-standard -- "${folders[@]}" >>"$work/changed"
    while read -r file; do
        case $file in
        *.cpp) echo "$file" ;;
        *.hpp)
            if [[ -e ${file%.hpp}.cpp ]]; then
                echo "${file%.hpp}.cpp"
            else
                { grep -rlF --include='*.cpp' "\"${file#*/}\"" "${folders[@]}" || true; } |
                    sort | sed -n 1p
            fi
            ;;
        esac
    done <"$work/changed" | sort -u
}

all_sources() {
    find "${folders[@]}" -name '*.cpp' | sort
}

including() {
    sed "s|.*|#include \"$root/&\"|" "$1"
}

# The sources of a lot that the compiler refuses in its unit. For each error the compiler tells by
# which line of the unit the faulty file was included.
refused() {
    { clang++ -fsyntax-only "${options[@]}" "$2" 2>&1 || true; } |
        awk -v unit="$2" '
            index($0, "In file included from " unit ":") == 1 {
                n = split($0, part, ":")
                line = part[n - 1]
            }
            / error: / && line { print line }' |
        sort -nu | while read -r line; do sed -n "${line}p" "$1"; done
}

# Checks one lot of sources in rounds. The findings go to LOT.found.
check_lot() {
    local lot=$1 unit
    unit=$lot.cpp
    touch "$lot.found"
    while [[ -s $lot ]]; do
        cp "$lot" "$lot.taken"
        # An error can hide another one: the compiler says nothing of a name that conflicts with
        # one that it refused already. So it is asked until it refuses none.
        while including "$lot.taken" >"$unit"
            refused "$lot.taken" "$unit" >"$lot.refused"
            [[ -s $lot.refused && $(wc -l <"$lot.taken") -gt 1 ]]; do
            grep -vxFf "$lot.refused" "$lot.taken" >"$lot.rest" || head -n 1 "$lot.taken" >"$lot.rest"
            mv "$lot.rest" "$lot.taken"
        done
        clang-tidy --quiet --config-file="$root/.clang-tidy" "$unit" -- "${options[@]}" \
            >>"$lot.found" 2>"$lot.log" || true
        grep -vxFf "$lot.taken" "$lot" >"$lot.left" || true
        mv "$lot.left" "$lot"
    done
}

since=HEAD
if [[ ${1:-} == --recent ]]; then
    since=$(git rev-parse --verify --quiet HEAD~20 2>/dev/null) || set -- --all
fi
if [[ ${1:-} == --all ]]; then all_sources; else changed_sources "$since"; fi >"$work/sources"
if [[ ! -s $work/sources ]]; then
    [[ ${1:-} != --all ]] || { echo "no sources found in $root"; exit 1; }
    echo "no source was changed since $since"
    exit 0
fi

split -n "r/$(nproc)" "$work/sources" "$work/lot_"
for lot in "$work"/lot_??; do
    check_lot "$lot" &
done
wait

# A finding in a header is reported by every unit that includes it.
cat "$work"/lot_??.found | sed -nE "s|^$root/(.*: (warning\|error): .*)|\1|p" | sort -u >"$work/found"
sed 's/^/  /' "$work/found"
echo "$(wc -l <"$work/sources") sources, $(wc -l <"$work/found") findings"
[[ ! -s $work/found ]]
