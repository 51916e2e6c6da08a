#!/usr/bin/env bash
# package.sh CPACK BUILD: Debian's packages have the program, the library, what other programs build with, the Python
# module and the add-on, each in its own, and lintian finds no error in them where lintian is there.
set -euo pipefail
cpack=$1 build=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() {
  echo "$*"
  exit 1
}

"$cpack" --config "$build/CPackConfig.cmake" -G DEB -B "$folder" >"$folder/log.txt" 2>&1 || fail "$(cat "$folder/log.txt")"

# has PACKAGE FILE...: the package has these files, its own documents, and nothing that another has.
: >"$folder/all.txt"
has() {
  local name=$1
  shift
  local file package
  package=$(echo "$folder/$name"_*.deb)
  [ -f "$package" ] || fail "there is no package $name"
  dpkg-deb --contents "$package" >"$folder/files.txt"
  for file in "$@" "share/doc/$name/copyright" "share/doc/$name/changelog.gz"; do
    grep -qE " \./usr/$file( -> .*)?$" "$folder/files.txt" || fail "the package $name lacks /usr/$file"
  done
  ! grep -v ' \./usr/\| \./$' "$folder/files.txt" || fail "the package $name has files outside /usr"
  grep '^-' "$folder/files.txt" | awk '{print $6}' >>"$folder/all.txt"
  [ "$name" = libtaut1 ] || dpkg-deb --field "$package" Depends | grep -q "libtaut1 (= " ||
    fail "the package $name does without libtaut1 of its version"
}
has taut bin/taut share/man/man1/taut.1.gz share/bash-completion/completions/taut
has libtaut1 lib/libtaut.so.1 libexec/taut/taut-import share/taut/scenes/tshirt.toml share/taut/sweeps/Snakefile
has libtaut-dev include/taut.h lib/libtaut.so lib/pkgconfig/taut.pc lib/cmake/Taut/TautConfig.cmake share/taut/csharp/Taut.cs
has python3-taut lib/python3/dist-packages/taut/__init__.py
has blender-taut share/taut/taut_cloth.zip
[ "$(ls "$folder"/*.deb | wc -l)" = 5 ] || fail "expected five packages, found $(ls "$folder"/*.deb)"
twice=$(sort "$folder/all.txt" | uniq -d)
[ -z "$twice" ] || fail "in two packages: $twice"
if command -v lintian >/dev/null; then
  lintian --fail-on error "$folder"/*.deb || fail "lintian finds errors"
fi
