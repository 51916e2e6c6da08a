#!/bin/sh
# interface.sh LIBRARY DUMP [renew]: the calls and structs of the library, which is compiled with debug information, are
# those of the dump. With `renew` the dump is written instead.
set -eu
if [ "${3:-}" = renew ]; then
  abidw --exported-interfaces-only --no-corpus-path --no-comp-dir-path --no-show-locs "$1" |
    grep -v "<dependency name=" | sed "s/path='.*\/\([a-z_]*.cpp\)'/path='\1'/" >"$2"
  exit 0
fi
abidiff --exported-interfaces-only "$2" "$1" || {
  echo "The interface has changed. Older programs survive what is new at the ends of structs, and new calls; all else"
  echo "raises TAUT_ABI_VERSION. Then: sh $0 $1 $2 renew"
  exit 1
}
