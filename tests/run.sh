#!/bin/sh
# Installs what is missing, builds as users build the program, with warnings as errors, times plain and observed calls, and
# runs all tests.
#
#     tests/run.sh               half an hour on two slow cores the first time, seven minutes when nothing has changed
#     tests/run.sh --sanitize    builds and tests once more, under AddressSanitizer and UBSan: little more than an hour in all
set -eu
cd "$(dirname "$(readlink -f "$0")")/.."
. walkthroughs/setup.sh

sanitize=no
for argument in "$@"; do
  [ "$argument" = --sanitize ] || stop "'$argument': expected --sanitize or nothing"
  sanitize=yes
done

run_tests() {
  ctest --test-dir "$1" --output-on-failure --parallel 2 || stop "tests failed in $1"
}

# chromium: the report of differing pictures is looked at in a real browser; python3-selenium and chromium-driver step through
# pages in it, tidy reads their HTML, poppler-utils what they print; firefox-esr, where it is there, is tried, too.
# python3-jsonschema checks traces against their schema: no C++ validator in Debian knows draft 2020-12.
# libcgal-dev finds the truth that the study measures against; gnuplot-nox draws its pictures.
# libccd-dev, libfcl-dev and libbullet-dev: what gjkstep-peers times the plain call beside.
# strace lets single calls of the system fail, as on a full disk.
# slurm-wlm and munge: a real Slurm of one node runs the study's shards.
# dpkg-dev and file pack the Debian package; mmdebstrap and python3-yaml try it on a bare system (tests/package).
require_packages $program_packages catch2 libbenchmark-dev python3 python3-jsonschema chromium chromium-driver \
  python3-selenium tidy poppler-utils libcgal-dev gnuplot-nox \
  libccd-dev libfcl-dev libbullet-dev strace slurm-wlm munge dpkg-dev file mmdebstrap python3-yaml

build build all -DGJKSTEP_TESTS=ON -DGJKSTEP_WERROR=ON

# axe-core looks for what bars readers from pages, by the rules of WCAG. No package of Debian has it.
npm install --silent --no-save --no-audit --no-fund --prefix build/npm axe-core@4.14.1 ||
  printf 'no axe-core from npm: pages are not tried for barriers\n'
printf '\nPlain and observed calls\n'
build/gjkstep-bench --benchmark_min_time=0.05
run_tests build
[ $sanitize = yes ] || exit 0

build build/sanitized all -DGJKSTEP_TESTS=ON -DGJKSTEP_WERROR=ON -DGJKSTEP_SANITIZE=ON
# Mesa and LLVM keep some memory until the process ends; those leaks are left out by name.
export LSAN_OPTIONS="suppressions=$PWD/tests/lsan.supp:print_suppressions=0"
run_tests build/sanitized

# A sample of what mutate.py does. Survivors are told, not judged: which mutants are made changes with every line of code.
printf '\nDo tests notice mistakes that nobody chose?\n'
python3 tests/mutants/mutate.py --made 3 --fitting --in core || [ $? = 1 ] || stop "mutate.py could not try its mutants"
