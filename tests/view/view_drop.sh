#!/bin/sh
# Files are dropped on a real window by a real drag: a model is loaded, a broken one and a file that is none
# become messages, and the session goes on.
#   view_drop.sh TAUT DROP_FILE GARMENT FOLDER
set -eu
taut=$1
drop_file=$2
garment=$3
folder=$4
here=$(cd "$(dirname "$0")" && pwd)
command -v xvfb-run >/dev/null && command -v xdotool >/dev/null || { echo "SKIPPED: no xvfb or xdotool"; exit 77; }
if [ -z "${5:-}" ]; then
  exec xvfb-run -a -s "-screen 0 1280x800x24" sh "$here/view_drop.sh" "$taut" "$drop_file" "$garment" "$folder" inside
fi
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
. "$here/window_support.sh"

cp "$garment" "my shirt, 100 %.obj"
head -c 30000 "$garment" | sed 's/^f /f 999/' >broken.obj
echo "Buy milk." >notes.txt

"$taut" view pinned-9x9-5 --size 900,600 --record session.txt --keep . >window.log 2>&1 &
window=$!
wait_for_file session.txt
sleep 1
drop() { "$drop_file" Taut "$@" 2>>window.log || fail "the window took no file"; }
recorded() { grep -q "^\[\"drop\",.*$1" session.txt; }

drop broken.obj notes.txt
wait_for "drop of broken.obj in the record" recorded broken.obj
wait_for "drop of notes.txt in the record" recorded notes.txt
sleep 1
move 100 100
press s
wait_for_file pinned-9x9-5-1.toml
press F12
wait_for_file pinned-9x9-5-1.png
drop "my shirt, 100 %.obj"
wait_for "drop of the shirt in the record" recorded "my shirt, 100 %.obj"
save_until "my shirt, 100 %" "my shirt, 100 %.obj"
press F12
kill -0 $window 2>/dev/null || fail "the window is gone"
kill -INT $window
wait $window || true

grep -q '^columns = 9$' pinned-9x9-5-1.toml || fail "a broken file replaced the garment"
grep -q '^\["state",' session.txt || fail "the record has no end"
# The messages right after the drop of two files that cannot be read.
awk '/^\["key",83,/ { exit } { print }' session.txt >begin.txt
"$taut" view --headless --script begin.txt >begin.log
grep -q "^error: .*broken.obj" begin.log || fail "nothing was said about broken.obj"
grep -q "^error: .*notes.txt" begin.log || fail "nothing was said about notes.txt"
"$taut" view --headless --script session.txt --keep replayed >replay.log 2>&1 || { cat replay.log; fail "the replay ends in another state"; }
