# Counts the results of a test script in passed and failed. The script sources this file and has a
# directory $work.

passed=0
failed=0

# result WHAT COMMAND...: runs a command. If it fails, prints WHAT and what the command said, which
# is in $work/said.
result() {
    what=$1
    shift
    if "$@" >"$work/said" 2>&1; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: $what"
        tail -n 40 "$work/said" | sed 's/^/    /'
    fi
}
