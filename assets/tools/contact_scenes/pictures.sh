#!/bin/sh
# Makes the picture of the scenes about contact: pictures.sh TAUT FILE.png. It simulates for some minutes; needs ffmpeg.
set -eu
taut=$1
file=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

number=0
# A scene, its frame, a caption, and a view that is closer than the whole motion needs.
while IFS='|' read -r scene frame caption box; do
  number=$((number + 1))
  "$taut" render "$scene" --frames "$frame" --set picture.width=400 --set picture.height=300 \
    ${box:+--set "camera.box=$box"} --output "$folder/plain.png" </dev/null
  ffmpeg -nostdin -loglevel error -y -i "$folder/plain.png" -frames:v 1 \
    -vf "drawtext=text='$caption':expansion=none:font=DejaVu Sans:fontsize=15:fontcolor=0x1c1c1c:x=(w-tw)/2:y=h-24" \
    "$folder/$number.png"
done <<'END'
rotating-sphere|140|turned by a sphere, bound 5 %
rotating-sphere-tenth-percent|220|the same, bound 0.1 %
twisted-cylinder|400|twisted by both ends
reef-knot|300|two ribbons, knotted
funnel|182|pushed through a funnel
needles|92|drawn over needles|[[-0.85, -0.22, -0.5], [0.5, 0.1, 0.5]]
layers|34|five sheets on a ball
table-cloth-1|96|pulled from under napkins, 1 m/s|[[-1.1, -0.4, -0.4], [0.4, 0.0, 0.4]]
table-cloth-8|60|the same, 8 m/s|[[-1.1, -0.5, -0.4], [0.4, 0.35, 0.4]]
END
ffmpeg -loglevel error -y -start_number 1 -i "$folder/%d.png" -frames:v 1 -pix_fmt rgb24 -pred mixed \
  -vf tile=3x3:padding=4:color=white "$file"
