#!/bin/sh
# Installs what is missing, builds, and runs the tests.
#
#     tests/run.sh           unit tests, golden traces and pictures, the command line, a page in a browser
#     tests/run.sh --full    all of these with warnings as errors; under sanitizers on the other Debian; study and judge,
#                            the Debian package on a bare system, disturbed runs
#     tests/run.sh --sanitized   the half of --full that runs on the other Debian, here
#     tests/run.sh --long    what takes hours: benchmarks and peers, compilers and settings, mutants, fuzzers, kills, Slurm,
#                            Firefox
set -eu
cd "$(dirname "$(readlink -f "$0")")/.."
. walkthroughs/setup.sh

[ $# -le 1 ] || { printf '%s: takes one of --full, --sanitized and --long, or nothing\n' "$0" >&2; exit 2; }
tier=${1:-quick}
case $tier in
  quick | --full | --sanitized | --long) ;;
  *) printf "%s: '%s': expected --full, --sanitized, --long or nothing\n" "$0" "$tier" >&2; exit 2 ;;
esac

notes=$(mktemp -d) || stop "cannot make a temporary folder; check that there is space left"
trap 'rm -r "$notes"' EXIT
: >"$notes/phases"
: >"$notes/tests"
failed=
export CTEST_OUTPUT_ON_FAILURE=1

# attempt COMMAND...: runs it; where it fails, what comes after it runs all the same, and the end tells.
attempt() {
  "$@" || failed="$failed
  $*"
}

# timed WORDS COMMAND...: runs it and notes how long it took.
timed() {
  words=$1 start=$(date +%s)
  shift
  "$@"
  printf '%6d s  %s\n' $(($(date +%s) - start)) "$words" 2>/dev/null >>"$notes/phases" ||
    stop "cannot write into $notes: make room there, and run this again"
}

# test_in FOLDER OPTIONS...: runs the tests that were built there; notes which took longest, and which were left out.
test_in() {
  folder=$1
  shift
  # Three at once on two processors: browsers wait more than they work.
  # However slow the machine is, what ends is in time.
  attempt ctest --test-dir "$folder" --parallel 3 --timeout 10000 --output-junit "$PWD/$folder/results.xml" "$@"
  python3 tests/longest.py "$folder/results.xml" >>"$notes/tests"
}

# What took longest, in one table.
tell_times() {
  printf '\nWhat took longest\n'
  cat "$notes/phases"
  sort -rn "$notes/tests" | head -n 12
}

# python3-jsonschema checks traces against their schema: no C++ validator in Debian knows draft 2020-12.
# nodejs runs a program that is judged, and the program that pages carry, where that was made.
unit_packages="catch2 python3 python3-jsonschema nodejs"
# chromium, chromium-driver and python3-selenium: a page is stepped through; tidy reads its HTML, poppler-utils what is printed.
quick_packages="$unit_packages chromium chromium-driver python3-selenium tidy poppler-utils"

quick() {
  timed "installing" require_packages $program_packages $quick_packages
  timed "compiling" build build quick-tests -DGJKSTEP_TESTS=ON
  timed "running" test_in build --label-exclude "full|long"
}

# libcgal-dev and libgmp-dev find the truth that the study measures against; gnuplot-nox draws its pictures.
# libbenchmark-dev: the benchmarks are compiled. strace lets single calls of the system fail, as on a full disk.
# dpkg-dev and file pack the Debian package; mmdebstrap and python3-yaml try it on a bare system.
full_packages="$quick_packages libgmp-dev libcgal-dev gnuplot-nox libbenchmark-dev strace dpkg-dev file mmdebstrap python3-yaml"

full() {
  timed "installing" require_packages $program_packages $full_packages
  # axe-core looks for what bars readers from pages, by the rules of WCAG. No package of Debian has it.
  npm install --silent --no-save --no-audit --no-fund --prefix build/checked/npm axe-core@4.14.1 ||
    printf 'no axe-core from npm: pages are not tried for barriers\n'
  timed "compiling with warnings as errors" build build/checked all -DGJKSTEP_TESTS=ON -DGJKSTEP_STUDY=ON -DCMAKE_COMPILE_WARNING_AS_ERROR=ON
  timed "running" test_in build/checked --label-exclude long
  timed "under sanitizers on the other Debian" sanitized_elsewhere
}

# Compiling once tells both whether it compiles there and what goes wrong unseen. Where there is no other Debian, here.
sanitized_elsewhere() {
  code=0
  python3 tests/package/other_debian.py "$native_packages $unit_packages" --sanitized || code=$?
  case $code in
    0) ;;
    77) sanitized ;;
    *) failed="$failed
  tests/run.sh --sanitized, on the other Debian" ;;
  esac
}

sanitized() {
  timed "installing" require_packages $native_packages $unit_packages
  # Without the study, which runs nothing that others get, and without what Clang makes for pages, which has no sanitizers.
  timed "compiling with sanitizers" \
    build build/sanitized all -DGJKSTEP_TESTS=ON -DGJKSTEP_SANITIZE=ON -DGJKSTEP_LIVE=OFF
  # Mesa and LLVM keep some memory until the process ends; those leaks are left out by name. Where threads keep what a library loaded
  # later is guessed from calls, wrongly for Mesa's: the search for leaks then reads what is not there.
  export LSAN_OPTIONS="suppressions=$PWD/tests/lsan.supp:print_suppressions=0:intercept_tls_get_addr=0"
  # But for what runs the same code many times.
  timed "running with sanitizers" \
    test_in build/sanitized --label-exclude long --exclude-regex 'what takes long|console: (others|judge)$'
  unset LSAN_OPTIONS
}

long() {
  timed "installing" require_packages $program_packages $full_packages clang libccd-dev libfcl-dev libbullet-dev firefox-esr \
    slurm-wlm munge
  timed "compiling" build build/long all -DGJKSTEP_TESTS=ON -DGJKSTEP_STUDY=ON -DGJKSTEP_PEERS=ON
  build/long/gjkstep-bench --benchmark_min_time=0.05
  timed "peers" build/long/gjkstep-peers >build/long/peers.csv
  python3 tests/bench/peers/report.py build/long/peers.csv
  timed "compilers and settings of drawing" tests/determinism.sh
  timed "compilers and settings of answers" tests/same_answers/same_answers.sh
  timed "running" test_in build/long --label-regex long
  timed "tests/run.sh on the other Debian" attempt python3 tests/package/other_debian.py \
    "$native_packages $(live_packages $((25 - debian))) $quick_packages"
  timed "compiling fuzzers" build build/fuzz fuzzers -DGJKSTEP_FUZZ=ON -DCMAKE_CXX_COMPILER=clang++
  timed "fuzzers" test_in build/fuzz --tests-regex "^fuzz"
  timed "mutants" attempt python3 tests/mutants/mutate.py --made 20 --seed 1
  timed "kills" attempt python3 tests/disturbed/kill_test.py --program build/long/gjkstep --study build/long/gjkstep-study --kills 1000
}

case $tier in
  quick) what="unit tests, golden traces and pictures, the command line, a page in a browser" time="five minutes at first, one later" ;;
  --full) what="all tests, also under sanitizers on the other Debian; study, judge and package" time="45 minutes" ;;
  --sanitized) what="unit tests, golden traces and pictures and the command line, under sanitizers" time="20 minutes" ;;
  --long) what="benchmarks, peers, compilers and settings, mutants, fuzzers, kills, Slurm, Firefox" time=hours ;;
esac
printf '%s: %s; on two processors that takes %s\n' "$0" "$what" "$time"
"${tier#--}"
tell_times
[ -z "$failed" ] || stop "failed:$failed"
