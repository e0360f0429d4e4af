#!/bin/sh
# Installs the Debian packages of two engines of MPI, Open MPI and MPICH. `make mpi` needs one of
# them, the tests both.
# usage: setup-mpi.sh [--help]
set -eu
self=setup-mpi
. "$(dirname "$0")/debian.sh"
install_packages "libopenmpi-dev openmpi-bin libmpich-dev mpich" "$@"
