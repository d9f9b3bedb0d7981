# shellcheck shell=sh
# What the commands in this folder share: install what is missing, build, say
# little. A command sets $root and reads this file. POSIX sh, and only programs
# that a minimal Debian has.
#
# There are three ways to build; prepare takes the first that is possible.
#   debian  GHC and the libraries are Debian's or Ubuntu's packages, and the
#           Cabal library that comes with GHC does the rest (Setup.hs). Stack
#           could do this too, but it is 12 to 14 MB more to download, 65 to
#           86 MB more on disk, wants a HOME, refuses folders of other users and
#           compiles everything twice, for static and for shared linking.
#   cabal   cabal-install and a GHC that the sources suit, from GHCup or a package
#           manager. The libraries come from Hackage.
#   stack   stack.yaml names the compiler and the libraries.

build=$root/.build
log=$build/log
ghc=/usr/bin/ghc

# What the program is built from; not every command needs it.
# shellcheck disable=SC2034
packages_of() {
  sed -n "/^$1:/,/^[^ ]/p" "$root/debian/control" | sed -n -E 's/^ (ghc|libghc-[a-z0-9-]+)[ ,].*/\1/p' | tr '\n' ' '
}
program_packages=$(packages_of Build-Depends)
# The live view's web server is left out until script/blackhole explore asks for it by
# making this file.
explore_mark=$build/explore
[ ! -e "$explore_mark" ] || program_packages="$program_packages $(packages_of Build-Depends-Arch)"
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

# watched COMMAND…: run the command with its output in the log. Meanwhile say what
# the log's last line says and how long it has been: on a terminal in one line that
# changes each second, elsewhere in a new line every four seconds. It goes to the
# descriptor $progress, for a script may keep standard error of its commands.
progress=2
watched() {
  watch & watcher=$!
  "$@" >>"$log" 2>&1 && outcome=0 || outcome=$?
  kill "$watcher" 2>/dev/null || :
  # The shell may announce that the process was killed.
  wait "$watcher" 2>/dev/null || :
  ! on_terminal || printf '\r\033[K' >&"$progress"
  return "$outcome"
}

on_terminal() {
  [ -t "$progress" ] && [ "${TERM:-dumb}" != dumb ]
}

# A process in the background is not reached by Ctrl-C, so this ends when the
# script does. Only the script itself may hold the lock and, for a second longer,
# a pipe.
watch() {
  exec 9>&- 2>&"$progress"
  start=$(date +%s) ticks=0
  while sleep 1 >/dev/null 2>&1 && kill -0 $$ 2>/dev/null; do
    ticks=$((ticks + 1))
    now=$(($(date +%s) - start))
    if on_terminal; then
      columns=$(stty size <&2 2>/dev/null) || columns='24 80'
      columns=${columns#* }
      printf "\r%.$((columns > 1 ? columns - 1 : 79))s\033[K" "blackhole: $now s: $(last_line)" >&2
    elif [ $((ticks % 4)) = 0 ]; then
      say "$now s: $(last_line)"
    fi
  done
}

# The last line of the log. apt reports "dlstatus:FILE:PERCENT:TEXT" and
# "pmstatus:PACKAGE:PERCENT:TEXT"; GHC "[ 37 of 161] Compiling MODULE ( FILE, …"; and
# script/package has another of these scripts' lines in its log.
last_line() {
  tail -c 4000 "$log" | LC_ALL=C tr -cd '\n -~' | awk '
    /(dl|pm)status:[^:]*:[0-9.]+:/ {
      sub(/.*(dl|pm)status:[^:]*:/, "")
      percent = int($0)
      sub(/^[^:]*:/, "")
      $0 = $0 ", " percent " %"
    }
    { sub(/^blackhole: ([0-9]+ s: )?/, "") }
    /\[ *[0-9]+ of [0-9]+\] / { sub(/ \(.*/, "") }
    NF { last = $0 }
    END { print last ? last : "no output yet" }'
}

# On a bare machine no locale is set, and GHC's programs then stop at the first
# letter outside ASCII that they read or print. macOS has no C.UTF-8.
use_utf8() {
  [ "$(uname -s)" = Darwin ] || export LC_ALL=C.UTF-8
}

# state FILE FOLDER…: a line for the machine, one for the compiler, and one for
# every source file and embedded file in the folders. Contents are compared, not times: that costs
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
  [ ! -e "$explore_mark" ] || echo 'with the live view'
  find "$@" blackhole.cabal cabal.project stack.yaml -type f \
    \( -name '*.hs' -o -name '*.c' -o -name '*.bin' -o -name 'page.*' -o -name blackhole.cabal -o -name cabal.project -o -name stack.yaml \) \
    -exec cksum {} + 2>/dev/null | LC_ALL=C sort
)

# with_explore: build the program with the live view from now on.
with_explore() {
  [ -e "$explore_mark" ] || {
    say 'the live view takes a web server, once (9 MB to download)'
    mkdir -p "$build"
    : >"$explore_mark"
    program_packages="$program_packages $(packages_of Build-Depends-Arch)"
  }
}

program_state() {
  state "$build/bin/state" app src backend data
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
  watched ${as_root:+"$as_root"} env DEBIAN_FRONTEND=noninteractive \
    apt-get -o DPkg::Lock::Timeout=600 -o APT::Status-Fd=1 -y "$@" </dev/null
}

# Ubuntu 22.04 and Debian 11 have GHC 8.8, which is too old for the sources.
apt_has_recent_ghc() {
  version=$(apt-cache policy ghc | sed -n 's/^  Candidate: //p')
  dpkg --compare-versions "$version" ge 9.0 2>/dev/null
}

# The versions that package.yaml admits.
has_cabal_and_ghc() {
  command -v cabal >/dev/null && command -v ghc >/dev/null || return 1
  case $(ghc --numeric-version) in
    9.[0-9].* | 9.1[0-2].*) ;;
    *) return 1 ;;
  esac
}

# prepare LIST: install what is missing of the listed packages, or find another way
# to build. Sets $way to it, and $compiler to a command that runs GHC so that it
# finds the libraries.
# shellcheck disable=SC2034
prepare() {
  : >"$log"
  way=debian compiler=$ghc missing=
  if command -v apt-get >/dev/null && command -v dpkg-query >/dev/null; then
    missing=$(missing_packages "$1")
    missing=${missing% }
    [ -n "$missing" ] || return 0
    if can_be_root; then
      say 'asking apt for packages'
      # Without a network, what lies in apt's cache can still be installed.
      apt_get update || :
      if apt_has_recent_ghc; then
        case $missing in
          'ghc '*) say "installing with apt (about 140 MB to download): $missing" ;;
          *) say "installing with apt: $missing" ;;
        esac
        # shellcheck disable=SC2086
        apt_get install --no-install-recommends $missing || {
          grep -v -e 'dlstatus:' -e 'pmstatus:' "$log" | tail -n 20 >&2
          fail "apt could not install them; full log: $log"
        }
        return 0
      fi
    fi
  fi
  if has_cabal_and_ghc; then
    way=cabal compiler="cabal exec --builddir=.build/cabal -- ghc"
    return 0
  fi
  if command -v stack >/dev/null; then
    way=stack compiler='stack ghc --'
    return 0
  fi
  say 'nothing here can build the program.'
  [ -z "$missing" ] || say "On Debian 12 or Ubuntu 24.04 or later, as root:
  apt-get update && apt-get install --no-install-recommends $missing"
  fail 'Install one of these, then run this again:
  GHC (9.0 to 9.12) and cabal    https://www.haskell.org/ghcup
  Stack                          https://docs.haskellstack.org'
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

# forget_old_objects FOLDER: GHC before 9.4 compares times, so it would not recompile a
# module that changed but is older than its object file. Start from scratch
# if such a file is among those that changed since the last try, or if the
# machine or the compiler changed (their lines name no file). The live view takes
# another module of the same name, and the rest stays.
forget_old_objects() {
  [ -f "$1.state" ] || : >"$1.state"
  state "$1.state" app src backend data test bench >"$1.new"
  [ "$(grep -c '^with the' "$1.state")" = "$(grep -c '^with the' "$1.new")" ] ||
    rm -f "$1"/build/BlackHole/Explore/Server.*
  old=$(
    cd "$root" || exit
    LC_ALL=C grep -vxF -f "$1.state" "$1.new" | sed -e '/^with the/d' -e 's/^[0-9]* [0-9]* //' |
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

# The ways to build take the flag dev or nothing, and Cabal's names of what to build, or
# none for everything. They set $products, the folder of the built components.
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
  [ ! -e "$explore_mark" ] || options="$options -fexplore"
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

cabal_build() {
  objects=.build/cabal
  options=
  if [ "$1" = dev ]; then
    objects=.build/cabal-dev
    options='-fdev --ghc-options=-O0'
  fi
  [ ! -e "$explore_mark" ] || options="$options -fexplore"
  shift
  products=$root/$objects/products
  if [ $# = 0 ]; then
    options="$options --enable-tests --enable-benchmarks"
    set -- all
  fi
  case " $* " in *' test:'*) options="$options --enable-tests" ;; esac
  case " $* " in *' bench:'*) options="$options --enable-benchmarks" ;; esac
  # shellcheck disable=SC2086
  (
    use_utf8
    cd "$root" || exit
    # It cannot be resolved before Hackage's index is there.
    cabal build --builddir="$objects" $options --dry-run "$@" || cabal update || exit
    cabal build --builddir="$objects" $options "$@" || exit
    for target; do
      [ "$target" != all ] || continue
      name=${target#*:}
      mkdir -p "$products/$name" &&
        ln -sf "$(cabal list-bin --builddir="$objects" $options "$target")" "$products/$name/$name" || exit
    done
  )
}

stack_build() {
  if [ "$1" = dev ]; then
    options='--work-dir .build/stack --test --bench --flag blackhole:dev --ghc-options=-O0'
  else
    options=
  fi
  [ ! -e "$explore_mark" ] || options="$options --flag blackhole:explore"
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
  : >"$log"
  # The compiler knows nothing of the files that the assembler includes.
  [ -z "$(find "$root/data" -newer "$root/data/embedded.c")" ] || touch "$root/data/embedded.c"
  watched "${way}_build" "$@" && return 0
  # From the first error on, less the progress: warnings go before it.
  sed -n '/[Ee]rror:/,$p' "$log" | grep -v '^\[ *[0-9]* of ' >&2 || tail -n 40 "$log" >&2
  ! grep -q 'missing-home-modules' "$log" ||
    say 'blackhole.cabal lacks a module: script/lint --fix regenerates it'
  fail "the build failed; full log: $log"
}

# build_program TARGET…: build the targets, exe:blackhole among them, and put the
# program in its place. Call it with the lock.
build_program() {
  sources=$(program_state) started=$(date +%s)
  case " $* " in *' test:spec '*) tests=yes ;; *) tests= ;; esac
  if [ -x "$build/bin/blackhole" ] && [ -n "$tests" ] && [ ! -x "$build/bin/spec" ]; then
    say 'building the tests (the first time takes about a minute)'
  elif [ -x "$build/bin/blackhole" ]; then
    say 'building'
  elif [ "$way" != debian ]; then
    say "building with $way (the first time this may fetch and build the libraries: half an hour)"
  else
    say 'building (the first time takes about 2 minutes)'
  fi
  build_or_fail '' "$@"
  say "built in $(($(date +%s) - started)) s"
  # In one step, because the old program may be starting at this moment.
  cp "$products/blackhole/blackhole" "$build/bin/new"
  rm -f "$build/bin/state"
  mv "$build/bin/new" "$build/bin/blackhole"
  printf '%s\n' "$sources" >"$build/bin/new"
  mv "$build/bin/new" "$build/bin/state"
}

# compile_script NAME PACKAGES: compile script/NAME.hs with the library's modules to
# $build/NAME/run, after installing the packages, and change to the project's folder.
compile_script() {
  lock
  prepare "$2"
  use_utf8
  mkdir -p "$build/$1"
  cd "$root" || exit
  # shellcheck disable=SC2086
  watched $compiler -O1 -threaded -isrc -ibackend/vector -outputdir "$build/$1" \
    data/embedded.c src/BlackHole/Image/Exhaustion.c "script/$1.hs" -o "$build/$1/run" || {
    cat "$log" >&2
    fail "script/$1.hs cannot be compiled"
  }
  unlock
}
