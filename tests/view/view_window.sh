#!/bin/sh
# A real window on a display of its own, with a real pointer and keyboard: the wind slider, back in time and
# on from there, pause, step, reset, a pull at the cloth, another scene, screenshots, saved scenes. Its
# doings are read from what it saved, and its record has to replay to the same state.
#   view_window.sh TAUT FOLDER
set -eu
taut=$1
folder=$2
command -v xvfb-run >/dev/null && command -v xdotool >/dev/null || { echo "SKIPPED: no xvfb or xdotool"; exit 77; }
here=$(cd "$(dirname "$0")" && pwd)
if [ -z "${3:-}" ]; then
  exec xvfb-run -a -s "-screen 0 1280x800x24" sh "$here/view_window.sh" "$taut" "$folder" inside
fi
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
. "$here/window_support.sh"

"$taut" view cloth-fall --headless --size 1280,720 --layout layout.txt >/dev/null

"$taut" view cloth-fall --size 1280,720 --record session.txt --keep . >window.log 2>&1 &
window=$!
wait_for_file session.txt
sleep 1
move 100 100
press F12
wait_for_file cloth-fall-1.png
drag $(place wind.speed 0) $(place wind.speed 5)
xdotool mouseup 1
sleep 0.7
move 100 100
save_until cloth-fall '^speed = 10.0$'
press F12
wait_for_file cloth-fall-2.png
drag $(place timeline 9) $(place timeline 3)
xdotool mouseup 1
move 100 100
press Up
press space
press space
press period
press period
press r
save_until cloth-fall '^frames = 1$'  # paused: back at frame 0
press space
drag 480 330 300 250
sleep 0.3
xdotool mouseup 1
move 100 100
press Next
save_until pinned-9x9-5 '^columns = 9$'
kill -INT $window
wait $window || true

! cmp -s cloth-fall-1.png cloth-fall-2.png || fail "the wind changes nothing"
grep -q '^\["state",' session.txt || fail "the record has no end"
"$taut" view --headless --script session.txt --keep replayed >replay.log 2>&1 || { cat replay.log; fail "the replay ends in another state"; }
