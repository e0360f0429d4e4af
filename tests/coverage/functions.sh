#!/bin/sh
# Lists the public functions of the mathematics that no property test (tests/property) and no
# exhaustive test (tests/accuracy/exhaustive_scalars) calls, and those that tests/portability/mathematics.c does
# not call. usage: functions.sh [DIRECTORY]
# DIRECTORY holds include/ and tests/ (default: this repository). All headers count except those of
# drawing and of the version. The unit test of the inline vectors of shaders must call each of them.
# Ends with "functions: N called by a property or an exhaustive test, N not". Exit status 1 if a
# function is not called.
set -eu
cd "${1:-$(dirname "$0")/../..}"
headers=$(ls include/gnomon/*.h | grep -v -E \
    '/(api|backend|blit|derivatives|draw|parallel|pipeline|lookup|program|shaders|status|surface|texture|version)\.h$')

test -e include/gnomon/shader_vectors.h && sed -nE 's/^static inline .*(gn_[a-z0-9_]+)\(.*/\1/p' \
    include/gnomon/shader_vectors.h | while read -r inline; do
    grep -qw "$inline" tests/unit/test_shader_vectors.c ||
        { echo "include/gnomon/shader_vectors.h: $inline: not in tests/unit/test_shader_vectors.c"; exit 1; }
done

# Every machine calls each function (tests/portability/cross.sh).
sed -nE 's/^(GN_API|static inline) .*[ *](gn_[a-z0-9_]+)\(.*/\2/p' \
    $(echo "$headers" | grep -v -E '/shader_(types|loop|functions)\.h$') | grep -v '_$' | sort -u | while read -r function; do
    grep -q -w "$function" tests/portability/mathematics.c ||
        { echo "$function: not in tests/portability/mathematics.c"; exit 1; }
done

# Comments and strings are removed first, because a name in them is not a call. Tables of functions
# use names without a parenthesis, so any use of a name counts.
awk '
FNR == 1 { header = FILENAME ~ /^include\// }
{
    gsub(/"([^"\\]|\\.)*"/, "")
    if (commented) {
        if (!match($0, /\*\//)) next
        $0 = substr($0, RSTART + 2)
        commented = 0
    }
    while (match($0, /\/\*/)) {
        before = substr($0, 1, RSTART - 1)
        rest = substr($0, RSTART + 2)
        if (!match(rest, /\*\//)) { $0 = before; commented = 1; break }
        $0 = before " " substr(rest, RSTART + 2)
    }
    if (header) {
        if ($0 ~ /^GN_API /) { declared = 1 }
        if (declared && match($0, /gn_[a-z0-9_]+\(/)) {
            functions[++count] = substr($0, RSTART, RLENGTH - 1)
            where[count] = FILENAME
            declared = 0
        }
        next
    }
    while (match($0, /gn_[a-z0-9_]+/)) {
        used[substr($0, RSTART, RLENGTH)] = 1
        $0 = substr($0, RSTART + RLENGTH)
    }
}
END {
    for (i = 1; i <= count; ++i)
        if (!(functions[i] in used)) { ++missing; print where[i] ": " functions[i] }
    printf "functions: %d called by a property or an exhaustive test, %d not\n", count - missing, missing
    exit missing > 0 || count == 0
}' $headers tests/property/*.c tests/property/*.h tests/accuracy/exhaustive_scalars/*.c
