#!/bin/sh
# interface.sh LIBRARY HEADERS DUMP [renew]: the calls and structs of the library, which is compiled with debug
# information, are those of the dump. With `renew` the dump is written instead.
set -eu
hide="--exported-interfaces-only --no-corpus-path --no-comp-dir-path --no-show-locs"
if [ "${4:-}" = renew ]; then
  abidw $hide --headers-dir "$2" "$1" | grep -v "<dependency name=" | sed "s/path='[^']*'/path='taut.cpp'/" >"$3"
  exit 0
fi
abidiff --exported-interfaces-only --headers-dir1 "$2" --headers-dir2 "$2" "$3" "$1" || {
  echo "The interface has changed. What older programs survive is at the ends of structs and new calls; all else"
  echo "raises TAUT_ABI_VERSION. Then: sh $0 $1 $2 $3 renew"
  exit 1
}
