#!/bin/sh
# Provides the reference that Gnomon's pixels are compared with: OSMesa and EGL of Mesa 25.0.7. On a
# system that has this version (Debian 13) its packages are installed. On any other system Debian 13's
# packages, and what they need, are unpacked into build/mesa or $MESA (240 MB); the system stays as it is:
# apt fetches them with lists and a cache of their own, and checks them with Debian's keys. A library
# of which the system has a version as new is left out.
# usage: setup-reference.sh [--help]
set -eu
self=setup-reference
case ${1:-} in -h | --help) sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$0"; exit ;; esac
. "$(dirname "$0")/debian.sh"
cd "$(dirname "$0")/.."

version=25.0.7
release=trixie
packages="libosmesa6 libegl1 libegl-mesa0 libgl1-mesa-dri"
folder=${MESA:-build/mesa}
case $folder in /*) ;; *) folder=$PWD/$folder ;; esac

for tool in dpkg apt-get; do
    command -v $tool >/dev/null 2>&1 || fail "this is no Debian system ($tool is missing):" \
        "give it OSMesa of Mesa $version, from Debian 13 (libosmesa6) or from Mesa's source"
done

# Debian's numbers. Ubuntu's, such as 25.0.7-0ubuntu1, stand for another build.
offered=$(LC_ALL=C apt-cache policy libosmesa6 2>/dev/null | sed -n 's/^ *Candidate: *//p')
case $offered in
"$version"-[1-9] | "$version"-[1-9]+deb*)
    install_packages "$packages"
    exit
    ;;
esac
# What was unpacked beside an older C library is not for a newer one.
libc=$(dpkg-query -W -f '${Version}' libc6 2>/dev/null) || libc=
if [ -e "$folder/usr/lib/lib" ] && [ "$(cat "$folder/system.txt")" = "$libc" ]; then
    say "Mesa $version is in $folder"
    exit
fi

keys=/usr/share/keyrings/debian-archive-keyring
# install_packages ends the shell that it runs in if there is nothing to do.
[ -e "$keys.gpg" ] || [ -e "$keys.pgp" ] || (install_packages debian-archive-keyring)
keys=$(ls "$keys.gpg" "$keys.pgp" 2>/dev/null | head -n 1)

# A Debian's own mirror has the other releases of Debian too.
mirror=http://deb.debian.org/debian
if grep -qx 'ID=debian' /etc/os-release; then
    own=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' |
        grep '/debian/*$' | grep -v archive.debian.org | head -n 1)
    mirror=${own:-$mirror}
fi

new=$folder.new
rm -rf "$new"
mkdir -p "$new/apt/lists/partial" "$new/apt/cache/archives/partial"
log=$(mktemp)
trap 'rm -rf "$log" "$new"' EXIT
trap 'exit 1' INT TERM HUP
echo "deb [signed-by=$keys] $mirror $release main" >"$new/apt/sources.list"
# No package counts as installed, so that apt finds all that they need.
: >"$new/apt/status"
# fetch ARGUMENT...: apt-get with nothing of the system's but its proxies and its architecture.
fetch() {
    apt-get -q -y -o Dir::State="$new/apt" -o Dir::State::status="$new/apt/status" \
        -o Dir::Cache="$new/apt/cache" -o Dir::Etc::SourceList="$new/apt/sources.list" \
        -o Dir::Etc::SourceParts=/dev/null -o Dir::Etc::Preferences=/dev/null \
        -o Dir::Etc::PreferencesParts=/dev/null -o APT::Default-Release= -o APT::Sandbox::User="$(id -un)" "$@"
}
step "reading the list of Debian's packages ($release)" fetch update
step "fetching Mesa $version (56 MB)" \
    fetch --no-install-recommends --download-only install $packages

say "unpacking it"
for archive in "$new"/apt/cache/archives/*.deb; do
    field() { dpkg-deb -f "$archive" "$1"; }
    case $(field Package) in
    libosmesa6)
        case $(field Version) in
        "$version"-*) ;;
        *) fail "Debian's $release has OSMesa $(field Version), not $version" ;;
        esac
        ;;
    esac
    # All of Mesa is of one version.
    case $(field Source) in
    mesa | "mesa "*) here= ;;
    *) here=$(dpkg-query -W -f '${db:Status-Status} ${Version}\n' "$(field Package)" 2>/dev/null |
        sed -n 's/^installed //p' | head -n 1) ;;
    esac
    if [ -n "$here" ] && dpkg --compare-versions "$here" ge "$(field Version)"; then
        continue
    fi
    dpkg-deb -x "$archive" "$new"
done
rm -rf "$new/apt" "$new/etc"
# Of the data, what EGL finds Mesa by.
find "$new/usr/share" -mindepth 1 -maxdepth 1 ! -name glvnd -exec rm -r {} +
# libLLVM searches the folder lib beside its own, and nowhere else but in the system's.
for libraries in "$new"/usr/lib/*-linux-gnu; do
    ln -s "$(basename "$libraries")" "$new/usr/lib/lib"
done
echo "$libc" >"$new/system.txt"
rm -rf "$folder"
mv "$new" "$folder"
say "Mesa $version is in $folder; nothing of the system was changed"
