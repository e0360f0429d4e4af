# Inserts annotations into a copy of a source. usage: awk -f annotate.awk ANNOTATIONS SOURCE
FNR == NR {
    if (/^@before /) {
        anchor[++count] = substr($0, 9)
        text[count] = ""
    } else if (count && !/^#/)
        text[count] = text[count] $0 "\n"
    next
}
FNR == 1 { at = 1 }
{
    line = $0
    sub(/^[ \t]+/, "", line)
    if (at <= count && index(line, anchor[at]) == 1) {
        printf "%s", text[at]
        at++
    }
    print
}
END {
    if (at <= count) {
        print "annotate: no line begins with: " anchor[at] > "/dev/stderr"
        exit 1
    }
}
