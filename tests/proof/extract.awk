# Prints the statements of one kernel of a C file as definitions for Gappa.
#   awk -f extract.awk -v kernel=NAME -v rounding=ROUNDING FILE.c
# A kernel is between the lines "/* Kernel: NAME. */" and "/* End of kernel. */". It consists of
# statements `const float NAME = EXPRESSION;` (or float4, where one lane stands for all); anything
# else is an error. a.x becomes ax, c[0] becomes c0. ROUNDING is an operator of Gappa's, applied to
# every operation, or `model`: operation number k is then exact except for a factor 1 + ek, the
# standard model of floating-point arithmetic (only for float4 kernels, whose operations are
# calls). Exit status 1 if there is no such kernel.

function fail(why) { print FILENAME ": kernel " kernel ": " why > "/dev/stderr"; bad = 1; exit 1 }

# Replaces the innermost call NAME(A, B) of a lane operation by <A SIGN B>, with brackets that do
# not hide the next outer call; returns false if there is none.
function rewrite_call(name, sign,   call, comma, arguments) {
    if (!match(text, name "\\([^(),]*,[^(),]*\\)"))
        return 0
    call = substr(text, RSTART, RLENGTH)
    arguments = substr(call, length(name) + 2, length(call) - length(name) - 2)
    comma = index(arguments, ",")
    call = "<" substr(arguments, 1, comma - 1) " " sign substr(arguments, comma + 1) ">"
    if (rounding == "model")
        call = "<" call " * <1 + e" ++operations ">>"
    text = substr(text, 1, RSTART - 1) call substr(text, RSTART + RLENGTH)
    return 1
}

function emit(   name) {
    if (text !~ /^const (float|float4) [a-z_]+ = [^=;]*;$/)
        fail("cannot read '" text "'")
    if (rounding == "model" && text !~ /^const float4/)
        fail("the model is for float4 alone: '" text "'")
    sub(/^const (float|float4) /, "", text)
    name = text
    sub(/ .*/, "", name)
    sub(/^[a-z_]+ = /, "", text)
    while (match(text, /[0-9]f/))
        text = substr(text, 1, RSTART) substr(text, RSTART + 2)
    while (match(text, /[a-z]\.[xyzw]/))
        text = substr(text, 1, RSTART) substr(text, RSTART + 2)
    while (match(text, /\[[0-9]\]/))
        text = substr(text, 1, RSTART - 1) substr(text, RSTART + 1, 1) substr(text, RSTART + 3)
    while (rewrite_call("float4_mul", "*") || rewrite_call("float4_add", "+") || rewrite_call("float4_sub", "-"))
        ;
    gsub(/</, "(", text)
    gsub(/>/, ")", text)
    gsub(/gn_sqrt/, "sqrt", text)
    if (text ~ /[a-z0-9_]\(/ && text !~ /^sqrt\([a-z]*\);$/)
        fail("cannot read the call in '" text "'")
    print name, (rounding == "model" ? "" : rounding) "=", text
    text = ""
}

$0 ~ "/\\* Kernel: " kernel "\\. \\*/" { inside = 1; ++found; next }
/\/\* End of kernel\. \*\// { if (inside && text != "") fail("ends within a statement"); inside = 0 }
inside {
    sub(/^ +/, "")
    text = text (text == "" ? "" : " ") $0
    if (text ~ /;$/)
        emit()
}
END { if (!bad && (found != 1 || inside)) fail("not there exactly once"); exit bad }
