#!/bin/sh
# Installs what is missing, builds, and writes the frames of all walkthroughs to out/, with pages to step through them.
# Options are passed on to `gjkstep render`: ./walkthroughs/run.sh --size 1920x1080
set -eu
cd "$(dirname "$(readlink -f "$0")")/.."
. walkthroughs/setup.sh

require_packages $program_packages
build build gjkstep
exec build/gjkstep render --all --strip --page "$@"
