#!/bin/sh
# Runs a command and records its figures, the last line that it prints on stdout, for
# VERIFICATION.md (assurance.sh). The output passes through, and the exit status is the command's.
# A record is one line of RECORDS, with tabs between: key, date, seconds, machine, the hash of the
# library's text, "held" or "FAILED", figures. The key is what the user typed ("make blits"), or
# "test/NAME" for a step of `make test`. The last record of a key counts.
# usage: record.sh RECORDS KEY COMMAND...
#        record.sh --add RECORDS KEY SECONDS held|FAILED FIGURES   (records what has run)
#        record.sh --text [FOLDER...]    (prints the hash of the library's text, include/ and src/)
set -u
cd "$(dirname "$0")/../.." || exit 1

# Comments and empty lines do not count.
text() { # text FOLDER...
    find "$@" -name '*.[ch]' | LC_ALL=C sort | xargs awk '
        {
            kept = ""
            while ($0 != "") {
                at = index($0, inside ? "*/" : "/*")
                if (!inside)
                    kept = kept (at ? substr($0, 1, at - 1) : $0)
                if (!at)
                    break
                $0 = substr($0, at + 2)
                inside = !inside
            }
            sub(/[ \t]+$/, "", kept)
            if (kept != "")
                print kept
        }' | sha256sum | cut -c -12
}

machine() {
    model=$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo 2>/dev/null | head -n 1)
    echo "${model:-$(uname -m)}, $(getconf _NPROCESSORS_ONLN) processors"
}

add() { # add RECORDS KEY SECONDS VERDICT FIGURES
    mkdir -p "$(dirname "$1")"
    figures=$(printf '%s' "$5" | sed 's/\x1b\[[0-9;]*m//g' | tr '\t\r' '  ')
    printf '%s\t%s\t%s\t%s\t%s\t%s\t%s\n' "$2" "$(date +%Y-%m-%d)" "$3" "$(machine)" "$(text include src)" \
        "$4" "$figures" >>"$1"
}

case "${1:-}" in
--text)
    shift
    [ $# -gt 0 ] || set -- include src
    text "$@"
    exit
    ;;
--add)
    shift
    add "$@"
    exit
    ;;
esac
[ $# -ge 3 ] || { sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$0" >&2; exit 2; }
records=$1
key=$2
shift 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
began=$(date +%s)
{
    "$@"
    echo $? >"$work/status"
} | tee "$work/out"
status=$(cat "$work/status")
figures=$(grep -v '^[[:space:]]*$' "$work/out" | tail -n 1)
verdict=held
[ "$status" -eq 0 ] || verdict=FAILED
add "$records" "$key" $(($(date +%s) - began)) $verdict "$figures"
exit "$status"
