# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Sourced by run.sh and test.sh: functions that bring a Debian 12 machine to a built program.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build/release
packages=(
  g++ cmake ninja-build ccache git ca-certificates
  libdeal.ii-dev         # deal.II with MPI, Trilinos and all the rest
  libopenblas0-pthread   # the reference BLAS makes direct solvers several times slower
  numdiff                # compares the outputs of the tests
)

# mpiexec refuses root, as in containers, unless told twice; without ssh it complains.
if [[ $EUID -eq 0 ]]; then
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
fi
command -v ssh >/dev/null || export OMPI_MCA_plm_rsh_agent=

say() { echo "==> $*" >&2; }

die() {
  echo "error: $*" >&2
  exit 1
}

is_installed() { dpkg-query -W -f '${Status}' "$1" 2>/dev/null | grep -q 'ok installed'; }

install_missing() {
  command -v dpkg-query >/dev/null || die "this is no Debian system: install ${packages[*]} yourself"
  local missing=() package
  for package in "${packages[@]}"; do
    is_installed "$package" || missing+=("$package")
  done
  [[ ${#missing[@]} -eq 0 ]] && return
  local as_root=()
  if [[ $EUID -ne 0 ]]; then
    command -v sudo >/dev/null || die "there is no sudo: as root, install ${missing[*]}"
    as_root=(sudo)
  fi
  say "installing with apt: ${missing[*]}"
  "${as_root[@]}" apt-get update -q >&2 || die "apt-get update failed (is there a network?)"
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -q -y --no-install-recommends "${missing[@]}" >&2 ||
    die "apt-get could not install ${missing[*]}"
}

configure() {
  say "configuring in $build"
  (cd "$root" && cmake --preset release) >"$build/configure.log" 2>&1 ||
    { cat "$build/configure.log" >&2; die "the configuration failed"; }
}

# build_targets TARGET...
build_targets() {
  say "building $*"
  cmake --build "$build" --target "$@" >&2 || die "the build failed"
}

# Install, configure and build.
prepare() {
  install_missing
  mkdir -p "$build"
  configure
  build_targets "$@"
}
