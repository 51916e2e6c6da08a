#!/bin/sh
# A signal while F10 records: the video is completed, and has the frames of the time that went by.
#   view_video.sh TAUT FOLDER
set -eu
taut=$1
folder=$2
here=$(cd "$(dirname "$0")" && pwd)
for needed in xvfb-run xdotool ffmpeg ffprobe; do
  command -v $needed >/dev/null || { echo "SKIPPED: no $needed"; exit 77; }
done
if [ -z "${3:-}" ]; then
  exec xvfb-run -a -s "-screen 0 1280x800x24" sh "$here/view_video.sh" "$taut" "$folder" inside
fi
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
. "$here/window_support.sh"

frames_in() { ffprobe -v error -count_frames -show_entries stream=nb_read_frames -of csv=p=0 "$1"; }

for signal in INT TERM; do
  rm -f session.txt
  "$taut" view pinned-9x9-5 --size 1000,780 --record session.txt --keep . >window.log 2>&1 &
  window=$!
  wait_for_file session.txt
  sleep 1
  move 100 100
  press F10
  sleep 2
  kill -$signal $window
  wait $window && fail "the program ended as if nobody had sent it a signal"
  [ -z "$(find . -name '*.part*')" ] || fail "an unfinished file is left"
done
for video in pinned-9x9-5-1.mp4 pinned-9x9-5-2.mp4; do
  [ -e $video ] || fail "there is no $video"
  [ "$(frames_in $video)" -gt 20 ] || fail "$video has $(frames_in $video) frames of two seconds"
done
grep -q 'wrote .*pinned-9x9-5-2.mp4' window.log || fail "nothing was said about the video"
