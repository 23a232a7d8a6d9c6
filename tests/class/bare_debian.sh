#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Proves a tree from `./rigor release --out TREE` on bare Debian systems: debootstrap makes each,
# and the tree is started there as a student starts it, so that it installs what it needs. Every
# stub must be compiled and not implemented. Needs root, debootstrap and the network; a system takes
# 0.2 GB and a first build, and is removed afterwards.
#
#     tests/class/bare_debian.sh TREE [bookworm] [trixie]
set -euo pipefail

tree=$(readlink -f -- "${1:?expected a released tree}")
shift
[[ -x $tree/rigor && ! -e $tree/reference ]] || { echo "$tree: expected a released tree" >&2; exit 2; }
((EUID == 0)) || { echo "expected to be root, for debootstrap" >&2; exit 2; }
command -v debootstrap >/dev/null || { echo "not installed: apt-get install debootstrap" >&2; exit 2; }

# Runs in a view of the file system of its own, so that nothing stays mounted.
prove() {
    local root=$1
    mount -t proc proc "$root/proc"
    mount --rbind /dev "$root/dev"
    cp -a "$tree" "$root/handout"
    rm -rf "$root/handout/build"
    cp -L /etc/resolv.conf "$root/etc/resolv.conf"
    chroot "$root" /bin/bash -c 'cd /handout && ./rigor check a0 --out /result.json' && status=0 || status=$?
    ((status == 1)) || { echo "expected status 1 of the untouched stubs, found $status" >&2; return 1; }
    grep -q '"score": 0' "$root/result.json" && grep -q '"not_implemented"' "$root/result.json" ||
        { echo "expected stubs that are not implemented, found:" >&2; head -c 600 "$root/result.json" >&2; return 1; }
}

if [[ ${RIGOR_INSIDE:-} ]]; then
    prove "$RIGOR_INSIDE"
    exit
fi
for suite in "${@:-bookworm trixie}"; do
    for one in $suite; do
        root=$(mktemp -d)
        chmod 755 "$root" # as "/" is: whoever compiles a submission must enter it
        trap 'rm -rf --one-file-system "$root"' EXIT
        debootstrap --variant=minbase "$one" "$root" >"$root.log" 2>&1 ||
            { tail -n 3 "$root.log" >&2; exit 1; }
        RIGOR_INSIDE=$root unshare --mount --propagation private "$0" "$tree"
        rm -rf --one-file-system "$root" "$root.log"
        echo "$one: installs, builds, and every stub is not implemented"
    done
done
