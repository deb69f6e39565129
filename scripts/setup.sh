# shellcheck shell=bash
# What scripts/demo, scripts/test, scripts/bench and scripts/claims share: packages, configuration,
# build. To be sourced. Callers set -euo pipefail and stand in the repository's root.

readonly PACKAGE_LIST=scripts/packages.txt

say() { printf '%s\n' "$*"; }
fail() {
  printf '%s: %s\n' "${0##*/}" "$*" >&2
  exit 1
}
# Wrong arguments: the reason, how it is called, and status 2.
fail_usage() {
  printf '%s: %s\n\n' "${0##*/}" "$1" >&2
  usage >&2
  exit 2
}

check_preset() {
  case $1 in
    release | dev | asan-ubsan | tsan) ;;
    *) fail_usage "unknown preset '$1'" ;;
  esac
}

child=

# run_child COMMAND...: as in the foreground, yet a signal to this script is acted on at once.
run_child() {
  local status=0
  setpriv --pdeathsig TERM -- "$@" </dev/null &
  child=$!
  wait "$child" || status=$?
  child=
  return "$status"
}

# stop_child: ends what run_child waits for.
stop_child() {
  [[ -n $child ]] || return 0
  kill -TERM "$child" 2>/dev/null || true
  wait "$child" || true
}

# packages_in SECTION...: the packages of these sections, one a line.
packages_in() {
  awk -v wanted=" $* " '
    /^\[/ { inside = index(wanted, " " substr($1, 2, length($1) - 2) " "); next }
    inside && NF && !/^#/ { print $1 }' "$PACKAGE_LIST"
}

# missing_packages SECTION...: those that dpkg does not have as installed.
missing_packages() {
  local installed
  # dpkg-query fails for a package that it never heard of, as on a fresh system.
  # shellcheck disable=SC2046,SC2016
  installed=$({ dpkg-query -W -f '${Package} ${db:Status-Status}\n' $(packages_in "$@") \
    2>/dev/null || true; } | awk '$2 == "installed" { print $1 }')
  grep -vxF -f <(printf '%s\n' "$installed") <(packages_in "$@") || true
}

# install_packages MAY_INSTALL SECTION...: installs what is missing, and says what.
install_packages() {
  local may_install=$1 missing as_root=()
  shift
  if ! command -v dpkg-query >/dev/null; then
    say "set-up: no dpkg here; the libraries of $PACKAGE_LIST must be installed already"
    return
  fi
  mapfile -t missing < <(missing_packages "$@")
  ((${#missing[@]} > 0)) || return 0

  say "set-up: missing packages: ${missing[*]}"
  ((EUID == 0)) || as_root=(sudo)
  local install=("${as_root[@]}" apt-get install -y --no-install-recommends "${missing[@]}")
  [[ $may_install == yes ]] || fail "run this first: ${install[*]}"
  ((EUID == 0)) || command -v sudo >/dev/null || fail "as root, run first: ${install[*]:1}"

  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q
    -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3)
  "${apt[@]}" update </dev/null || fail "apt-get update failed"
  "${apt[@]}" install -y --no-install-recommends "${missing[@]}" </dev/null ||
    fail "could not install: ${missing[*]}"
}

# configure PRESET: once; afterwards the build itself sees changed CMake files.
configure() {
  local preset=$1 build=build/$1
  local cache=$build/CMakeCache.txt
  if [[ -f $build/build.ninja ]] && grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" "$cache"; then
    return
  fi
  say "set-up: configuring build/$preset"
  mkdir -p "$build"
  # --fresh: the folder may hold the rest of a failed start, or have been copied with its tree.
  run_child cmake --fresh --preset "$preset" >"$build/configure.log" 2>&1 || {
    cat "$build/configure.log" >&2
    fail "cmake --preset $preset failed, see above"
  }
}

# build_jobs: one a processor, but no more than memory can bear (1 GB a compiler).
build_jobs() {
  local processors gigabytes
  processors=$(nproc)
  gigabytes=$(awk '/^MemTotal:/ { print int($2 / 1e6) }' /proc/meminfo)
  if ((gigabytes < 1)); then gigabytes=1; fi
  say $((processors < gigabytes ? processors : gigabytes))
}

# build PRESET [TARGET...]: ninja shows one line that advances, or plain lines when piped.
build() {
  local preset=$1
  shift
  NINJA_STATUS='[%f/%t, %es] ' run_child env -C "build/$preset" ninja -j "$(build_jobs)" "$@" ||
    fail "the build of preset $preset failed, see above"
}
