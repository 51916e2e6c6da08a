#!/usr/bin/env bash
# fresh_machine.sh [--folder FOLDER] [--before COMMAND] [--compiler-cache] test|figures|package
# Runs that command of the README, as it is written there, on a bare Debian 12 with a clone of what is committed: the
# proof that setup.sh names all that is needed. With `package`, apt-get installs what build/release makes there, without
# the sources; the program, its manual page and its completion work. --before runs a command in the clone between
# setup.sh and the README's. With --compiler-cache the next run compiles what a commit has changed, and nothing else.
# Needs root, debootstrap and a mirror of Debian in apt's sources; ends with 77 where no bare Debian can be made. Takes
# up to half an hour and 5 GB in FOLDER (default: a new one in $TMPDIR or /tmp), which it removes. Kept for a month, in
# 5 GB of $XDG_CACHE_HOME/taut or ~/.cache/taut: the bare system, the packages it installs, the system that this very
# setup.sh made of it, with which the next run begins, and what was compiled. A summary of ctest is printed last.
set -euo pipefail

fail() {
  echo "fresh_machine.sh: $*" >&2
  exit 1
}
cannot() {
  echo "fresh_machine.sh: no bare Debian can be made: $*" >&2
  exit 77
}
folder= before= compiler_cache=
while [ $# -gt 1 ]; do
  case $1 in
    --folder) folder=$2 ;;
    --before) before=$2 ;;
    --compiler-cache) compiler_cache=1; shift; continue ;;
    *) break ;;
  esac
  shift 2
done
if [ $# -ne 1 ]; then
  sed -n '2,10s/^# //p' "$0" >&2
  exit 2
fi
preset=$1
source=$(cd "$(dirname "$0")/.." && pwd)
release=bookworm
# Debian's own, and what is there before setup.sh: it clones, and compiles through ccache where that is asked for.
packages=ca-certificates,git,ccache
command=$(sed -En "s|^(\./setup\.sh && cmake --workflow --preset $preset)( .*)?\$|\1|p" "$source/README.md")
[ -n "$command" ] || [ "$preset" = package ] || fail "README.md has no command for '$preset'; expected test, figures or package"

[ "$(id -u)" -eq 0 ] || cannot "this user is not root, who alone makes file systems to change into"
command -v debootstrap >/dev/null || cannot "there is no debootstrap"
unshare --mount --pid --fork true 2>/dev/null || cannot "the system refuses to keep mounts and processes apart"
# The sources of apt on this machine: a line each for the release, its updates and its security.
sources=$(apt-get indextargets --format 'deb $(REPO_URI) $(RELEASE) $(COMPONENT)' \
  'Created-By: Packages' 'Origin: Debian' |
  awk -v release=$release 'index($3, release) == 1')
mirror=$(awk -v release=$release '$3 == release { print $2; exit }' <<<"$sources")
[ -n "$mirror" ] || cannot "apt knows no mirror of Debian $release; expected one in its sources, and apt-get update run"

folder=${folder:-$(mktemp -d "${TMPDIR:-/tmp}/fresh_machine.XXXXXX")}
machine=$folder/machine
[ ! -e "$machine" ] || fail "$machine is there already"
mkdir -p "$machine"
cache=${XDG_CACHE_HOME:-${HOME:-/root}/.cache}/taut
mkdir -p "$cache/archives/partial" "$cache/compiled"
base=$cache/$release-with-$packages.tar
ready=$cache/$release-made-$({ echo $packages; cat "$source/setup.sh"; } | sha256sum | cut -c 1-16).tar
[ "$preset" != package ] || ready=

# Mounts are there for the processes of the machine alone, and they end with their first one: nothing is left to
# be unmounted, however this script ends.
child=
clean_up() {
  if [ -n "$child" ] && kill -KILL "$child" 2>/dev/null; then
    wait "$child" 2>/dev/null || true  # which would tell that it was killed
    sleep 1  # the kernel ends the others
  fi
  rm -rf "$machine" "$folder/log.txt" "$base.part-$$" ${ready:+"$ready.part-$$"}
  rmdir --ignore-fail-on-non-empty "$folder"
}
trap clean_up EXIT
trap 'exit 130' INT TERM HUP
apart() {
  unshare --mount --pid --fork --kill-child "$@" &
  child=$!
  local code=0
  wait "$child" || code=$?
  child=
  return $code
}

make_base() {
  find "$cache" -mindepth 1 -type f -mtime +30 -delete
  [ ! -e "$base" ] || return 0
  apart debootstrap --variant=minbase --include=$packages $release "$machine" "$mirror" \
    >"$folder/log.txt" || { tail -n 30 "$folder/log.txt"; return 1; }
  rm -rf "$machine"/var/lib/apt/lists/* "$machine"/var/cache/apt/archives/*.deb  # as in the image of a container
  tar -C "$machine" --one-file-system -cf "$base.part-$$" . && mv "$base.part-$$" "$base" && rm -rf "$machine" &&
    mkdir "$machine"
}

make_debian() {
  local system=$base
  if [ -n "$ready" ] && [ -e "$ready" ]; then
    system=$ready
    echo "fresh_machine.sh: begins with the system that this setup.sh made of a bare Debian before ($ready)"
  fi
  tar -C "$machine" -xf "$system" || return 1
  echo "$sources" >"$machine/etc/apt/sources.list"
  if [ "$preset" = package ]; then
    mkdir "$machine/root/taut"
    "$source/app/install/apt_folder.sh" "$source/build/release" "$machine/srv/taut" || return 1
    echo "deb [trusted=yes] file:/srv/taut ./" >"$machine/etc/apt/sources.list.d/taut.list"
  else
    git clone --quiet --no-local "$source" "$machine/root/taut"
  fi
}

keep_ready() {
  [ ! -e "$ready" ] || return 0
  find "$cache" -maxdepth 1 -name "$release-made-*.tar" -delete
  tar -C "$machine" --one-file-system --exclude=./root/taut -cf "$ready.part-$$" . &&
    mv "$ready.part-$$" "$ready"
}

# on_the_machine COMMAND [OPTION of unshare...]
on_the_machine() {
  local settings=
  if [ -n "$compiler_cache" ]; then
    # Sources are new in every clone, and precompiled headers as old as the build.
    settings="CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_DIR=/var/cache/compiled
      CCACHE_MAXSIZE=1G CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime"
  fi
  apart "${@:2}" bash -euc '
    mount -t proc proc "$0/proc"
    mount -t sysfs -o ro sysfs "$0/sys"
    mount --bind /dev "$0/dev"
    mount -t devpts -o newinstance,ptmxmode=0666,mode=620 devpts "$0/dev/pts"
    mount -t tmpfs tmpfs "$0/dev/shm"
    mount --bind "$2/archives" "$0/var/cache/apt/archives"
    mkdir -p "$0/var/cache/compiled"
    mount --bind "$2/compiled" "$0/var/cache/compiled"
    exec chroot "$0" env -i $3 HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
      bash -c "cd ~/taut && $1"' "$machine" "$1" "$cache" "$settings"
}

timed() {
  local began=$SECONDS
  "${@:2}" || fail "failed after $((SECONDS - began)) s: $1"
  echo "fresh_machine.sh: $((SECONDS - began)) s: $1"
}

# In braces bash reads it all before it begins, and another script may be checked out meanwhile.
{
  make_base || cannot "debootstrap failed"
  timed "a bare Debian" make_debian
  if [ "$preset" = package ]; then
    timed "installing the package" on_the_machine \
      'export DEBIAN_FRONTEND=noninteractive; { apt-get update && apt-get install -y taut &&
         apt-get install -y python3-taut man-db bash-completion; } >/tmp/setup.log 2>&1 ||
       { tail -n 30 /tmp/setup.log; exit 1; }'
    timed "asking for help" on_the_machine \
      'man taut | grep -m1 "^ *taut render \[OPTIONS\]" &&
       . /usr/share/bash-completion/bash_completion && { _completion_loader taut || complete -p taut; } &&
       _taut_choices 1 taut rend 2>/dev/null | grep -x render' --net
    timed "running it" on_the_machine \
      'cd / && taut render tshirt-wind-10 --resolution 320x240 --output /tmp/a.png &&
       python3 -c "import taut; print(taut.Cloth(scene=\"tshirt\").step().max_surface_stretch)"' --net
    exit
  fi
  timed ./setup.sh on_the_machine './setup.sh >/tmp/setup.log 2>&1 || { tail -n 30 /tmp/setup.log; exit 1; }'
  keep_ready || { rm -f "$ready.part-$$"; echo "fresh_machine.sh: the system is not kept, $cache cannot hold it"; }
  # Without a network: setup.sh has nothing left to do, and nothing else may need one.
  [ -z "$before" ] || timed "$before" on_the_machine "$before" --net
  timed "$command" on_the_machine "set -o pipefail; { $command; } 2>&1 | tee /tmp/run.log" --net
  sed -n '/% tests passed/,$p' "$machine/tmp/run.log"
  exit
}
