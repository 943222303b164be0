#!/usr/bin/env bash
# Renders every picture of docs/gallery.md again, by the commands that stand there. Run from the repository's root.
set -euo pipefail
dotnet build -c Release src/RayTracer.Cli > /dev/null
grep -o '`raytracer render [^`]*`' docs/gallery.md | tr -d '`' | while read -r _ arguments; do
    output=${arguments##* }
    # shellcheck disable=SC2086
    src/RayTracer.Cli/bin/Release/net10.0/raytracer ${arguments% *} "docs/pictures/$output" --quiet < /dev/null
    # Of a denoised picture, only that is shown.
    denoised=docs/pictures/${output%.*}.denoised.${output##*.}
    if [ -e "$denoised" ]; then rm "docs/pictures/$output"; fi
    echo "$output"
done
