#!/bin/sh
# Makes the pictures of the T-shirt that is worn: pictures.sh TAUT FOLDER writes worn.png and sizes.png. It simulates for a minute;
# needs ffmpeg.
set -eu
taut=$1
pictures=$2
assets=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# Joins what is drawn of each line of the input: a scene, its frame, where it is seen from, and what is in the picture.
draw() {
  number=0
  while read -r scene frame azimuth box; do
    number=$((number + 1))
    "$taut" render "$scene" --frames "$frame" --set picture.width=400 --set picture.height=560 --set picture.quality=final \
      --set "camera.azimuth=$azimuth" --set "camera.box=$box" --output "$folder/$number.png"
  done
  ffmpeg -loglevel error -y -start_number 1 -i "$folder/%d.png" -frames:v 1 -pix_fmt rgb24 -pred mixed \
    -vf tile=3x1:padding=4:color=white "$pictures/$1.png"
}

draw worn <<'END'
tshirt-worn 100 15 [[-0.42, 0.72, -0.15], [0.42, 1.92, 0.2]]
tshirt-walk 129 35 [[-0.42, 0.72, -0.15], [0.42, 1.92, 0.2]]
tshirt-reach 120 40 [[-0.42, 0.72, -0.15], [0.42, 1.92, 0.4]]
END

# The scene for another size.
for size in female_34 female_42; do
  sed "s|\.\./garments/tshirt_10600|$assets/garments/tshirt_$size|; s|\.\./bodies/mannequin_male_40|$assets/bodies/mannequin_$size|
    s|\.\./motions|$assets/motions|" "$assets/scenes/tshirt-worn.toml" >"$folder/$size.toml"
done
draw sizes <<END
$folder/female_34.toml 100 15 [[-0.46, 0.55, -0.15], [0.46, 1.92, 0.2]]
tshirt-worn 100 15 [[-0.46, 0.55, -0.15], [0.46, 1.92, 0.2]]
$folder/female_42.toml 100 15 [[-0.46, 0.55, -0.15], [0.46, 1.92, 0.2]]
END
