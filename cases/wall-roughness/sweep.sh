#!/bin/sh
# All runs of docs/results/wall-roughness.md, one after the other: sweep.sh CLOD FOLDER
set -eu
clod=$1 folder=$2
case=$(dirname "$0")/case.yaml
run() { # name ridges
    "$clod" run "$case" -o "$folder/$1" --threads 1 --no-report \
        --set "wall_friction.plate_ridges=$2"
}
sed '/plate_ridges/d' "$case" > "$folder/flat.yaml"
"$clod" run "$folder/flat.yaml" -o "$folder/flat" --threads 1 --no-report
for height in 0.25 0.5 1 1.5 2.5 5; do # a spacing of a grain's diameter, 5 mm
    run "height-$height" "{height: $height mm, spacing: 5 mm}"
done
for spacing in 2.5 10 20; do # 0.2 diameters high, flanks as of a spacing of 2.5 mm
    run "spacing-$spacing" "{height: 1 mm, spacing: $spacing mm, width: 2.5 mm}"
done
"$clod" run "$(dirname "$0")/solid.yaml" -o "$folder/solid" --threads 1 --no-report
