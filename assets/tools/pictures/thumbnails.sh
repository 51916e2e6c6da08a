#!/bin/sh
# thumbnails.sh TAUT [NAME...]
# Draws the small pictures of the window's lists, all or those of these names, into assets/scenes/thumbnails.png, in the
# order of thumbnails.txt. All take some minutes; needs ffmpeg.
set -eu
[ $# -ge 1 ] || { sed -n '2,4s/^# //p' "$0" >&2; exit 2; }
taut=$1
shift
assets=$(cd "$(dirname "$0")/../.." && pwd)
sheet=$assets/scenes/thumbnails
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# The pictures there are.
if [ $# -gt 0 ]; then
  ffmpeg -loglevel error -i "$sheet.png" -vf "untile=8x6" -start_number 1 "$folder/%d.png"
fi

# A scene or a garment, its frame, and a view that is closer than the whole motion needs.
number=0
: >"$folder/names"
while read -r name frame box; do
  number=$((number + 1))
  echo "$name" >>"$folder/names"
  case " $* " in "  " | *" $name "*) ;; *) continue ;; esac
  subject=$name
  [ ! -e "$assets/garments/$name.obj" ] || subject=$assets/garments/$name.obj
  "$taut" render "$subject" --frames "$frame" --resolution 768x576 --set picture.show_pins=false \
    --set camera.margin=0.02 ${box:+--set "camera.box=$box"} --output "$folder/large.png" </dev/null >/dev/null
  ffmpeg -nostdin -loglevel error -y -i "$folder/large.png" -vf scale=96:72:flags=area "$folder/$number.png"
done <<'END'
cloth-fall 60
outfit-three-walk 60
outfit-walk 60
pinned-9x9-20 0
pinned-9x9-5 120
pinned-9x9-methods 60
tshirt 60
tshirt-gravity 60
tshirt-reach 120
tshirt-walk 129
tshirt-wind-1 60
tshirt-wind-10 60
tshirt-worn 60
funnel 130
hang 84 [[-0.5, -0.8, -0.5], [0.5, 0.5, 0.5]]
layers 34
needles 92 [[-0.85, -0.22, -0.5], [0.5, 0.1, 0.5]]
reef-knot 262
rotating-sphere 140
rotating-sphere-one-percent 140
rotating-sphere-tenth-percent 220
table-cloth-1 96 [[-1.1, -0.4, -0.4], [0.4, 0.0, 0.4]]
table-cloth-2 64 [[-1.1, -0.4, -0.4], [0.4, 0.0, 0.4]]
table-cloth-4 64 [[-1.1, -0.4, -0.4], [0.4, 0.0, 0.4]]
table-cloth-8 64 [[-1.1, -0.5, -0.4], [0.4, 0.35, 0.4]]
twisted-cylinder 400
dress 20
hooded_top 20
long_shirt 20
long_sleeves 20
skirt 20
trousers 20
tshirt_1028 20
tshirt_5280 20
tshirt_10600 20
tshirt_female_34 20
tshirt_female_42 20
flag 120 [[-0.05, 1.6, -0.1], [1.0, 2.52, 0.1]]
washing-line 150 [[-1.4, 1.25, -0.2], [1.4, 2.05, 0.4]]
tshirt-gusts 60
tshirt-hanger 240
tshirt_2640 20
END
ffmpeg -loglevel error -y -start_number 1 -i "$folder/%d.png" -frames:v 1 -pix_fmt rgb24 -pred mixed \
  -vf tile=8x6 "$sheet.png"
cp "$folder/names" "$sheet.txt"
