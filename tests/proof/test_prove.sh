#!/bin/sh
# Checks that tests/proof/prove.sh rejects what is wrong: kernels mutated in a copy of the sources,
# and mutated templates. usage: test_prove.sh
set -u
here=$(dirname "$0")
directory=$(mktemp -d)
trap 'rm -rf "$directory"' EXIT
trap 'exit 1' INT TERM HUP
passed=0
failed=0

# rejects WHAT TEMPLATE: the proofs from the files in the directory must fail.
rejects() {
    if "$directory/proof/prove.sh" -q "$directory" "$directory/proof/$2.proof" >"$directory/log" 2>&1 ||
        ! grep -q '^FAILED' "$directory/log"; then
        failed=$((failed + 1))
        echo "FAILED: proved in spite of: $1"
        cat "$directory/log"
    else
        passed=$((passed + 1))
    fi
}

# mutate FILE EXPRESSION: makes fresh copies and changes one of them by sed.
mutate() {
    rm -rf "$directory/src" "$directory/proof"
    mkdir "$directory/src"
    cp -r "$here/../../src/math" "$directory/src/math"
    cp -r "$here" "$directory/proof"
    sed "$2" "$directory/$1" >"$directory/mutated"
    if cmp -s "$directory/mutated" "$directory/$1"; then
        failed=$((failed + 1))
        echo "FAILED: '$2' changes nothing in $1"
    fi
    cp "$directory/mutated" "$directory/$1"
}

kernel_mutant() { mutate "src/math/$1" "$3"; rejects "$1: $3" "$2"; }
template_mutant() { mutate "proof/$1.proof" "$2"; rejects "$1.proof: $2" "$1"; }

kernel_mutant placement.c rodrigues_others 's/tx \* n\.y + sz/tx * n.y - sz/'
kernel_mutant placement.c rodrigues_others 's/ty \* n\.z + sx/ty * n.z + sy/'
kernel_mutant placement.c rodrigues_others 's/sz = s \* n\.z/sz = s/'
kernel_mutant placement.c rodrigues_diagonal 's/t = 1\.0f - c/t = 1.0f + c/'
kernel_mutant placement.c rodrigues_diagonal 's/zz = tz \* n\.z + c/zz = tz * n.y + c/'
kernel_mutant placement.c rodrigues_diagonal 's/yy = ty \* n\.y + c;/yy = ty * n.y;/'
kernel_mutant matrix.c rigid 's/xyz = float4_add(/xyz = float4_sub(/'
kernel_mutant matrix.c rigid 's/xyz = float4_add(xy, .*;/xyz = float4_add(xy, xy);/'
kernel_mutant matrix.c rigid 's/xyz = .*/xyz = float4_mul(float4_add(xy, float4_mul(c[2], spread[2])), c[3]);/'
kernel_mutant matrix.c negation 's/float4_sub(origin, turned)/float4_sub(turned, origin)/'
kernel_mutant inverse.c perspective 's/back_a = others\[0\] \/ a/back_a = others[0] * inverse_a/'
kernel_mutant inverse.c perspective 's/back_d = others\[2\] \/ d/back_d = d \/ others[2]/'
kernel_mutant inverse.c perspective 's/inverse_d = 1\.0f \/ d/inverse_d = -1.0f \/ d/'
kernel_mutant length.c unit 's/y = v\.y \/ length/y = v.x \/ length/'
kernel_mutant length.c unit 's/length = gn_sqrt(square)/length = square/'
kernel_mutant vector.c unit 's/sum = (a\.z \* b\.z + a\.y/sum = (a.z * b.z - a.y/'
kernel_mutant vector.c unit '/Kernel: dot\./d'
kernel_mutant length.c unit 's/const float z = v\.z/float z = v.z/'

# A bound just below the true one, a hypothesis that contradicts another, a rewriting that is not
# an identity, a looser hypothesis.
template_mutant rodrigues_diagonal 's/<= 4b-24/<= 0x3.8p-24/'
template_mutant rodrigues_lengths 's/<= 0x2d.8p-24/<= 0x2c.8p-24/'
template_mutant rodrigues_lengths 's/^@assume |a| <= 1$/@assume a in [2,3]\n@assume a in [0,1]/'
template_mutant rodrigues_angles 's/^@hint mk -> .*/@hint mk -> 0/'
template_mutant rodrigues_angles 's/|v| <= 0x7/|v| <= 0x9/'
template_mutant perspective 's/^@assume |d| .*/@assume |d| in [1b-126,1b127]/'

echo "proofs of what is wrong: $passed rejected, $failed not"
echo "proofs: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
