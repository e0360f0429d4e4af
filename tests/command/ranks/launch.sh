# Functions for tests of several ranks; test scripts source this file from the root of the project,
# after tests/result.sh and tests/skip.sh.

# find_present BUILD WHAT: sets `present` to the engines of MPI that are here and that BUILD has the
# command for; names those that are absent.
find_present() {
    present=
    for engine in openmpi mpich; do
        if command -v "mpirun.$engine" >/dev/null && [ -x "$1/$engine/gnomon" ]; then
            present="$present $engine"
        else
            skip "$2: $engine is absent: 'make setup-mpi' installs it"
        fi
    done
}

# over_ranks ENGINE N COMMAND...: runs N ranks of a command, at most SECONDS_LIMIT (120) seconds; its
# status is then 124. More ranks than processors are allowed, and so is the user root, as which
# containers run.
over_ranks() {
    engine=$1
    ranks=$2
    shift 2
    case $engine in
    openmpi)
        OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 timeout -k 5 "${SECONDS_LIMIT:-120}" \
            mpirun.openmpi --oversubscribe --bind-to none -n "$ranks" "$@" </dev/null
        ;;
    mpich) timeout -k 5 "${SECONDS_LIMIT:-120}" mpirun.mpich -n "$ranks" "$@" </dev/null ;;
    esac
}

# unlike_others ENGINE N ACTION COMMAND...: as over_ranks, but each rank does something before it
# becomes the command; $rank is its number.
unlike_others() {
    with=$1
    count=$2
    action=$3
    shift 3
    # shellcheck disable=SC2016
    over_ranks "$with" "$count" sh -c 'rank=${OMPI_COMM_WORLD_RANK:-$PMI_RANK} action=$1
        shift
        eval "$action"
        exec "$@"' sh "$action" "$@"
}

# ends WORDS COMMAND...: the command must end by itself with a fault that one line names, and leave
# nothing in $work/wrong.
ends() {
    words=$1
    shift
    rm -rf "$work/wrong"
    mkdir "$work/wrong"
    "$@" >"$work/words" 2>&1
    status=$?
    cat "$work/words"
    echo "status $status"
    ls -A "$work/wrong"
    [ $status != 0 ] && [ $status != 124 ] && [ $status != 137 ] && [ -z "$(ls -A "$work/wrong")" ] &&
        [ "$(grep -c -e "$words" "$work/words")" = 1 ]
}
