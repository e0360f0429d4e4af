# For scripts of tests that source it: what cannot be tested here is named, and fails where
# nothing may be passed over (GN_NO_SKIP), as in continuous integration.

# skip WHAT: one line, which says what is not tested, since what is absent, and what installs it.
# Adds to `failed` under GN_NO_SKIP. tests/run.sh repeats the line at the end.
skip() {
    echo "skipped: $1"
    [ -z "${GN_NO_SKIP:-}" ] || failed=$((failed + 1))
}
