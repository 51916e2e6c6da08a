#!/bin/sh
# Interrupts a long sequence of pictures, or a video where there is ffmpeg: the program ends by the signal,
# and whatever is left is complete.
program=$1
folder=$2
output=$3
rm -rf "$folder"
mkdir -p "$folder"
case $output in
  *.mp4) command -v ffmpeg >/dev/null || { echo "SKIPPED: there is no ffmpeg"; exit 77; } ;;
esac
"$program" render pinned-9x9-5 --frames 0:100000 --set rest.speed=0 --resolution 64,64 --samples 1 --set picture.shadows=false \
  --output "$folder/$output" >"$folder.txt" 2>&1 &
run=$!
tries=0
until [ -e "$folder/000010.png" ] || [ -n "$(find "$folder" -name '*.mp4.part*')" ]; do
  kill -0 $run 2>/dev/null || { cat "$folder.txt"; echo "the run ended by itself"; exit 1; }
  tries=$((tries + 1))
  [ $tries -lt 3000 ] || { kill -KILL $run; echo "nothing was written"; exit 1; }
  sleep 0.02
done
kill -INT $run
wait $run
code=$?
[ $code -eq 130 ] || { cat "$folder.txt"; echo "exit code $code, expected 130"; exit 1; }
[ -z "$(find "$folder" -type f ! -name '??????.png')" ] || { ls "$folder"; echo "unfinished files are left"; exit 1; }
for picture in "$folder"/*.png; do
  [ ! -e "$picture" ] || tail -c 8 "$picture" | grep -q IEND || { echo "$picture is incomplete"; exit 1; }
done
