# Makes a page for Doxygen of a document of the project. Links lead to pages of the site, headings get
# the anchors that they have elsewhere, and names of the library and its headers in `code` become links.
# usage: awk -v path=FILE -v names=FILE -v pages=FILE -f page.awk FILE
# `pages` has a line "PATH ID" for every file that is a page. A picture's link keeps its last part.

BEGIN {
    while ((getline name < names) > 0)
        known[name] = 1
    while ((getline name < pages) > 0) {
        split(name, part, " ")
        page[part[1]] = part[2]
    }
    folder = path
    if (!sub(/\/[^\/]*$/, "/", folder))
        folder = ""
}

# Returns the path of a link from the root of the project.
function from_root(target) {
    target = folder target
    gsub(/\/\.\//, "/", target)
    sub(/^\.\//, "", target)
    while (match(target, /[^\/]+\/\.\.\//))
        target = substr(target, 1, RSTART - 1) substr(target, RSTART + RLENGTH)
    sub(/\/$/, "", target)
    return target
}

# The anchor of a heading: its words in small letters, with hyphens between.
function anchor(text) {
    text = tolower(text)
    gsub(/[^a-z0-9 _-]/, "", text)
    gsub(/ /, "-", text)
    return text
}

function last_part(text) {
    sub(/^.*\//, "", text)
    return text
}

# Returns where a link leads, as Doxygen has it.
function link(target,    hash, file) {
    if (target ~ /^[a-z]+:/)
        return target
    hash = ""
    if (match(target, /#.*$/)) {
        hash = substr(target, RSTART + 1)
        target = substr(target, 1, RSTART - 1)
    }
    file = target == "" ? path : from_root(target)
    if (file ~ /\.(png|svg)$/)
        return last_part(file)
    if (file ~ /^include\/.*\.h$/)
        return "@ref " last_part(file)
    if (!(file in page) && (file "/README.md") in page)
        file = file "/README.md"
    if (!(file in page)) {
        print path ":" FNR ": " target " is no page of the site" > "/dev/stderr"
        bad = 1
    }
    return "@ref " page[file] (hash == "" ? "" : "_" hash)
}

# Doxygen shows no span of `code` in the text of a link.
function linked_code(text, target) {
    if (target !~ /^@ref /)
        return "[" text "](" target ")"
    return "<code>" target " \"" text "\"</code>"
}

# Returns a span of code, as a link if it names something of the library.
function code(text,    name) {
    name = text
    sub(/\(\)$/, "", name)
    if (name in known)
        return linked_code(text, "@ref " name)
    if (text ~ /^(include\/)?(gnomon\/)?[a-z_]+\.h$/ && last_part(text) in known)
        return linked_code(text, "@ref " last_part(text))
    return "`" text "`"
}

# Outside code, links are changed and what Doxygen would take for a command is protected.
function prose(text,    out, target, rest) {
    out = ""
    while (match(text, /\]\([^() ]+\)/)) {
        target = substr(text, RSTART + 2, RLENGTH - 3)
        rest = substr(text, RSTART + RLENGTH)
        out = out protect(substr(text, 1, RSTART - 1)) "](" link(target) ")"
        text = rest
    }
    return out protect(text)
}

function protect(text) {
    gsub(/[@%#]/, "\\\\&", text)
    gsub(/\\\\/, "\\", text)
    return text
}

# Returns a line.
function line_of(text,    part, out, found, rest) {
    out = ""
    # A link around a span of code.
    while (match(text, /\[`[^`]+`\]\([^() ]+\)/)) {
        found = substr(text, RSTART, RLENGTH)
        rest = substr(text, RSTART + RLENGTH)
        out = out spans(substr(text, 1, RSTART - 1))
        split(found, part, "`")
        found = part[3]
        gsub(/^\]\(|\)$/, "", found)
        out = out linked_code(part[2], link(found))
        text = rest
    }
    return out spans(text)
}

function spans(text,    n, part, i, out) {
    n = split(text, part, "`")
    out = ""
    for (i = 1; i <= n; ++i)
        if (i % 2)
            out = out prose(part[i])
        else if (i == n || part[i] == "")
            out = out "`" (i == n ? prose(part[i]) : "`")
        else
            out = out code(part[i])
    return out
}

/^ *```/ {
    fence = !fence
    # Doxygen knows languages by the suffix of their files.
    sub(/```c .*/, "```c")
    sub(/```(sh|text)$/, "```")
    sub(/```python/, "```py")
    print
    next
}
fence { print; next }
/^#+ / {
    match($0, /^#+ /)
    marks = substr($0, 1, RLENGTH)
    title = substr($0, RLENGTH + 1)
    id = page[path]
    if (marks != "# ")
        id = page[path] "_" anchor(title)
    else if (id == "index")
        id = "mainpage"
    gsub(/`/, "", title)
    print marks title " {#" id "}"
    next
}
/^    / && (blank || indented) { print; indented = 1; next }
{
    blank = $0 == ""
    indented = indented && blank
    print line_of($0)
}
END { exit bad }
