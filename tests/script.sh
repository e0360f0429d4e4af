# Sourced by test scripts, in the root of the project: counts of results, skips, a folder for files,
# tools that may be absent, the last line.
. tests/skip.sh
. tests/result.sh
export MAKEFLAGS= # not those of the make that runs the script

# begin NAME [FOLDER]: the script's name in what it prints; $work is FOLDER, emptied, or one that is
# removed in the end.
begin() {
    script=$1
    if [ $# -gt 1 ]; then
        rm -rf "$2"
        mkdir -p "$2"
        work=$(cd "$2" && pwd)
    else
        work=$(mktemp -d)
        trap 'rm -rf "$work"' EXIT
        trap 'exit 1' INT TERM HUP
    fi
}

# need SETUP TOOL...: ends the script as skipped if a tool is absent, which `make SETUP` installs.
need() {
    setup=$1
    shift
    for tool; do
        command -v "$tool" >/dev/null 2>&1 && continue
        skip "$script: $tool is absent: 'make $setup' installs it"
        finish
    done
}

# finish: prints the sums and ends the script.
finish() {
    echo "$script: $passed passed, $failed failed"
    [ "$failed" -eq 0 ]
    exit
}
