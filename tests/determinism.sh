#!/bin/sh
# The same pictures, byte for byte: draws under settings that must not matter, and prints what differed. Ends with 1 where
# anything did, and where a setting that Mesa cannot draw with is not refused.
#
#     tests/determinism.sh                     builds with gcc and clang, without and with optimisation, and draws with each
#     tests/determinism.sh --program PROGRAM   the settings only, with a gjkstep that is there already, half as wide and half
#                                              as high: every kind of line, label and surface (ctest does this)
#     tests/determinism.sh --all ...           every walkthrough in place of a choice
#
# PNG files are compared, not pixels: one library encodes all of them, so files that are equal have equal pixels; and the traces
# beside them.
#
# Measured on Debian 12 with Mesa 22.3.6, gcc 12 and clang 14 (nine minutes, most of them to build): all frames and
# traces are the same, byte for byte, in a second run; LP_NUM_THREADS 0, 1, 2, 8; LP_NATIVE_VECTOR_WIDTH 128, 256; addresses
# not randomised; OSMesa, EGL; gcc -O0, -O3; clang -O0, -O3.
# Refused: LP_NATIVE_VECTOR_WIDTH=512, LP_PERF, DRAW_USE_LLVM, GALLIUM_DRIVER=softpipe and =zink.
#
# Not the same is a processor without AVX, to judge by GALLIUM_OVERRIDE_CPU_CAPS=sse2: some pixels by 1 of 255.
set -eu
cd "$(dirname "$(readlink -f "$0")")/.."
. walkthroughs/setup.sh

choice="figure-1 figure-2 figure-4-left figure-5 figure-7 regions/2-simplex-r1-below regions/3-simplex-inside \
regions/1-simplex-r3 vehicle-and-threat/vehicle-hit as-printed-spheres cycle-intersecting"
program='' size=1280x720
while [ $# -gt 0 ]; do
  case $1 in
    --all) choice=--all ;;
    --program) program=$(readlink -f "${2:?'--program needs a path'}") && size=640x360 && shift ;;
    *) stop "'$1': expected --all or --program PROGRAM" ;;
  esac
  shift
done

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
unset GJKSTEP_GL GALLIUM_DRIVER LP_NUM_THREADS LP_NATIVE_VECTOR_WIDTH
failed=0

# outputs COMMAND...: checksums and names of the pictures and traces that it writes.
outputs() {
  rm -rf "$scratch/out"
  # shellcheck disable=SC2086  # a list of names
  "$@" render $choice --strip --page --size $size --out "$scratch/out" >"$scratch/said" 2>&1 ||
    { cat "$scratch/said" >&2; return 1; }
  (cd "$scratch/out" && find . \( -name '*.png' -o -name '*.jsonl' \) -exec sha256sum {} + | sort -k 2)
}

line() { printf '%-30s %7s %7s  %s\n' "$@"; }

# row SETTING COMMAND...: draws, and compares with the reference.
row() {
  setting=$1 verdict=same
  shift
  outputs "$@" >"$scratch/now" || { failed=1 && line "$setting" - - FAILED; return; }
  differ=$(diff "$scratch/now" "$scratch/reference" | awk '/^[<>]/ && !seen[$NF]++ { count++ } END { print count + 0 }')
  [ "$differ" = 0 ] || { verdict=DIFFERENT && failed=1; }
  line "$setting" "$(wc -l <"$scratch/now")" "$differ" "$verdict"
}

# refused SETTING: each backend must say what is wrong in place of drawing.
refused() {
  for backend in osmesa egl; do
    has_backend $backend || continue
    code=0
    env "$1" "$program" --gl $backend --version >/dev/null 2>"$scratch/said" || code=$?
    verdict="refused: $(tail -n 1 "$scratch/said" | sed 's/^gjkstep: //')"
    [ "$code" -eq 4 ] || { verdict="NOT REFUSED, $backend: exit code $code" && failed=1 && break; }
  done
  line "$1" - - "$verdict"
}

has_backend() { "$program" --gl "$1" --version >/dev/null 2>&1; }

# build_with COMPILER LEVEL: sets built.
build_with() {
  built=build/determinism/$1$2
  launcher=
  if command -v ccache >/dev/null; then launcher=-DCMAKE_CXX_COMPILER_LAUNCHER=ccache; fi
  # shellcheck disable=SC2086  # nothing where there is no ccache
  build "$built" gjkstep -DCMAKE_CXX_COMPILER="$1" -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS="$2" $launcher >&2
  built=$PWD/$built/gjkstep
}

with_builds=yes
if [ -n "$program" ]; then with_builds=no; else build_with g++ -O3 && program=$built; fi
outputs "$program" >"$scratch/reference" || stop "$program cannot draw"
[ -s "$scratch/reference" ] || stop "$program draws nothing"

line setting files differ ""
row 'a second run' "$program"
for threads in 0 1 2 8; do row "LP_NUM_THREADS=$threads" env "LP_NUM_THREADS=$threads" "$program"; done
for width in 128 256; do row "LP_NATIVE_VECTOR_WIDTH=$width" env "LP_NATIVE_VECTOR_WIDTH=$width" "$program"; done
if setarch -R true 2>/dev/null; then
  row 'addresses not randomised' setarch -R "$program"
else
  line 'addresses not randomised' - - 'not possible here: setarch -R is not permitted'
fi
for backend in osmesa egl; do
  if has_backend $backend; then
    row "--gl $backend" env GJKSTEP_GL=$backend "$program"
  else
    line "--gl $backend" - - 'not built in'
  fi
done
if [ "$with_builds" = yes ]; then
  build_with g++ -O0 && row 'g++ -O0' "$built"
  for level in -O0 -O3; do
    if command -v clang++ >/dev/null; then
      build_with clang++ $level && row "clang++ $level" "$built"
    else
      line "clang++ $level" - - 'not installed'
    fi
  done
fi
for setting in LP_NATIVE_VECTOR_WIDTH=512 LP_PERF=no_tex DRAW_USE_LLVM=0 GALLIUM_DRIVER=softpipe GALLIUM_DRIVER=zink; do
  refused $setting
done
exit $failed
