#!/bin/sh
# beside_others.sh TAUT SHEET.png [FABRIC]
# Draws one moment of the T-shirt by Taut, in normal and final quality, and with the same camera by Blender: by Cycles in
# Taut's studio, by Eevee as cotton and as velvet; and by F3D, as far as these are installed. Puts the
# pictures side by side, and says how far Taut's are from that of Cycles, which follows every path of the light. Needs
# ffmpeg; the others need xvfb-run.
set -eu
[ $# -ge 2 ] || { sed -n '2,6s/^# //p' "$0" >&2; exit 2; }
taut=$1 sheet=$2 fabric=${3:-cotton}
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
eye=1.75,2.5,2.25 target=0,1.14,0 degrees=20 floor_m=0.7
key() { sed -n "s/^$1 *= *\"*\([#0-9a-f.]*\).*/\1/p" "$here/../../fabrics/$fabric.toml"; }

for quality in normal final; do
  "$taut" render tshirt-wind-1 --fabric "$fabric" --frames 45 --resolution 640x720 --output "$folder/$quality.png" \
    --export "$folder/shirt.obj" --set "camera.eye=[$eye]" --set "camera.target=[$target]" --quality $quality \
    --set camera.field_of_view=$degrees --set picture.ground=$floor_m
  set -- "$@" "$folder/$quality.png"
done
shift "$(($# - 2))"
if command -v blender >/dev/null && command -v xvfb-run >/dev/null; then
  for look in cycles cotton velvet; do
    xvfb-run -a blender --background --factory-startup --python-exit-code 1 --python "$here/beside_others.py" -- \
      "$folder/shirt.obj" "$folder/$look.png" $look $eye $target $degrees $floor_m "$(key outside_colour)" \
      "$(key inside_colour)" "$(key translucency)" >"$folder/log" 2>&1 ||
      { cat "$folder/log" >&2; exit 1; }
    set -- "$@" "$folder/$look.png"
  done
fi
if command -v f3d >/dev/null && command -v xvfb-run >/dev/null; then
  xvfb-run -a f3d "$folder/shirt.obj" --output "$folder/f3d.png" --resolution 640,720 --camera-position $eye \
    --camera-focal-point $target --camera-view-angle $degrees --up +Y --ssao --fxaa --tone-mapping \
    --bg-color 0.9,0.9,0.9
  set -- "$@" "$folder/f3d.png"
fi
for picture; do inputs="${inputs:-} -i $picture"; done
# shellcheck disable=SC2086
ffmpeg -y -loglevel error $inputs -filter_complex "hstack=inputs=$#" -frames:v 1 "$sheet"
echo "wrote $sheet: $# pictures"
[ ! -f "$folder/cycles.png" ] || for quality in normal final; do
  ffmpeg -i "$folder/$quality.png" -i "$folder/cycles.png" -lavfi psnr -f null - 2>&1 |
    sed -n "s/.*average:\([0-9.]*\).*/$quality beside Cycles: PSNR \1 dB/p"
done
