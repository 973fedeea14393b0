# SPDX-License-Identifier: Apache-2.0
# The part of ./check --lint: every tracked C++ file is formatted, and clang-tidy has nothing to say.

lint() {
  install_missing "${build_packages[@]}" "${lint_packages[@]}"
  local files
  mapfile -t files < <(git -C "$root" ls-files '*.h' '*.cpp')
  (cd "$root" && clang-format --dry-run -Werror "${files[@]}") || die "clang-format -i on these files would do"
  build release all
  # Generated sources are not ours to lint; headers are seen through the sources that include them.
  mapfile -t files < <(git -C "$root" ls-files '*.cpp')
  (cd "$root" && printf '%s\0' "${files[@]}" |
    xargs -0 -n 4 -P "$(nproc)" clang-tidy -p "$root/build/release" --quiet) || die "clang-tidy found something"
  say "clang-format and clang-tidy: all well"
}
