# Functions that install Debian packages; the scripts tools/setup*.sh source this file.

say() { echo "$self: $*"; }
fail() { echo "$self: $*" >&2; exit 1; }

# Runs one step quietly; prints the step's output if it fails.
step() {
    say "$1"
    shift
    if ! "$@" >"$log" 2>&1; then
        cat "$log" >&2
        fail "failed: $*"
    fi
}

# install_packages "PACKAGE..." ARGUMENT...: the arguments are the script's.
install_packages() {
    packages=$1
    case "${2:-}" in
    "") ;;
    -h | --help)
        echo "tools/$self.sh: install the Debian packages that are missing of:"
        echo $packages
        exit 0
        ;;
    *) fail "unknown argument '$2'; 'tools/$self.sh --help' lists the packages" ;;
    esac

    for tool in dpkg-query apt-get; do
        command -v $tool >/dev/null 2>&1 || fail "this is no Debian system ($tool is missing);" \
            "install these, or what they are called here:" $packages
    done

    missing=""
    for package in $packages; do
        state=$(dpkg-query -W -f='${db:Status-Status}\n' "$package" 2>/dev/null | head -n 1) || true
        [ "$state" = installed ] || missing="$missing $package"
    done
    missing=${missing# }

    if [ -z "$missing" ]; then
        say "everything is there"
        exit 0
    fi
    [ "$(id -u)" = 0 ] || fail "not root; install the missing packages with:" \
        "apt-get install --no-install-recommends $missing"

    export DEBIAN_FRONTEND=noninteractive
    log=$(mktemp)
    trap 'rm -f "$log"' EXIT
    trap 'exit 1' INT TERM HUP
    step "reading the package lists" apt-get -o DPkg::Lock::Timeout=900 -q update
    step "installing $missing" \
        apt-get -o DPkg::Lock::Timeout=900 -q -y --no-install-recommends install $missing
    say "done"
}
