#!/bin/sh
# fabrics.sh TAUT FILE.png: one T-shirt in one wind, of six fabrics. Needs ffmpeg.
set -eu
[ $# -eq 2 ] || { sed -n '2s/^# //p' "$0" >&2; exit 2; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
number=0
for fabric in silk jersey cotton wool linen denim; do
  number=$((number + 1))
  "$1" render tshirt-wind-1 --fabric $fabric --frames 45 --resolution 400x390 --quality final \
    --output "$folder/plain.png"
  ffmpeg -loglevel error -y -i "$folder/plain.png" -frames:v 1 \
    -vf "drawtext=text=$fabric:font=DejaVu Sans:fontsize=20:fontcolor=0x1c1c1c:x=(w-tw)/2:y=h-28" "$folder/$number.png"
done
ffmpeg -loglevel error -y -start_number 1 -i "$folder/%d.png" -frames:v 1 -pix_fmt rgb24 -pred mixed \
  -vf tile=3x2:padding=4:color=white "$2"
