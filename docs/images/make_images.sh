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

# Hands with five fingers around a ball, and the nursery with its toys.
"$mimo" render --scene catch --touch off --look-at 0.1 -0.07 0.64 --distance 0.85 --azimuth 150 --elevation -15 \
  --width 1280 --height 960 --seed 2 --out "$work/catch.png"
"$mimo" render --scene showroom --touch off --look-at 0.05 -0.08 0.35 --distance 1.9 --azimuth 120 --elevation -22 \
  --width 1280 --height 960 --out "$work/showroom.png"
montage "$work/catch.png" "$work/showroom.png" -resize 50% -tile 2x1 -geometry +3+3 -depth 8 fingers.png

# Both renderers side by side: OSMesa with one sample a pixel, rays with sixteen; the infant, and its shadow from near.
pair() {
  name=$1
  shift
  "$mimo" render --touch off --renderer osmesa "$@" --out "$work/osmesa.png"
  "$mimo" render --touch off --renderer ray --samples 16 "$@" --out "$work/ray.png"
  montage "$work/osmesa.png" "$work/ray.png" -tile 2x1 -geometry +1+0 -depth 8 "$name.png"
}
pair renderers --scene free --look-at 0 0 0.42 --distance 1.3 --azimuth 150 --elevation -12 --width 480 --height 480
pair renderers-close --scene free --look-at 0.02 -0.06 0 --distance 0.4 --azimuth 150 --elevation -40 --width 480 --height 480

# A model that is no infant, after it has fallen, and what it feels where it feels most.
"$mimo" run --scene ../../tests/models/humanoid.xml --seconds 2 --seed 1 --out "$work/own" >/dev/null
montage "$work/own/outside.png" "$work/own/touch.png" -tile 2x1 -geometry 480x360+3+3 -depth 8 own-model.png

# A ball pressed against a hand.
"$mimo" render --scene touch.xml --body mitten --touch 0.7 --look-at 0 -0.155 0.04 --distance 0.25 --azimuth 20 \
  --elevation -8 --samples 16 --width 640 --height 480 --out touch.png

# What an infant feels after ten seconds, from its side, and its whole skin unfolded.
"$mimo" run --seconds 10 --vision off --seed 1 --out "$work/felt" >/dev/null
montage "$work/felt/touch.png" "$work/felt/touch_map.png" -tile 2x1 -geometry 480x360+3+3 -depth 8 touch_run.png

# Two infants, and both smile.
"$mimo" render --scene playdate --touch off --face enjoyment --look-at 0 0 0.2 --distance 1.05 --azimuth 65 \
  --elevation -14 --width 1600 --height 1040 --out "$work/playdate.png"
montage "$work/playdate.png" -resize 50% -tile 1x1 -geometry +0+0 -depth 8 playdate.png

# The same infant from birth to two years, to scale: all from one place, standing on its soles in the middle below.
ages=
for age in 0 3 6 12 18 24; do
  "$mimo" render --scene free --touch off --age $age --samples 16 --look-at 0 0 0.47 --distance 1.25 --azimuth 165 \
    --elevation -4 --width 400 --height 800 --out "$work/age$age.png"
  montage -label "$age months" -pointsize 26 "$work/age$age.png" -tile 1x1 -geometry +0+4 -depth 8 "$work/labelled$age.png"
  ages="$ages $work/labelled$age.png"
done
montage $ages -resize 50% -tile 6x1 -geometry +2+0 -depth 8 growth.png
