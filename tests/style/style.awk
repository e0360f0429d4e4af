# Writes C files in the project's style, in what clang-format does not do (style.sh).
# awk -v own="HEADERS" -v to=DIRECTORY -f style.awk FILE...: HEADERS are the names of the project's
# own headers, without those of include/. The files are written to the same paths in DIRECTORY.

BEGIN {
    for (n = split(own, name, " "); n > 0; --n) is_own["<" name[n] ">"] = 1
    lvalue = "([A-Za-z_]|[(][*][a-z]+[)])[][A-Za-z0-9_.>-]*"
}

FNR == 1 {
    finish()
    file = FILENAME
    is_public = file ~ /^include\//
    output = to "/" file
    gathering = over = lines = 0
}

# Gathers the first #include lines, since their order matters.
/^# *include / && !is_public { $0 = include_style($0) }
/^# *include / && !over { gathering = 1 }
gathering && (/^# *include / || /^$/) { line[++lines] = $0; next }
gathering { print_includes(); gathering = 0; over = 1 }

{ print increment_style($0) >output }

END { finish() }

function finish() {
    if (gathering) print_includes()
    if (output != "") close(output)
}

# Public headers are included by <>, as users include them; the project's other headers by "".
function include_style(text,    part) {
    split(text, part, " ")
    if (part[2] in is_own) gsub(/[<>]/, "\"", text)
    if (part[2] ~ /^"gnomon[.\/]/) {
        sub(/"/, "<", text)
        sub(/"/, ">", text)
    }
    return text
}

function class_of(text) { return text ~ /<gnomon[.\/]/ ? 2 : text ~ /</ ? 1 : 3 }

# The order: any one header may stand first, since it is the header that the file implements; then
# <> of the system and of libraries, then <gnomon>, then "". Groups in order stay as they are.
function print_includes(    i, c, last, bad, end, seen, begin, first, base, printed) {
    for (end = lines; line[end] == ""; --end) {}
    for (i = 1; i <= end; ++i)
        if (line[i] != "" && seen++) {
            c = class_of(line[i])
            bad = bad || c < last
            last = c
        }
    begin = 1
    if (bad) {
        base = file
        sub(/.*\//, "", base)
        first = line[1]
        gsub(/.*[<"\/]|\.h[>"]/, "", first)
        if (line[2] == "" || index(base, first) == 1) {
            print line[1] >output
            begin = 2
        }
        printed = begin > 1
        last = 0
        for (c = 1; c <= 3; ++c)
            for (i = begin; i <= end; ++i)
                if (line[i] != "" && class_of(line[i]) == c) {
                    if (printed && c != last) print "" >output
                    print line[i] >output
                    printed = 1
                    last = c
                }
    } else
        for (i = 1; i <= end; ++i) print line[i] >output
    for (i = end + 1; i <= lines; ++i) print line[i] >output
}

function count(text, what) { return gsub(what, "", text) }

# Writes ++i if nothing uses the value: in a statement, and in the last part of a `for`.
function increment_style(text,    indent, body, end, head, part, parts, i, changed) {
    if (text !~ /(\+\+|--)[;),]/) return text
    match(text, /^[ \t]*/)
    indent = substr(text, 1, RLENGTH)
    body = substr(text, RLENGTH + 1)
    if (match(body, /(\+\+|--);( *\/\*.*| *\\)?$/)) {
        end = substr(body, RSTART + 2)
        head = substr(body, 1, RSTART - 1)
        if (head !~ /[=?;{}",]/ && head ~ /^[A-Za-z_(]/ && head !~ /^(return|case|default|else)[^A-Za-z0-9_]/ &&
            count(head, "[[]") == count(head, "[]]") && count(head, "[(]") == count(head, "[)]"))
            return indent substr(body, RSTART, 2) head end
        return text
    }
    if (match(body, /\)( \{)?( \/\*.*\*\/)?( *\\)?$/)) {
        end = substr(body, RSTART)
        head = substr(body, 1, RSTART - 1)
        body = ""
        while (i = index(head, "; ")) {
            body = body substr(head, 1, i + 1)
            head = substr(head, i + 2)
        }
        parts = split(head, part, ", ")
        for (i = 1; i <= parts; ++i) {
            if (part[i] ~ "^" lvalue "(\\+\\+|--)$") {
                part[i] = substr(part[i], length(part[i]) - 1) substr(part[i], 1, length(part[i]) - 2)
                changed = 1
            }
            body = body (i > 1 ? ", " : "") part[i]
        }
        if (changed && (body ~ /^for \(/ || body ~ /; / || body == part[1])) return indent body end
    }
    return text
}
