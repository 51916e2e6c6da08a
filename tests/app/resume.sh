#!/bin/sh
# resume.sh PROGRAM FOLDER
set -eu
program=$1 folder=$2

# The scene says what is in its pictures, or the camera is fitted to what they show.
for camera in '[[-0.53, -1.2, -0.05], [0.53, 0.02, 0.05]]' auto; do
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
draw() {
  "$program" render pinned-9x9-5 --resolution 96,64 --set picture.shadows=false --set "camera.box=$camera" \
    --frames 0:5 --output '{frame}.png' "$@"
}
draw
sha256sum ./*.png > whole.txt
rm 2.png 5.png
draw --resume | grep -q 'there already: 4 of 6 frames'
sha256sum -c --quiet whole.txt
draw --resume | grep -q 'there already: 6 of 6 frames'

# A disk that was full, a copy that was broken off.
for broken in 2 0; do
  cp $broken.png kept
  head -c 500 kept > $broken.png
  if draw --resume 2> error.txt; then
    echo "resumed a picture that ends in the middle"
    exit 1
  fi
  grep -q "cannot resume: the picture '$broken.png' ends in the middle; remove it, or run without --resume" error.txt
  mv kept $broken.png
done
rm 2.png
draw --resume > said.txt

# Pictures of another scene are not taken for ours, nor touched.
if draw --resume --set wind.speed=3 2> error.txt; then
  echo "resumed another scene's pictures"
  exit 1
fi
grep -q "cannot resume: '0.png' was made from another scene" error.txt
sha256sum -c --quiet whole.txt
cd ..
done
