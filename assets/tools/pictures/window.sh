#!/bin/sh
# window.sh TAUT FOLDER
# Draws window.png and compare.png of a real window into FOLDER, with the times that it measures: nothing else should
# run. Needs xvfb-run and ffmpeg.
set -eu
[ $# -ge 2 ] || { sed -n '2,4s/^# //p' "$0" >&2; exit 2; }
[ -n "${3:-}" ] || exec xvfb-run -a -s "-screen 0 1280x720x24" sh "$0" "$1" "$2" inside

# A picture's name, seconds to wait, and what is shown.
shoot() {
  picture=$1 seconds=$2
  shift 2
  "$taut" view "$@" --size 1280,720 >/dev/null 2>&1 &
  window=$!
  sleep "$seconds"
  ffmpeg -nostdin -y -loglevel error -f x11grab -draw_mouse 0 -video_size 1280x720 -i "$DISPLAY" -frames:v 1 \
    -pix_fmt rgb24 -pred mixed "$pictures/$picture.png"
  kill -INT $window
  wait $window || true
}
taut=$1 pictures=$2
garment=$(dirname "$0")/../../garments/tshirt_5280.obj
shoot window 4 tshirt-wind-1 --set garment.file="$garment"
shoot compare 14 tshirt-wind-1 --compare provot --set garment.file="$garment"
