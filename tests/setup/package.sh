#!/usr/bin/env bash
# package.sh CPACK BUILD: Debian's package has the program, the library and the add-on, and lintian finds no error in it
# where lintian is there.
set -euo pipefail
cpack=$1 build=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() {
  echo "$*"
  exit 1
}

"$cpack" --config "$build/CPackConfig.cmake" -G DEB -B "$folder" >"$folder/log.txt" 2>&1 || fail "$(cat "$folder/log.txt")"
package=$(echo "$folder"/taut_*.deb)
dpkg-deb --contents "$package" >"$folder/files.txt"
for file in bin/taut lib/libtaut.so include/taut.h lib/pkgconfig/taut.pc lib/cmake/Taut/TautConfig.cmake \
  libexec/taut/taut-import lib/python3/dist-packages/taut/__init__.py share/taut/taut_cloth.zip \
  share/taut/csharp/Taut.cs share/taut/scenes/tshirt.toml share/doc/taut/copyright share/man/man1/taut.1.gz; do
  grep -q " \./usr/$file" "$folder/files.txt" || fail "the package lacks /usr/$file"
done
! grep -v ' \./usr/\| \./$' "$folder/files.txt" || fail "the package has files outside /usr"
if command -v lintian >/dev/null; then
  lintian --fail-on error "$package" || fail "lintian finds errors"
fi
