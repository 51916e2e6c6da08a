#!/bin/sh
# Makes a video of each scene about contact: videos.sh TAUT FOLDER [OPTION OF TAUT RENDER...]. Videos that are there
# already stay as they are. It simulates for a quarter of an hour; needs ffmpeg.
set -eu
taut=$1
folder=$2
shift 2
scenes=$(dirname "$0")/../../scenes/contact

status=0
for scene in "$scenes"/*.toml; do
  video=$folder/$(basename "$scene" .toml).mp4
  if [ -e "$video" ]; then
    echo "$video is there"
  else
    echo "$video ..."
    "$taut" render "$scene" --resolution 1280,720 --output "$video" "$@" || status=$?
  fi
done
exit $status
