#!/usr/bin/env bash
# archive.sh CPACK CMAKE BUILD [build]: the archive of the sources is configured where no git is. With `build`, which takes
# minutes, the program is built there too, unoptimised, and runs.
set -euo pipefail
cpack=$1 cmake=$2 build=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
. "$(dirname "$0")/../support/fail.sh"

"$cpack" --config "$build/CPackSourceConfig.cmake" -B "$folder" >"$folder/log.txt" 2>&1 || fail "$(cat "$folder/log.txt")"
mkdir "$folder/sources" "$folder/no_git"
tar xzf "$folder"/taut-*-Source.tar.gz -C "$folder/sources" --strip-components=1
[ ! -e "$folder/sources/build" ] || fail "the archive has a build in it"
printf '#!/bin/sh\necho "git was asked for: $*"\nexit 1\n' >"$folder/no_git/git"
chmod +x "$folder/no_git/git"
export PATH="$folder/no_git:$PATH"
cd "$folder/sources"
"$cmake" --preset debug >"$folder/log.txt" 2>&1 || fail "$(cat "$folder/log.txt")"
[ "${4-}" = build ] || exit 0

"$cmake" --build build/debug --target taut >"$folder/log.txt" 2>&1 || fail "$(tail -n 60 "$folder/log.txt")"
taut=build/debug/app/taut
[ "$($taut --version)" = "$("$build/app/taut" --version)" ] || fail "it is another version: $($taut --version)"
$taut simulate pinned-9x9-5 --frames 2 --export end.obj || fail "it does not run"
[ "$(grep -c '^v ' end.obj)" = 81 ] || fail "it wrote $(grep -c '^v ' end.obj) vertices, expected 81"
