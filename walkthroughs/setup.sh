# Sourced by walkthroughs/run.sh and tests/run.sh from the top of the project: installs what is missing, and builds.
# shellcheck shell=sh

# libosmesa6-dev and libegl-dev are two ways to draw; libegl-mesa0 is what EGL draws with when the program runs.
# libboost-dev: exact fractions; libsimdjson-dev: its lines, at full speed.
# libcairo2-dev: sheets as PDF and frames as SVG, from the library that most programs of Debian print with.
# libminizip-dev: pages and pictures in one file for --zip.
# libfribidi-dev: titles and names in Hebrew and Arabic run from right to left.
# clang, lld, libc++ and wasi-libc: the program that runs in pages; binaryen makes it smaller.
native_packages="cmake g++ ninja-build pkg-config libeigen3-dev libosmesa6-dev libegl-dev libegl-mesa0 libgl-dev \
libpng-dev libdeflate-dev libfreetype-dev fonts-dejavu-core nlohmann-json3-dev libsimdjson-dev libcli11-dev \
libfribidi-dev libcairo2-dev libminizip-dev libboost-dev"

debian=$(. /etc/os-release && echo "${VERSION_ID:-}")

# What compiles the program in pages on that Debian: live_packages 13.
live_packages() {
  llvm=19
  [ "$1" != 12 ] || llvm=16
  echo "clang-$llvm lld-$llvm wasi-libc libc++-$llvm-dev-wasm32 libc++abi-$llvm-dev-wasm32 libclang-rt-$llvm-dev-wasm32 binaryen"
}

program_packages="$native_packages $(live_packages "$debian")"

stop() {
  printf '%s: %s\n' "$0" "$1" >&2
  exit 1
}

# Prints those of the packages named that are not installed.
missing_packages() {
  for package in "$@"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || printf ' %s' "$package"
  done
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

# Installs the packages named, as far as they are missing, or stops and says what to run.
require_packages() {
  command -v dpkg-query >/dev/null || stop "this is not a Debian system; install the counterparts of these Debian packages, then build with cmake: $*"
  missing=$(missing_packages "$@")
  [ -z "$missing" ] && return
  by_hand="missing packages:$missing
install them with:
  sudo apt-get update && sudo apt-get install --no-install-recommends$missing"
  [ "$(id -u)" -eq 0 ] || command -v sudo >/dev/null || stop "$by_hand"
  printf 'installing%s\n' "$missing"
  as_root apt-get update -qq || stop "apt-get update failed; $by_hand"
  # shellcheck disable=SC2086  # a list of names
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >/dev/null ||
    stop "apt-get install failed; $by_hand"
  missing=$(missing_packages "$@")
  [ -z "$missing" ] || stop "$by_hand"
}

# build FOLDER TARGET [-DOPTION=VALUE ...]: configures what has not been configured so, and builds. Quiet unless it fails.
build() {
  folder=$1 target=$2
  shift 2
  log=$folder/build.log
  mkdir -p "$folder" || stop "cannot make the folder $folder; check that the project's folder may be written to"
  if { cmake -S . -B "$folder" -G Ninja "$@" && cmake --build "$folder" --target "$target"; } >"$log" 2>&1; then
    grep -q 'ninja: no work to do' "$log" || printf 'built %s\n' "$folder"
  elif grep -q 'No space left on device' "$log" || ! echo 2>/dev/null >>"$log"; then
    stop "the disk is full: make room where $PWD/$folder is, and run this again"
  else
    tail -n 50 "$log" >&2
    stop "the build failed, see $log; a folder $folder that was copied here or made by other tools must be removed first: rm -r $folder"
  fi
}
