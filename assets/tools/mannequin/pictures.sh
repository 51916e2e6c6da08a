#!/bin/sh
# Makes the picture of the T-shirt that is worn: pictures.sh TAUT FILE.png. It simulates for half a minute; needs ffmpeg.
set -eu
taut=$1
file=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

number=0
# A scene, its frame, where it is seen from, and what is in the picture.
while read -r scene frame azimuth box; do
  number=$((number + 1))
  "$taut" render "$scene" --frames "$frame" --set picture.width=400 --set picture.height=560 \
    --set "camera.azimuth=$azimuth" --set "camera.box=$box" --output "$folder/$number.png"
done <<'END'
tshirt-worn 100 15 [[-0.42, 0.72, -0.15], [0.42, 1.92, 0.2]]
tshirt-walk 129 35 [[-0.42, 0.72, -0.15], [0.42, 1.92, 0.2]]
tshirt-reach 120 40 [[-0.42, 0.72, -0.15], [0.42, 1.92, 0.4]]
END
ffmpeg -loglevel error -y -start_number 1 -i "$folder/%d.png" -frames:v 1 -pix_fmt rgb24 -pred mixed \
  -vf tile=3x1:padding=4:color=white "$file"
