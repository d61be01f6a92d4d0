#!/bin/bash
# Are proven answers the same however they are compiled? By gcc and by clang, from -O0 to -O3, with and without fused multiply-add,
# and under sanitizers. Prints a line a build and, last, one that stands for all; exit code 1 where two differ or one fails.
#
#   tests/same_answers/same_answers.sh              20,000 rounds of 7 questions each, the builds two at a time: some ten minutes
#   tests/same_answers/same_answers.sh 200 'gcc'    fewer, of the builds whose line has that word
set -u
rounds=${1:-20000}
word=${2:-}
top=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
eigen=$(pkg-config --cflags eigen3) || { echo "same_answers.sh: needs Eigen; apt-get install libeigen3-dev pkg-config" >&2; exit 2; }

builds=()
for compiler in gcc clang; do
  for level in -O0 -O1 -O2 -O3; do
    builds+=("$compiler $level -ffp-contract=off")
    grep -qw fma /proc/cpuinfo && builds+=("$compiler $level -mfma -ffp-contract=fast")
  done
  builds+=("$compiler -O1 -fsanitize=address,undefined -fno-sanitize-recover=undefined -D_GLIBCXX_ASSERTIONS")
done

one() {  # NUMBER BUILD
  local compiler=${2%% *} flags=${2#* } program=$folder/$1
  [ "$compiler" = gcc ] && compiler=g++ || compiler=clang++
  # shellcheck disable=SC2086
  if ! "$compiler" -std=c++20 $flags -I"$top" $eigen "$top/tests/same_answers/answers.cpp" -o "$program" 2> "$program.log"; then
    echo "does not compile: $(grep -m1 error "$program.log")" > "$program.out"
  else
    "$program" "$rounds" > "$program.out" 2> "$program.log" || tail -n 1 "$program.log" >> "$program.out"
    rm -f "$program"
  fi
  printf '%-90s %s\n' "$2" "$(tail -n 1 "$program.out")"
}

number=0
for build in "${builds[@]}"; do
  [[ $build == *"$word"* ]] || continue
  number=$((number + 1))
  one $number "$build" &
  [ $((number % 2)) = 0 ] && wait
done
wait
if [ "$number" -lt 2 ]; then
  echo "tests/same_answers/same_answers.sh $rounds \"$word\": $number builds, nothing to compare; this processor has no fused multiply-add, or no build has that word"
  exit 77
fi
answers=$(cat "$folder"/*.out 2> /dev/null | sort | uniq -c)
if [ "$number" -gt 0 ] && [ "$(wc -l <<< "$answers")" = 1 ] && grep -q separated <<< "$answers"; then
  echo "tests/same_answers/same_answers.sh $rounds${word:+ \"$word\"}: $number builds, one answer: $(cut -c9- <<< "$answers")"
else
  echo "tests/same_answers/same_answers.sh $rounds${word:+ \"$word\"}: the answers of $number builds differ:"
  echo "$answers"
  exit 1
fi
