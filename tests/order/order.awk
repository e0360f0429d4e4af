# Reads the output of `clang -Xclang -ast-dump` for a C source, and prints the expressions whose
# meaning C leaves to the compiler: C does not order two operands, arguments or initializers, and
# both call functions that may change one thing. The types of a function say what a call may
# change: what its pointers without const lead to, distinguished by their types; anything, if it has
# no parameters. A scene's builder has a source of random numbers. Pointers to void and characters lead to memory of any use and are ignored. Also
# ignored are the compiler's built-in functions, and things that one of the two calls only reads.
# Prints one line per expression of the project: FILE:LINE: what both may change. Exit status 1 if
# there is one.
# usage: clang ... -Xclang -ast-dump SOURCE | awk -f order.awk

# A node's place is given as the difference from the last one given: file and line, line, or column.
function follow_place(text,    part) {
    begin = source ":" line
    if (text !~ /[0-9]:[0-9]/)
        return
    if (text !~ /^[A-Za-z]+ 0x[0-9a-f]+ <col:/)
        begin = ""
    sub(/'.*/, "", text)
    while (match(text, /[^ <,()]+:[0-9]+:[0-9]+/)) {
        split(substr(text, RSTART, RLENGTH), part, ":")
        text = substr(text, RSTART + RLENGTH)
        if (part[1] != "line")
            source = part[1]
        line = part[2]
        if (!begin)
            begin = source ":" line
    }
}

# What a function of this type may change, between bars.
function changeable(type,    parameters, all, count, i) {
    all = "|"
    if (!match(type, /\(\*\)\(/))
        return all
    type = substr(type, RSTART + RLENGTH)
    sub(/\)[^)]*$/, "", type)
    if (type == "void" || type == "")
        return "|anything|"
    count = split(type, parameters, /, */)
    for (i = 1; i <= count; i++)
        if (parameters[i] ~ /\*( *restrict)?$/ && parameters[i] !~ /^(const |(unsigned |signed )?char |void )/)
            all = all parameters[i] "|" (parameters[i] == "builder *" ? "random_source *|" : "")
    return all
}

# Adds to what a node may change; returns what it might change before.
function add(node, all,    types, count, i, both) {
    count = split(all, types, "|")
    for (i = 2; i < count; i++)
        if (index(changes[node], "|" types[i] "|"))
            both = both ", " types[i]
        else
            changes[node] = changes[node] types[i] "|"
    return substr(both, 3)
}

# Ends the innermost node.
function end_node(    both) {
    add(nodes, own[nodes])
    both = nodes > 1 ? add(nodes - 1, changes[nodes]) : ""
    nodes--
    if (both && unordered[nodes] && at[nodes] !~ /^\//) {
        print at[nodes] ": " both
        found = 1
    }
}

# Outside expressions most lines describe names and types; only their places are needed.
!nodes && !/Call|InitList|Subscript|Operator|[0-9]:[0-9]/ { next }

{
    match($0, /^[| `-]*/)
    depth = RLENGTH / 2
    text = substr($0, RLENGTH + 1)
    while (nodes && depths[nodes] >= depth)
        end_node()
    follow_place(text)
}

# The function that a call calls is its first child.
nodes && is_call[nodes] && depth == depths[nodes] + 1 && /\(\*\)\(/ && !/<BuiltinFnToFnPtr>/ {
    is_call[nodes] = 0
    match(text, /'[^']*'/)
    own[nodes] = changeable(substr(text, RSTART, RLENGTH))
}

text ~ /^(CallExpr|InitListExpr|ArraySubscriptExpr|[A-Za-z]*Operator) / {
    depths[++nodes] = depth
    at[nodes] = begin
    changes[nodes] = own[nodes] = "|"
    is_call[nodes] = text ~ /^Call/
    unordered[nodes] = text !~ /^(ConditionalOperator|UnaryOperator)|'(&&|\|\||,)'$/
}

END {
    while (nodes)
        end_node()
    exit found
}
