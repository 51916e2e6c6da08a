#!/bin/sh
# pages.sh TAUT FOLDER
# Draws pictures of the pages about drawing, models, sewing, bodies and the solver into FOLDER: printed.png, fitted.png,
# fit.png, sewing_steps.png, sewn.png, outfits.png, springs_and_surface.png and wind.png. Takes minutes; needs ffmpeg, python3.
set -eu
[ $# -eq 2 ] || { sed -n '2,4s/^# //p' "$0" >&2; exit 2; }
taut=$1 pictures=$2
assets=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# Puts what was drawn as 1.png, 2.png ... together by a filter of ffmpeg.
join() {
  inputs=
  for number in $(seq "$3"); do inputs="$inputs -i $folder/$number.png"; done
  # shellcheck disable=SC2086
  ffmpeg -nostdin -y -loglevel error $inputs -filter_complex "$2" -frames:v 1 -pix_fmt rgb24 -pred mixed "$pictures/$1.png"
}

"$taut" render flag --frames 440 --quality final --resolution 560x400 --set camera.azimuth=48 \
  --set 'camera.box=[[-0.05, 1.6, -0.1], [1.0, 2.52, 0.1]]' --output "$folder/1.png"
"$taut" render washing-line --frames 440 --quality final --resolution 870x400 \
  --set 'camera.box=[[-1.62, 1.28, -0.2], [1.62, 2.05, 0.4]]' --output "$folder/2.png"
join wind hstack=2 2

texture=$assets/textures/print.png
"$taut" render tshirt-wind-1 --frames 45 --view front --texture "$texture" --background "#ffffff" --quality final --resolution 391x440 \
  --output "$folder/1.png"
"$taut" render tshirt-worn --frames 60 --texture "$texture" --background "#ffffff" --quality final --resolution 391x440 \
  --set picture.outside_colour=#2f5a45 --set camera.azimuth=0 --set 'camera.box=[[-0.42, 0.85, -0.15], [0.42, 1.92, 0.2]]' \
  --output "$folder/2.png"
"$taut" render tshirt-wind-10 --frames 58 --texture "$texture" --background "#ffffff" --quality final --resolution 575x440 \
  --set picture.outside_colour=#d0182f --output "$folder/3.png"
join printed hstack=3 3

number=0
for look in "tshirt-gravity 240 --stretch --set picture.stretch_of=surface --set picture.stretch_range=[0,0.04]" \
  "tshirt-wind-10 102"; do
  for bound in springs surface; do
    number=$((number + 1))
    # shellcheck disable=SC2086
    set -- $look
    scene=$1 frame=$2
    shift 2
    "$taut" render "$scene" --frames "$frame" --quality final --resolution 560x384 --set solver.bound=$bound \
      --set solver.max_stretch=0.01 "$@" --output "$folder/$number.png"
  done
done
join springs_and_surface "[0][1]hstack[a];[2][3]hstack[b];[a][b]vstack" 4

# A shirt with a second wall 2 mm within the first, closed along its borders.
python3 - "$assets/garments/tshirt_5280.obj" "$folder/tshirt-two-walls.obj" <<'END'
import sys
lines = [line.split() for line in open(sys.argv[1])]
points = [tuple(map(float, line[1:4])) for line in lines if line[:1] == ['v']]
faces = [tuple(int(corner.split('/')[0]) - 1 for corner in line[1:]) for line in lines if line[:1] == ['f']]
normals = [[0.0] * 3 for _ in points]
for a, b, c in faces:
    u, v = ([points[k][i] - points[a][i] for i in range(3)] for k in (b, c))
    for k in (a, b, c):
        for i in range(3):
            normals[k][i] += u[i - 2] * v[i - 1] - u[i - 1] * v[i - 2]
count = len(points)
for point, normal in zip(points[:], normals):
    length = sum(x * x for x in normal) ** 0.5
    points.append(tuple(x - 0.002 * n / length for x, n in zip(point, normal)))
sides = {(face[k], face[(k + 1) % 3]) for face in faces for k in range(3)}
border = [side for side in sorted(sides) if side[::-1] not in sides]
faces += [tuple(k + count for k in reversed(face)) for face in faces]
for a, b in border:
    faces += [(b, a, a + count), (b, a + count, b + count)]
with open(sys.argv[2], 'w') as out:
    out.writelines('v %.6f %.6f %.6f\n' % point for point in points)
    out.writelines('f %d %d %d\n' % tuple(k + 1 for k in face) for face in faces)
END
"$taut" inspect "$folder/tshirt-two-walls.obj" --picture "$folder/1.png"
# Its many lines pack well as colours of a palette only.
ffmpeg -nostdin -y -loglevel error -i "$folder/1.png" -frames:v 1 -pred mixed -filter_complex \
  "scale=1200:-1:flags=area,split[a][b];[a]palettegen=max_colors=128[p];[b][p]paletteuse=dither=none" "$pictures/fitted.png"

python3 "$assets/patterns/tshirt/as_json.py" "$assets/patterns/tshirt/teagan.toml" >"$folder/tshirt.json"
"$taut" sew "$folder/tshirt.json" --body "$assets/bodies/mannequin_male_40.glb" --fabric jersey \
  --output "$folder/shirt.obj" --steps "$folder/1.png"
join sewing_steps scale=1430:-1:flags=area 1

number=0
while read -r garment body fabric box; do
  number=$((number + 1))
  "$taut" render "$assets/garments/$garment.obj" --body "$assets/bodies/mannequin_$body.glb" --dress 0 --frames 30 \
    --fabric "$fabric" --resolution 440x600 --quality final --set 'pins.at="none"' --set camera.azimuth=20 \
    --set "camera.box=$box" --output "$folder/$number.png" </dev/null
done <<'END'
long_shirt male_40 jersey [[-0.62, 0.42, -0.2], [0.62, 1.86, 0.2]]
dress female_34 jersey [[-0.54, 0.28, -0.2], [0.54, 1.66, 0.2]]
skirt female_34 denim [[-0.54, 0.28, -0.2], [0.54, 1.66, 0.2]]
hooded_top male_40 linen [[-0.62, 0.42, -0.2], [0.62, 1.86, 0.2]]
END
join sewn hstack=4 4

"$taut" fit "$assets/garments/tshirt_10600.obj" --body "$assets/bodies/mannequin_female_34.glb" --output "$folder/1.png"
join fit scale=887:-1:flags=area 1

number=0
for scene in outfit-walk outfit-three-walk; do
  number=$((number + 1))
  "$taut" render $scene --frames 40 --quality final --resolution 720x900 --output "$folder/$number.png"
done
join outfits hstack 2
