#!/bin/sh
# symbols.sh LIBRARY LIST: the library shows the calls of the list and nothing else.
nm -D --defined-only "$1" | sed 's/.* //' | LC_ALL=C sort | diff "$2" - ||
  { echo "the library shows other symbols (>) than $2 says (<)"; exit 1; }
