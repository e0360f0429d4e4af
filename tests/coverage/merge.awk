# Adds up what llvm-cov shows of several builds: `llvm-cov show -show-branches=count -show-mcdc
# -show-instantiations=false`, one file for each build. A line, a branch of a place or a condition is
# reached if one build reaches it in one copy of its function.
# usage: awk -v root=DIRECTORY -v list=FILE -f merge.awk SHOWN...
# `list` names the functions that are not wholly reached, with the reason (unreached.txt).
# Prints unreached places without a reason, a table of the folders of src/, and the line of figures.

function folder_of(file) { sub(/^src\//, "", file); sub(/\/.*/, "", file); return file }

# The functions of a source, by the lines on which they begin: layout is .clang-format's.
function read_functions(file,    line, n, name, text) {
    name = "-"
    while ((getline text < (root "/" file)) > 0) {
        ++n
        if (text ~ /^[A-Za-z_].*[A-Za-z0-9_]\(/ && text !~ /;$/ && text !~ /^#/) {
            name = text
            sub(/\(.*/, "", name)
            sub(/.*[^A-Za-z0-9_]/, "", name)
        } else if (text ~ /^GN_[A-Z_]+ .*[a-z0-9_]$/ || text ~ /^static .*[^;]$/ && text !~ /\(/) {
            name = "-"
        }
        source_function[file, n] = name
        source_text[file, n] = text
    }
    close(root "/" file)
}

function place(kind, key) { # remembers a place once, in the order of appearance
    if (!((kind, key) in known)) {
        known[kind, key] = 1
        place_kind[++places] = kind
        place_key[places] = key
        place_file[places] = file
        place_line[places] = here
    }
}

BEGIN {
    while ((getline text < list) > 0) {
        if (text ~ /^#/ || text ~ /^$/) continue
        if (text ~ /^    /) { if (!(entry in reason)) reason[entry] = text; continue }
        split(text, part, " ")
        entry = part[1] SUBSEP part[2]
        entries[++entry_count] = entry
    }
}

/^\/.*:$/ {
    file = substr($0, 1, length($0) - 1)
    is_source = index(file, root "/src/") == 1
    file = substr(file, length(root) + 2)
    # Lanes in the vectors of a processor are no part of the plain form.
    if (file ~ /^src\/lanes\/(lanes_)?registers/) is_source = 0
    if (is_source && !(file in read)) { read[file] = 1; read_functions(file) }
    next
}
!is_source { next }

# llvm-cov counts empty lines in some regions.
/^ *[0-9]+\| *[0-9.]+[kMGTPE]?\| *$/ { next }
/^ *[0-9]+\| *[0-9.]+[kMGTPE]?\|/ {
    split($0, part, "|")
    here = part[1] + 0
    key = file SUBSEP here
    place("line", key)
    if (part[2] + 0 > 0) reached["line", key] = 1
    next
}
/^ *[0-9]+\|/ { next }

/^ *\| *Branch \([0-9]+:[0-9]+\): \[True: / {
    at = $0
    sub(/^[^(]*\(/, "", at)
    sub(/\).*/, "", at)
    here = at + 0
    counts = $0
    sub(/.*\[True: /, "", counts)
    split(counts, part, ", False: ")
    branch("T", part[1])
    branch("F", part[2])
    next
}
function branch(way, count,    key) {
    if (count ~ /^Folded/) return
    key = file SUBSEP at SUBSEP way
    place("branch", key)
    if (count + 0 > 0) reached["branch", key] = 1
}

/MC\/DC Decision Region/ { region = $0; sub(/.*Region /, "", region); here = substr(region, 2) + 0; next }
/C[0-9]+-Pair: / {
    if (/constant folded/) next
    condition = $0
    sub(/-Pair.*/, "", condition)
    sub(/.*C/, "", condition)
    key = file SUBSEP region SUBSEP condition
    place("condition", key)
    if (/-Pair: covered/) reached["condition", key] = 1
}

function share(good, all) { return all ? 100 * good / all : 100 }
function floored(x) { return sprintf("%.1f", int(x * 10) / 10) }

END {
    for (i = 1; i <= places; ++i) {
        kind = place_kind[i]
        f = folder_of(place_file[i])
        if (!(f in folders)) { folders[f] = 1; folder_order[++folder_count] = f }
        ++all[f, kind]
        ++all["total", kind]
        if ((kind, place_key[i]) in reached) {
            ++good[f, kind]
            ++good["total", kind]
            continue
        }
        if (kind == "condition") continue
        entry = place_file[i] SUBSEP source_function[place_file[i], place_line[i]]
        # A branch on a line that is not reached is no place of its own.
        if (kind == "branch" && (("line", place_file[i] SUBSEP place_line[i]) in known) &&
            !(("line", place_file[i] SUBSEP place_line[i]) in reached)) continue
        if (entry in reason) {
            ++named
            used[entry] = 1
            continue
        }
        ++unnamed
        split(place_key[i], part, SUBSEP)
        way = kind == "branch" ? (part[3] == "T" ? " is never true" : " is never false") : ""
        text = source_text[place_file[i], place_line[i]]
        sub(/^ +/, "", text)
        printf "%s:%s: %s: %s\n    %s\n", place_file[i],
            kind == "branch" ? part[2] way : place_line[i] " is not reached", 
            source_function[place_file[i], place_line[i]], "no reason in unreached.txt", text
    }
    for (i = 1; i <= entry_count; ++i)
        if (!(entries[i] in used)) {
            split(entries[i], part, SUBSEP)
            printf "unreached.txt: %s %s: wholly reached\n", part[1], part[2]
            ++stale
        }
    printf "%-12s %15s %15s %15s\n", "src/", "lines", "branches", "MC/DC"
    folder_order[++folder_count] = "total"
    for (i = 1; i <= folder_count; ++i) {
        f = folder_order[i]
        printf "%-12s %6d %6s %% %6d %6s %% %6d %6s %%\n", f,
            all[f, "line"], floored(share(good[f, "line"], all[f, "line"])),
            all[f, "branch"], floored(share(good[f, "branch"], all[f, "branch"])),
            all[f, "condition"], floored(share(good[f, "condition"], all[f, "condition"]))
    }
    lines = share(good["total", "line"], all["total", "line"])
    branches = share(good["total", "branch"], all["total", "branch"])
    conditions = share(good["total", "condition"], all["total", "condition"])
    printf "coverage: lines %s %%, branches %s %%, MC/DC %s %%, %d places unreached, %s\n", floored(lines),
        floored(branches), floored(conditions), named + unnamed,
        unnamed ? unnamed " without a reason" : "each with its reason"
    exit lines < 99 || branches < 95 || unnamed > 0 || stale > 0
}
