# Makes VERIFICATION.md from claims.txt and from the last record of every key (assurance.sh).
BEGIN {
    FS = "\t"
    while ((getline line < records) > 0) {
        split(line, field, "\t")
        date[field[1]] = field[2]
        machine[field[1]] = field[4]
        library[field[1]] = field[5]
        verdict[field[1]] = field[6]
        figures[field[1]] = field[7]
    }
    print "# What is verified"
    print ""
    print "Written by `make assurance` from `tests/assurance/claims.txt` and from the last run of every command; do"
    print "not edit. Figures are the last line that the command printed. A star marks figures measured on an older"
    print "text of the library (`include/` and `src/`). \"Not run yet\" stands where no run of the command is"
    print "recorded; `make assurance` runs it."
}

function escaped(s) {
    gsub(/\|/, "\\|", s)
    return s
}

# The mark of a machine: a letter, explained under the tables.
function letter(name) {
    if (!(name in letters)) {
        letters[name] = substr("ABCDEFGHIJKLMNOPQRSTUVWXYZ", ++machines, 1)
        names[machines] = name
    }
    return letters[name]
}

function end_claim(    key, command, last) {
    if (claim == "")
        return
    key = "make " run
    command = "`" key "`"
    if (sub(/^make test \/ /, "test/", key))
        command = "`make test`, step " substr(key, 6)
    last = "not run yet | "
    if (key in figures) {
        last = escaped(figures[key])
        if (verdict[key] != "held")
            last = "**FAILED**: " last
        last = last " | " date[key] " " letter(machine[key]) (library[key] == text ? "" : "\\*")
    }
    if (!table) {
        print ""
        print "| claim | evidence | command | last figures | date, machine |"
        print "|---|---|---|---|---|"
        table = 1
    }
    print "| " escaped(claim) " | " escaped(evidence) " | " command " | " last " |"
    claim = evidence = run = ""
}

function add(value) { # continues the value of the field being read
    if (part == "claim")
        claim = claim (claim == "" ? "" : " ") value
    else if (part == "evidence")
        evidence = evidence (evidence == "" ? "" : " ") value
    else if (part == "run")
        run = value
}

/^# / {
    next
}

/^## / {
    end_claim()
    print ""
    print
    table = 0
    part = ""
    next
}

/^(claim|evidence|run): / {
    if (/^claim/)
        end_claim()
    part = $0
    sub(/:.*/, "", part)
    sub(/^[a-z]*: /, "")
    add($0)
    next
}

/^- / {
    end_claim()
    if (part != "list")
        print ""
    part = "list"
    print
    next
}

/^  / {
    if (part == "list")
        print
    else {
        sub(/^ +/, "")
        add($0)
    }
}

END {
    end_claim()
    print ""
    for (i = 1; i <= machines; i++)
        print "Machine " substr("ABCDEFGHIJKLMNOPQRSTUVWXYZ", i, 1) ": " names[i] "."
}
