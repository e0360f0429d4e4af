# Doxygen's input filter for the public headers: turns their plain comments into ones that Doxygen
# reads. Every line keeps its number.
#
#   first comment of a file      describes the file
#   comment before a declaration describes it, and the declarations below it up to a blank line
#   function after a blank line  takes the comment of an earlier one if their names differ only in
#                                digits: gn_add2, gn_add3
#   comment before a member, or at the end of its line      describes that member
#   member without a comment     is described where the comment of its type names it, or where a row
#                                of the file's first comment begins with it (`.name` or `name`)
#   line indented by two spaces or more in a comment        is preformatted, unless it continues an
#                                item of a list ("- ")
#
# usage: awk -v internal=REGEX -v names=FILE -f comments.awk HEADER
#        awk -v internal=REGEX -v list=1 -f comments.awk HEADER...    prints the names that headers declare
# Declarations whose names match `internal` are left out. The names in FILE become links.

BEGIN {
    while (names != "" && (getline name < names) > 0)
        known[name] = 1
}
FNR == 1 && NR > 1 { file() }
FNR == 1 { count = 0; path = FILENAME }
{ line[++count] = $0 }
END { file() }

# The text of comments

# Returns text in which nothing is a command of Doxygen's or of Markdown's, and known names are links.
function prose(text, is_preformatted,    out, word, before) {
    out = before = ""
    while (match(text, /^[A-Za-z0-9_]+/) || match(text, /^./)) {
        word = substr(text, RSTART, RLENGTH)
        text = substr(text, RSTART + RLENGTH)
        if (word in known && before !~ /[.\/]/)
            word = "\\ref " word " \"" word "\""
        else if (word ~ /^[\\@<>#%&*"$]$/)
            word = "\\" word
        else if (word ~ /^_/ && !is_preformatted)
            word = "\\" word
        else if (word ~ /_$/ && !is_preformatted)
            word = substr(word, 1, length(word) - 1) "\\_"
        before = substr(word, length(word))
        out = out word
    }
    return out
}

# Returns a line of a comment. A span of `code` may begin in one line and end in the next.
function sentence(text,    part, n, i, out) {
    n = split(text, part, "`")
    out = ""
    for (i = 1; i <= n; ++i) {
        if (i > 1)
            out = out ((in_code = !in_code) ? "<code>" : "</code>")
        out = out prose(part[i], 0)
    }
    return out
}

# Returns the words of line i of the comment in lines first to last.
function content(i, first, last,    text) {
    text = line[i]
    if (i == first)
        sub(/^.*\/\* ?/, "", text)
    else if (!sub(/^ *\*( |$)/, "", text) && text !~ /^ *\*\/$/)
        sub(/^ +/, "", text)
    if (i == last)
        sub(/ *\*\/.*$/, "", text)
    return text
}

# Rewrites the comment in lines first to last as one for Doxygen that begins with `opening`, behind
# the code that stands before it in its first line.
function comment(first, last, code, opening,    i, text, before, block, item) {
    in_code = block = item = 0
    before = ""
    for (i = first; i <= last; ++i) {
        text = content(i, first, last)
        if (text == "" || (text !~ /^  / && block)) {
            if (block && !goes_on(i, first, last)) {
                out[i - 1] = out[i - 1] "</pre>"
                block = 0
            }
            item = 0
        }
        if (text ~ /^- / && (item || before == "" || before ~ /([:;.]|Then)$/))
            item = 1
        else if (text !~ /^  /)
            item = 0
        if (text == "")
            out[i] = ""
        else if (text ~ /^  / && !item) {
            out[i] = (block ? "" : "<pre>") prose(text, 1)
            block = 1
        } else if (text ~ /^[-+] / && !item)
            out[i] = "&zwnj;" sentence(text)
        else if (match(text, /^[0-9]+\. /))
            out[i] = substr(text, 1, RLENGTH - 2) "\\." sentence(substr(text, RLENGTH))
        else
            out[i] = sentence(text)
        before = text
    }
    if (block)
        out[last] = out[last] "</pre>"
    text = line[last]
    sub(/^.*\*\//, "", text)
    out[first] = code opening " " out[first]
    out[last] = out[last] " */" text
}

# Says whether a preformatted block that has a blank line i goes on behind it.
function goes_on(i, first, last) {
    while (i <= last && content(i, first, last) == "")
        ++i
    return i <= last && content(i, first, last) ~ /^  /
}

function end_of_comment(i) {
    while (i < count && line[i] !~ /\*\//)
        ++i
    return i
}

# Returns the words of a comment in one line, and its rows with a mark before each.
function words(first, last,    i, text) {
    text = ""
    for (i = first; i <= last; ++i)
        text = text "\n" content(i, first, last)
    return text
}

# Declarations

# Line i begins a declaration of `name`, which ends in line `last`. It takes the comment before it.
function declare(name, i, last,    k, doc) {
    if (name ~ /^(gn|GN)_/)
        declared[name] = 1
    if (name ~ internal) {
        for (k = i; k <= last; ++k)
            out[k] = ""
        return
    }
    # Functions of one family share a comment.
    if (!covers && alike(name) in family) {
        covers = 1
        source = family[alike(name)]
    }
    if (covers && source == "") {
        comment(from, to, "", "/**")
        source = name
    } else if (covers && name != source) {
        doc = "\\copydoc " source
        if (line[i] ~ /^#/)
            out[last] = out[last] " /**< " doc " */"
        else
            out[i] = "/** " doc " */ " line[i]
    }
    if (covers && !(alike(name) in family))
        family[alike(name)] = source
}

function alike(name) {
    gsub(/[0-9]/, "", name)
    return name
}

function without_comments(text) {
    gsub(/\/\*([^*]|\*[^\/])*\*\//, "", text)
    sub(/\/\*.*$/, "", text)
    return text
}

# Returns the name that a declaration of a function or of its type gives.
function name_of(text) {
    if (text ~ /^typedef/ && match(text, /\(\*[a-z_0-9]+\)/))
        return substr(text, RSTART + 2, RLENGTH - 3)
    match(text, /[A-Za-z_0-9]+\(/)
    return RSTART ? substr(text, RSTART, RLENGTH - 1) : ""
}

# A function, or another declaration that ends in a semicolon or a body. Returns the line after it.
function declaration(i,    k, text, code, depth) {
    text = ""
    depth = 0
    for (k = i; k <= count; ++k) {
        code = without_comments(line[k])
        text = text code
        if (code ~ /^#/)
            continue
        depth += gsub(/\{/, "{", code) - gsub(/\}/, "}", code)
        if (depth == 0 && code ~ /[;}][ ]*$/)
            break
    }
    declare(name_of(text), i, k)
    return k + 1
}

# Whether the comment of its type, or of the file, describes a member or enumerator.
function where_named(name, type,    text) {
    text = "[^A-Za-z0-9_]" name "([^A-Za-z0-9_]|$)"
    if (type_text ~ text)
        return "See \\ref " type " \"" type "\"."
    if (file_text ~ "\n  +\\.?([a-z_]+, \\.?)*" name "([^A-Za-z0-9_]|$)")
        return "See the table of " path_end() "."
    return ""
}

function path_end(    text) {
    text = path
    sub(/^.*\//, "", text)
    return text
}

# Returns the name that a declarator or an enumerator declares.
function member_name(text) {
    if (match(text, /\(\*[A-Za-z_0-9]+/))
        return substr(text, RSTART + 2, RLENGTH - 2)
    sub(/ *=.*$/, "", text)
    gsub(/\[[^\]]*\]| +$/, "", text)
    return match(text, /[A-Za-z_0-9]+$/) ? substr(text, RSTART) : ""
}

# Returns the members in `code`, each a declaration of its own with its comment. The comment before
# the code describes the first and the comment after it the last, as `described` says.
function members(k, code, type, is_enum, described,    n, part, i, name, doc, base, text) {
    text = without_comments(code)
    if (!is_enum)
        sub(/;.*$/, "", text)
    # Commas in parentheses divide parameters.
    n = text ~ /\(/ ? 1 : split(text, part, /, */)
    if (n == 1)
        part[1] = text
    if (part[n] ~ /^ *$/)
        --n
    base = part[1]
    sub(/[*]*[A-Za-z_0-9]+(\[[^\]]*\])*$/, "", base)
    text = ""
    for (i = 1; i <= n; ++i) {
        name = member_name(part[i])
        doc = ""
        if (is_enum)
            declared[name] = 1
        if (described == "")
            doc = where_named(name, type)
        else if (i != (described == "after" ? n : 1))
            doc = "\\copydoc " type "::" member_name(part[described == "after" ? n : 1])
        if (is_enum && described == "" && doc == "" && !list)
            print path ":" k ": " name " has no comment" > "/dev/stderr"
        text = text (i == 1 ? "" : is_enum ? " " : base) part[i] (is_enum ? (i < n ? "," : "") : ";")
        text = text (doc == "" ? "" : " /**< " doc " */ ")
    }
    return text
}

# A struct or an enum. Returns the line after it.
function type(i,    k, last, name, is_enum, code, before, after, described) {
    match(line[i], /(struct|union|enum) [A-Za-z_0-9]+/)
    name = substr(line[i], RSTART, RLENGTH)
    is_enum = name ~ /^enum/
    sub(/^.* /, "", name)
    type_text = covers && source == "" ? words(from, to) : ""
    declare(name, i, i)
    described = ""
    if (line[i] ~ /\}/) {
        before = code = after = line[i]
        sub(/\{.*$/, "{ ", before)
        sub(/^[^{]*\{ */, "", code)
        sub(/ *\}.*$/, "", code)
        sub(/^.*\}/, " }", after)
        out[i] = before members(i, code, name, is_enum, "") after
        return i + 1
    }
    for (k = i + 1; line[k] !~ /^\}/; ++k) {
        if (line[k] ~ /^ *\/\*/) {
            last = end_of_comment(k)
            described = line[last + 1] == "" ? "" : "before"
            if (described != "")
                comment(k, last, "    ", "/**")
            k = last
        } else if (line[k] != "" && line[k] !~ /^#/) {
            code = line[k]
            if (match(code, /\/\*/)) {
                last = end_of_comment(k)
                code = substr(code, 1, RSTART - 1)
                before = members(k, code, name, is_enum, "after")
                comment(k, last, is_enum ? code : before " ", "/**<")
                k = last
            } else {
                while (line[k] !~ /[;,]$/ && line[k + 1] !~ /^\}/) {
                    out[k] = line[k]
                    code = code line[++k]
                    out[k - 1] = ""
                }
                out[k] = members(k, code, name, is_enum, described) (is_enum && code ~ /, *$/ ? "," : "")
            }
            described = ""
        }
    }
    if (name ~ internal)
        for (; i <= k; ++i)
            out[i] = ""
    return k + 1
}

function macro(i,    last, name) {
    for (last = i; line[last] ~ /\\$/; ++last)
        ;
    name = line[i]
    sub(/^#define +/, "", name)
    sub(/[^A-Za-z0-9_].*$/, "", name)
    if (last == i && line[i] ~ /\/\*.*\*\//)
        sub(/\/\*/, "/**<", out[i])
    declare(name, i, last)
    return last + 1
}

function file(    i, k, has_file_text, spare) {
    covers = has_file_text = 0
    source = file_text = ""
    split("", family)
    for (i = 1; i <= count; ++i)
        out[i] = line[i]
    i = 1
    while (i <= count) {
        if (line[i] ~ /^\/\*/) {
            from = i
            to = end_of_comment(i)
            i = to + 1
            if (!has_file_text) {
                has_file_text = 1
                comment(from, to, "", "/** \\file\n")
                file_text = words(from, to)
                # The line that the file's comment has more is taken from the first blank line.
                for (spare = i; line[spare] != ""; ++spare)
                    ;
            } else {
                covers = line[i] != "" && line[i] !~ /^\/\*/
                source = ""
            }
        } else if (line[i] == "") {
            # What is left out uses up no comment.
            if (source != "" || line[i - 1] ~ /\*\/$/)
                covers = 0
            ++i
        } else if (line[i] ~ /^#define/)
            i = macro(i)
        else if (line[i] ~ /^#/ || line[i] ~ /^GN_(BEGIN|END)/)
            while (line[i++] ~ /\\$/)
                ;
        else if (line[i] ~ /^typedef (struct|union|enum) [A-Za-z_0-9]+ \{/)
            i = type(i)
        else
            i = declaration(i)
    }
    if (list)
        return
    for (i = 1; i <= count; ++i)
        if (i != spare)
            print out[i]
}
END {
    if (list)
        for (name in declared)
            if (name != "" && name !~ internal)
                print name | "sort -u"
}
