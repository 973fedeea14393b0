# SPDX-License-Identifier: Apache-2.0
# Shared by ./run and ./check: installs what is missing and builds a preset. Source it with `root` set to the
# repository's folder. Quiet when all is well.

# What the program is built from, by its names in Debian 12 and 13.
build_packages=(
  build-essential cmake ninja-build pkg-config glslang-tools
  libembree-dev libtbb-dev libvulkan-dev libsdl2-dev libimgui-dev libfreetype-dev
  libgif-dev libopenexr-dev libpng-dev libjpeg-dev libstb-dev libfmt-dev libcli11-dev libgtest-dev libbenchmark-dev
  nlohmann-json3-dev libdraco-dev libmeshoptimizer-dev
)
# What the tests drive besides: a software Vulkan, an X server, a mouse, a video encoder, the gallery's generator, and
# POV-Ray, whose pictures and include files scenes are compared with and read.
test_packages=(mesa-vulkan-drivers xvfb xauth xdotool ffmpeg python3 povray povray-includes)
lint_packages=(clang-format clang-tidy)

say() { printf '%s\n' "$*" >&2; }
die() { say "$0: $*"; exit 1; }

# install_missing PACKAGE…: through apt, as root or with sudo.
install_missing() {
  command -v dpkg-query > /dev/null || return 0  # Not Debian: CMake says what it misses.
  local installed missing=() package
  installed=" $(dpkg-query -W -f '${db:Status-Status}:${Package} ' "$@" 2> /dev/null || true)"
  for package; do
    [[ $installed == *" installed:$package "* ]] || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo > /dev/null || die "these packages are missing, and there is no sudo to install them: ${missing[*]}"
    as_root=(sudo)
  fi
  say "Installing ${missing[*]} …"
  local log
  log=$(mktemp)
  if ! { "${as_root[@]}" apt-get update &&
         "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"; } \
       > "$log" 2>&1; then
    tail -n 20 "$log" >&2
    die "apt-get could not install the packages (all it said is in $log)"
  fi
  rm -f "$log"
}

# build_jobs: as many compilers as there are cores and memory for (the widest kernels take about 1.5 GB each).
build_jobs() {
  local cores memory_kb
  cores=$(nproc)
  memory_kb=$(awk '/^MemAvailable:/ {print $2}' /proc/meminfo)
  local fit=$((memory_kb / 1500000))
  [ "$fit" -ge 1 ] || fit=1
  echo $((cores < fit ? cores : fit))
}

# is_built PRESET TARGET: true if nothing that the build reads is newer than its stamp.
is_built() {
  local stamp="$root/build/$1/.built-$2"
  [ -e "$stamp" ] || return 1
  [ -z "$(find "$root/CMakeLists.txt" "$root/CMakePresets.json" "$root/cmake" "$root/src" "$root/apps" "$root/bench" \
            "$root/tests" "$root/scenes/CMakeLists.txt" "$root/scripts/build.sh" -newer "$stamp" -print -quit)" ]
}

# build PRESET TARGET: does nothing, quickly, where nothing changed since the last time.
build() {
  local preset=$1 target=$2
  is_built "$preset" "$target" && return 0
  local folder="$root/build/$preset" log="$root/build/$preset.log"
  mkdir -p "$folder"
  # Taken before the build starts, so that a file changed meanwhile counts as changed.
  local started
  started=$(mktemp -p "$folder" .started-XXXXXX)
  [ -e "$folder/build.ninja" ] || say "Building $target; the first time takes some minutes …"
  if ! { cmake -S "$root" --preset "$preset" && cmake --build "$folder" --target "$target" -j "$(build_jobs)"; } \
       > "$log" 2>&1; then
    rm -f "$started"
    grep -E -A 8 'error|Error|FAILED' "$log" | head -n 60 >&2 || tail -n 30 "$log" >&2
    die "the build failed (all it said is in $log)"
  fi
  mv "$started" "$folder/.built-$target"
}
