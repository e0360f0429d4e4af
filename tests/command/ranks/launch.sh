# Functions for tests of several ranks; test scripts source this file from the root of the project.

# The engines of MPI that `make setup-mpi` installs.
engines='openmpi mpich'

# has_engine ENGINE: whether its launcher is installed.
has_engine() { command -v "mpirun.$1" >/dev/null 2>&1; }

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
            mpirun.openmpi --oversubscribe --bind-to none -n "$ranks" "$@"
        ;;
    mpich) timeout -k 5 "${SECONDS_LIMIT:-120}" mpirun.mpich -n "$ranks" "$@" ;;
    esac
}
