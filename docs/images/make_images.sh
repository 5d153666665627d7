#!/bin/sh
# Draws the pictures of the infant in the documentation anew. Needs a build (build/bin/mimo) and ImageMagick's montage.
set -eu
cd "$(dirname "$0")"
mimo=${MIMO:-../../build/bin/mimo}
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

# The seven faces, drawn at twice the size for smooth edges.
faces=
for face in neutral enjoyment sadness surprise disgust anger fear; do
  "$mimo" render --scene free --touch off --face $face --look-at 0.03 0 0.786 --distance 0.26 --azimuth 184 \
    --elevation -2 --width 480 --height 480 --out "$work/$face.png"
  faces="$faces $work/$face.png"
done
montage $faces -resize 50% -tile 4x2 -geometry +3+3 -depth 8 faces.png

# The whole body, by both renderers.
for renderer in ray osmesa; do
  "$mimo" render --scene free --touch off --renderer $renderer --look-at 0.02 0 0.5 --distance 1.25 --azimuth 155 \
    --elevation -8 --width 960 --height 1200 --out "$work/body_$renderer.png"
done
montage "$work/body_ray.png" "$work/body_osmesa.png" -resize 40% -tile 2x1 -geometry +3+3 -depth 8 body.png

# A model that is no infant, after it has fallen, and what it feels where it feels most.
"$mimo" run --scene ../../tests/models/humanoid.xml --seconds 2 --seed 1 --out "$work/own" >/dev/null
montage "$work/own/outside.png" "$work/own/touch.png" -tile 2x1 -geometry 480x360+3+3 -depth 8 own-model.png
# Two infants, and both smile.
"$mimo" render --scene playdate --touch off --face enjoyment --look-at 0 0 0.2 --distance 1.05 --azimuth 65 \
  --elevation -14 --width 1600 --height 1040 --out "$work/playdate.png"
montage "$work/playdate.png" -resize 50% -tile 1x1 -geometry +0+0 -depth 8 playdate.png
