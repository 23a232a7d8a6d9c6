#!/bin/sh
# SPDX-License-Identifier: MIT
# Checks that subjects of commits have at most 72 characters, from the commit that added this file.
# Argument: the top of the tree. Ends with 1 if a subject is longer, with 77 if there is no history.
skip() {
    echo "skipped: $1"
    exit 77
}

top=${1:?the top of the tree}
command -v git >/dev/null || skip "git is not installed"
[ -e "$top/.git" ] || skip "no history here: the tree was exported"
cd "$top" || exit 1
shallow=$(git rev-parse --is-shallow-repository) || skip "git cannot read the history"
[ "$shallow" = false ] || skip "the clone is shallow: it lacks the older commits"
base=$(git log --diff-filter=A --format=%H -- tests/layout/commit_subjects.sh | tail -n 1)
[ -n "$base" ] || skip "the rule itself is not committed yet"

long=$(git log --format='%h %s' "$base..HEAD" | LC_ALL=C awk '
    { hash = $1; sub(/^[^ ]+ /, ""); characters = $0; gsub(/[\200-\277]/, "", characters) }
    length(characters) > 72 { print hash ": a subject of " length(characters) " characters; the limit is 72: " $0 }')
[ -z "$long" ] || {
    echo "$long"
    exit 1
}
