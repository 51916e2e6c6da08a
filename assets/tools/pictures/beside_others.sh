#!/bin/sh
# beside_others.sh TAUT SHEET.png [FABRIC]
# Draws one moment of the T-shirt by Taut and, with the same camera, by Blender's Eevee as cotton and as velvet and by
# F3D, as far as these are installed, and puts the pictures side by side. Needs ffmpeg; the others need xvfb-run.
set -eu
[ $# -ge 2 ] || { sed -n '2,4s/^# //p' "$0" >&2; exit 2; }
taut=$1 sheet=$2 fabric=${3:-cotton}
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
eye=1.75,2.5,2.25 target=0,1.14,0 degrees=20

"$taut" render tshirt-wind-1 --fabric "$fabric" --frames 45 --resolution 640x720 --output "$folder/taut.png" \
  --export "$folder/shirt.obj" --set "camera.eye=[$eye]" --set "camera.target=[$target]" \
  --set camera.field_of_view=$degrees
set -- "$folder/taut.png"
if command -v blender >/dev/null && command -v xvfb-run >/dev/null; then
  for look in cotton velvet; do
    xvfb-run -a blender --background --factory-startup --python "$here/beside_others.py" -- "$folder/shirt.obj" \
      "$folder/$look.png" $look $eye $target $degrees >"$folder/log" 2>&1 || { cat "$folder/log" >&2; exit 1; }
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
