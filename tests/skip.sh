# Sourced by test scripts: names tests that cannot run here. Under GN_NO_SKIP, as in continuous
# integration, such a test counts as failed.

# skip WHAT: prints one line that says what is not tested, what is absent, and what installs it.
# Adds to `failed` under GN_NO_SKIP. tests/run.sh repeats the line at the end.
skip() {
    echo "skipped: $1"
    [ -z "${GN_NO_SKIP:-}" ] || failed=$((failed + 1))
}
