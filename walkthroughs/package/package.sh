#!/bin/sh
# Installs what is missing, builds, and packs build/gjkstep_VERSION_ARCHITECTURE.deb: program, headers and CMake package.
set -eu
cd "$(dirname "$(readlink -f "$0")")/../.."
. walkthroughs/setup.sh

require_packages $program_packages dpkg-dev file
build build gjkstep
log=$PWD/build/package.log
(cd build && rm -f gjkstep_*.deb && cpack -G DEB >"$log" 2>&1) || { cat "$log" >&2; stop "cpack failed"; }
printf 'packed %s\n' build/gjkstep_*.deb
