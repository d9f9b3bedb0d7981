# shellcheck shell=sh
# What the commands in this folder share: install what is missing, build, say
# little. A command sets $root and reads this file. POSIX sh, and only programs
# that a minimal Debian has.
#
# There are two ways to build.
#   debian  GHC and the libraries are Debian's or Ubuntu's packages, and the
#           Cabal library that comes with GHC does the rest (Setup.hs). Stack
#           could do this too, but it is 12 to 14 MB more to download, 65 to
#           86 MB more on disk, wants a HOME, refuses folders of other users and
#           compiles everything twice, for static and for shared linking.
#   stack   Everywhere else: stack.yaml names the compiler and the libraries.

build=$root/.build
log=$build/log
ghc=/usr/bin/ghc

# Not every command needs it.
# shellcheck disable=SC2034
program_packages='ghc libghc-async-dev libghc-conduit-dev
  libghc-cryptohash-sha256-dev libghc-juicypixels-dev libghc-libyaml-dev
  libghc-optparse-applicative-dev libghc-primitive-dev libghc-terminal-size-dev
  libghc-vector-dev'
test_packages='hspec-discover libghc-hspec-core-dev libghc-hspec-dev
  libghc-quickcheck2-dev libghc-temporary-dev
  libghc-zlib-dev'
bench_packages='libghc-criterion-dev'

# All talk goes to standard error: standard output may be a picture's.
say() {
  printf '%s\n' "blackhole: $*" >&2
}

fail() {
  say "$*"
  exit 1
}

# On a bare machine no locale is set, and GHC's programs then stop at the first
# letter outside ASCII that they read or print. macOS has no C.UTF-8.
use_utf8() {
  [ "$(uname -s)" = Darwin ] || export LC_ALL=C.UTF-8
}

# state FILE FOLDER…: a line for the machine, one for the compiler, and one for
# every source file in the folders. Contents are compared, not times: that costs
# the same few milliseconds, while times mislead after a checkout or a copy and
# say nothing of a deleted file.
#
# The program outlives a compiler that was removed: then the compiler's line is
# taken from FILE, an earlier state.
state() (
  earlier=$1
  shift
  ID='' VERSION_ID=''
  # shellcheck source=/dev/null
  [ ! -r /etc/os-release ] || . /etc/os-release
  printf 'machine: %s %s %s\n' "$ID" "$VERSION_ID" "$(uname -m)"
  if [ -e "$ghc" ]; then
    stat -Lc 'compiler: %s %Y' "$ghc"
  elif [ -r "$earlier" ]; then
    sed -n 2p "$earlier"
  fi
  cd "$root" || exit
  find "$@" blackhole.cabal stack.yaml -type f \
    \( -name '*.hs' -o -name blackhole.cabal -o -name stack.yaml \) \
    -exec cksum {} + 2>/dev/null | LC_ALL=C sort
)

program_state() {
  state "$build/bin/state" app src backend
}

up_to_date() {
  [ -x "$build/bin/blackhole" ] && [ -r "$build/bin/state" ] &&
    [ "$(program_state)" = "$(cat "$build/bin/state")" ]
}

# One build at a time. The kernel frees the lock of a process that was killed.
lock() {
  # In a subshell, for a redirection that fails may end the shell.
  (mkdir -p "$build/bin" && : >>"$build/lock" && : >>"$log") 2>/dev/null ||
    fail "cannot write to $build, so nothing can be built there"
  # Where there is no flock (macOS), two first calls at once are not kept apart.
  command -v flock >/dev/null || return 0
  exec 9>>"$build/lock"
  flock -n 9 || {
    say "waiting for another build in $root"
    flock 9
  }
}

# A program started later would otherwise hold the lock for as long as it runs.
unlock() {
  exec 9>&-
}

# missing_packages LIST: those of the list that are not installed.
missing_packages() {
  # shellcheck disable=SC2016,SC2086
  installed=$(dpkg-query -W -f ' ${db:Status-Status}=${Package} ' $1 2>/dev/null) || :
  for package in $1; do
    case $installed in
      *" installed=$package "*) ;;
      *) printf '%s ' "$package" ;;
    esac
  done
}

# Whether this user can act as root, and how: $as_root.
can_be_root() {
  as_root=
  [ "$(id -u)" != 0 ] || return 0
  as_root=sudo
  command -v sudo >/dev/null || return 1
  if [ -t 0 ] && [ -t 2 ]; then
    say 'root is needed to install packages; asking sudo'
    sudo -v
  else
    sudo -n true 2>/dev/null
  fi
}

apt_get() {
  $as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get -o DPkg::Lock::Timeout=600 -y "$@" </dev/null >>"$log" 2>&1
}

# Ubuntu 22.04 and Debian 11 have GHC 8.8, which is too old for the sources.
apt_has_recent_ghc() {
  version=$(apt-cache policy ghc | sed -n 's/^  Candidate: //p')
  dpkg --compare-versions "$version" ge 9.0 2>/dev/null
}

# prepare LIST: install what is missing of the listed packages, or see that Stack
# is there. Sets $way to the way to build.
prepare() {
  : >"$log"
  way=debian missing=
  if command -v apt-get >/dev/null && command -v dpkg-query >/dev/null; then
    missing=$(missing_packages "$1")
    missing=${missing% }
    [ -n "$missing" ] || return 0
    if can_be_root; then
      # Without a network, what lies in apt's cache can still be installed.
      apt_get update || :
      if apt_has_recent_ghc; then
        case $missing in
          'ghc '*) say "installing with apt (about 140 MB to download): $missing" ;;
          *) say "installing with apt: $missing" ;;
        esac
        # shellcheck disable=SC2086
        apt_get install --no-install-recommends $missing || {
          tail -n 20 "$log" >&2
          fail "apt could not install them; full log: $log"
        }
        return 0
      fi
    fi
  fi
  way=stack
  command -v stack >/dev/null && return 0
  if [ -n "$missing" ]; then
    say "GHC or its libraries are missing. On Debian 12 or Ubuntu 24.04 or later, as root:
  apt-get update && apt-get install --no-install-recommends $missing
Elsewhere, install Stack: https://docs.haskellstack.org. Then run this again."
  else
    say "Stack is missing, which fetches GHC and the libraries. Install it from
  https://docs.haskellstack.org, then run this again."
  fi
  exit 1
}

# install_tool PACKAGE: true if the program of that name is there in the end.
install_tool() {
  command -v "$1" >/dev/null && return 0
  command -v apt-get >/dev/null && can_be_root || return 1
  say "installing with apt: $1"
  apt_get install --no-install-recommends "$1" || {
    apt_get update && apt_get install --no-install-recommends "$1"
  }
}

# forget_old_objects FOLDER: GHC before 9.4 goes by times, so that a module that
# changed but is older than its object file would be left as it was. Start afresh
# if such a file is among those that changed since the last try, or if the
# machine or the compiler changed (their lines name no file).
forget_old_objects() {
  [ -f "$1.state" ] || : >"$1.state"
  state "$1.state" app src backend test bench >"$1.new"
  old=$(
    cd "$root" || exit
    LC_ALL=C grep -vxF -f "$1.state" "$1.new" | sed 's/^[0-9]* [0-9]* //' |
      while IFS= read -r changed; do
        [ -n "$(find "$changed" -newer "$1.state" 2>/dev/null)" ] || echo "$changed"
      done
  )
  [ -z "$old" ] || rm -rf "$1"
  mv "$1.new" "$1.state"
}

setup() (
  cd "$root" || exit
  # Debian's libraries do not mix with those that a user's environment names.
  unset GHC_PACKAGE_PATH
  GHC_ENVIRONMENT=- LC_ALL=C.UTF-8 /usr/bin/runghc script/Setup.hs "$@"
)

# The two ways to build take the flag dev or nothing, and Cabal's names of what
# to build. They set $products, the folder in which Cabal puts each of them.
# Warnings are the same without optimisation, and the dev build is not for use.
debian_build() {
  objects=.build/main
  options=
  if [ "$1" = dev ]; then
    objects=.build/dev
    options='-fdev --ghc-options=-O0'
  fi
  shift
  # What can be configured is. And --ipid keeps the library's name, which
  # otherwise depends on this: a test run must not undo a plain one's work.
  [ -n "$(missing_packages "$test_packages")" ] || options="$options --enable-tests"
  [ -n "$(missing_packages "$bench_packages")" ] || options="$options --enable-benchmarks"
  jobs=$(getconf _NPROCESSORS_ONLN)
  forget_old_objects "$root/$objects"
  products=$root/$objects/build
  # hspec-discover lists the specs when test/Spec.hs is compiled, which GHC has to
  # be made to do again after one came or went.
  [ -z "$(find "$root/test" -type d -newer "$products/spec/spec-tmp/Spec.o" 2>/dev/null)" ] ||
    rm -f "$products/spec/spec-tmp/Spec.o"
  # shellcheck disable=SC2086
  setup configure --builddir="$objects" --global --ipid=blackhole \
    --with-compiler="$ghc" --with-hc-pkg="$ghc-pkg" \
    --disable-shared --disable-library-profiling -f-massiv $options &&
    setup build --builddir="$objects" -j"$jobs" "$@"
  built=$?
  # What was edited while the compiler ran is older than this.
  touch "$root/$objects.state"
  return "$built"
}

stack_build() {
  if [ "$1" = dev ]; then
    options='--work-dir .build/stack --test --bench --flag blackhole:dev --ghc-options=-O0'
  else
    options=
  fi
  shift
  for target; do
    set -- "$@" "blackhole:$target"
    shift
  done
  # shellcheck disable=SC2086
  (
    cd "$root" || exit
    stack build $options --no-run-tests --no-run-benchmarks "$@"
  ) && products=$root/$(cd "$root" && stack path --dist-dir)/build
}

# build_or_fail FLAG TARGET…
build_or_fail() {
  "${way}_build" "$@" >"$log" 2>&1 && return 0
  # From the first error on, less the progress: warnings go before it.
  sed -n '/[Ee]rror:/,$p' "$log" | grep -v '^\[ *[0-9]* of ' >&2 || tail -n 40 "$log" >&2
  ! grep -q 'missing-home-modules' "$log" ||
    say 'blackhole.cabal lacks a module: script/lint --fix writes it anew'
  fail "the build failed; full log: $log"
}

# build_program TARGET…: build the targets, exe:blackhole among them, and put the
# program in its place. Call it with the lock.
build_program() {
  sources=$(program_state)
  if [ -x "$build/bin/blackhole" ]; then
    say 'building'
  elif [ "$way" = stack ]; then
    say "building (the first time, Stack may fetch GHC and the libraries: half an hour; see $log)"
  else
    say 'building (the first time takes about 2 minutes)'
  fi
  build_or_fail '' "$@"
  # One step from the old program to the new: somebody may be starting it.
  cp "$products/blackhole/blackhole" "$build/bin/new"
  rm -f "$build/bin/state"
  mv "$build/bin/new" "$build/bin/blackhole"
  printf '%s\n' "$sources" >"$build/bin/new"
  mv "$build/bin/new" "$build/bin/state"
}
