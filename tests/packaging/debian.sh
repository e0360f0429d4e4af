#!/bin/sh
# Tries the README's first command, and a short gate, in a bare Debian or Ubuntu: debootstrap makes it
# in BUILD/debian, with gcc, make and the files that git lists, and removes it in the end. Needs root, a
# mirror, and some 2 GB.
# usage: debian.sh BUILD-DIRECTORY RELEASE     RELEASE: trixie (Debian 13), bookworm (12), noble (Ubuntu 24.04)
set -eu
. tests/script.sh
release=${2:?usage: debian.sh BUILD-DIRECTORY RELEASE}
mkdir -p "$1/debian"
root=$(cd "$1/debian" && pwd)/$release
script="bare Debian $release"
if ! command -v debootstrap >/dev/null || [ "$(id -u)" != 0 ]; then
    skip "bare Debian: needs root, and debootstrap: 'make setup-cross' installs it"
    finish
fi
# Mounts of its own, which end with this script, however it ends.
[ -n "${GN_OWN_MOUNTS:-}" ] || exec env GN_OWN_MOUNTS=1 unshare --mount sh "$0" "$@"
clean_up() {
    umount "$root/dev/pts" "$root/dev" "$root/proc" 2>/dev/null || :
    # What is still mounted would be removed too.
    grep -q " $root/" /proc/mounts || rm -rf --one-file-system "$root"
}
trap clean_up EXIT
trap 'exit 1' INT TERM HUP
clean_up

# inside WHAT COMMAND: runs a command in the tree; its output is shown if it fails.
inside() {
    began=$(date +%s)
    if chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
        sh -c "cd /root/gnomon && $2" >"$root.log" 2>&1; then
        passed=$((passed + 1))
        echo "$release: $1: $(($(date +%s) - began)) s: $(tail -n 1 "$root.log")"
    else
        failed=$((failed + 1))
        echo "FAILED: $release: $1"
        tail -n 30 "$root.log"
    fi
}

mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | grep '/debian/*$' | head -n 1)
mirror=${mirror:-http://deb.debian.org/debian}
suite=/usr/share/debootstrap/scripts/sid
[ "$release" != noble ] || { mirror=http://archive.ubuntu.com/ubuntu suite=/usr/share/debootstrap/scripts/gutsy; }
# Nothing here must survive a crash of the machine: dpkg need not wait for the disk.
mkdir -p "$root/etc/dpkg/dpkg.cfg.d"
echo force-unsafe-io >"$root/etc/dpkg/dpkg.cfg.d/unsafe-io"
debootstrap --variant=minbase --components=main,universe --include=gcc,libc6-dev,make "$release" "$root" "$mirror" \
    $suite >"$root.log" 2>&1 || { tail -n 20 "$root.log"; exit 1; }
mount -t proc proc "$root/proc"
mount --bind /dev "$root/dev"
mount --bind /dev/pts "$root/dev/pts"
mkdir "$root/root/gnomon"
git ls-files -z | xargs -0 tar -cf - | tar -xf - -C "$root/root/gnomon"

inside "make setup demo" "make setup demo"
inside "make setup" "make setup"
inside "tests are built" "make -j2 build/parity build/blits build/texels build/textures build/test_draw"
inside parity "build/parity --seed 1 --scenes 560"
inside "parity through EGL" "REFERENCE=egl build/parity --seed 2 --scenes 112"
inside blits "build/blits --seed 1 --blits 330"
inside texels "build/texels --seed 1 --textures 2"
inside textures "build/textures --seed 1 --cases 60"
inside "contract" "make check-contract"
finish
