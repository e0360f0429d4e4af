#!/bin/sh
# Installs the Debian packages that `make osmesa-piglit` needs: piglit's programs, 2 GB of which most
# are shaders of tests that are not run, and the header of waffle. Does nothing if both are installed.
set -eu
self=setup-piglit
. "$(dirname "$0")/debian.sh"

install_packages "piglit libwaffle-dev" "$@"
