#!/bin/sh
# accept.sh BUILD_FOLDER NAME... | --all
# Makes the pictures that the tests drew last the baselines, each with the name of the renderer that drew it.
# --all takes every picture there is and removes the baselines that no test compares with any more.
set -eu
if [ $# -lt 2 ]; then
  sed -n '2,4s/^# //p' "$0" >&2
  exit 2
fi
drawn=$1/tests/golden
shift
baselines=$(dirname "$0")/baselines
mkdir -p "$baselines"

if [ "$1" = --all ]; then
  set -- $(cat "$drawn/picture_tests.txt")
  for baseline in "$baselines"/*.png; do
    name=$(basename "$baseline" .png)
    grep -qx "$name" "$drawn/picture_tests.txt" || rm -f "$baseline" "$baselines/$name.renderer.txt"
  done
fi
for name in "$@"; do
  if [ ! -e "$drawn/$name/actual.png" ]; then
    echo "there is no picture $drawn/$name/actual.png; run the test first: ctest -R '^picture.$name\$'" >&2
    exit 1
  fi
done
for name in "$@"; do
  "$drawn/compare_pictures" repack "$drawn/$name/actual.png" "$baselines/$name.png"
  cp "$drawn/$name/renderer.txt" "$baselines/$name.renderer.txt"
  echo "accepted $name"
done
