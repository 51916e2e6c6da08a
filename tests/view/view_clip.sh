#!/bin/sh
# A clip of each format, as the window writes it, is what `taut simulate --export` writes of the same frames.
#   view_clip.sh TAUT FOLDER
set -eu
taut=$1
folder=$2
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"

click() { printf '["at", "%s", 0.5, 0.5]\n["button", "left", true]\n["frame"]\n["button", "left", false]\n["frame", 2]\n' "$1"; }
press() { printf '["key", %s, true]\n["frame"]\n["key", %s, false]\n' "$1" "$1"; }
space=32
r=82
x=88
{
  printf '["taut-session", 2]\n["scene", "pinned-9x9-5"]\n["window", 1000, 780, 1]\n["frame", 2]\n'
  press $space
  for format in PC2 MDD glTF VTK OBJ; do
    press $r
    click keep.clip_format
    click keep.clip_format.$format
    press $x
    press $space
    echo '["frame", 20]'
    press $space
    press $x
  done
  echo '["frame"]'
} >session.txt
"$taut" view --headless --script session.txt --keep . >view.log

number=0
for name in .pc2 .mdd .glb .pvd '_{frame:04}.obj'; do
  number=$((number + 1))
  "$taut" simulate pinned-9x9-5 --quiet --frames 0:22 --export "run/pinned-9x9-5$name"
  diff -r run pinned-9x9-5-$number-clip >&2 || { cat view.log >&2; exit 1; }
  rm -r run
done
