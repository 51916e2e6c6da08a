#!/bin/sh
# Interrupts a long run: the program ends by the signal and every shape it wrote is complete.
program=$1
folder=$2
rm -rf "$folder"
"$program" simulate pinned-9x9-5 --frames :100000 --set rest.speed=0 --export "$folder/{frame:06}.obj" >"$folder.txt" 2>&1 &
run=$!
while [ ! -e "$folder/000050.obj" ]; do
  kill -0 $run 2>/dev/null || { cat "$folder.txt"; echo "the run ended by itself"; exit 1; }
  sleep 0.02
done
kill -TERM $run
wait $run
code=$?
[ $code -eq 143 ] || { echo "exit code $code, expected 143"; exit 1; }
for shape in "$folder"/*.obj; do
  [ "$(grep -c '^v' "$shape")" -eq 81 ] && [ "$(grep -c '^f' "$shape")" -eq 64 ] || { echo "$shape is incomplete"; exit 1; }
done
[ -z "$(find "$folder" -type f ! -name '*.obj')" ] || { echo "unfinished files are left"; exit 1; }
