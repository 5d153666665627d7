#!/bin/sh
# Draws models/textures/*.png from the vector sources beside this script.
# Needs rsvg-convert (Debian: librsvg2-bin). Run it after changing an SVG; the PNGs are checked in.
set -eu
cd "$(dirname "$0")"
out=../textures
mkdir -p "$out"

for svg in *.svg; do
  name=${svg%.svg}
  case $name in
    head_front) ;;                       # one picture an expression, below
    *) rsvg-convert "$svg" -o "$out/$name.png" ;;
  esac
done

for css in expression_*.css; do
  face=${css#expression_}; face=${face%.css}
  rsvg-convert --stylesheet "$css" head_front.svg -o "$out/head_front_$face.png"
done
