#!/usr/bin/env bash
# Measures what docs/long-renders.md and docs/scaling.md tell: the time of checkpoints, of merging 16 parts against "cat" of the same files, sizes of parts,
# memory, and what a task costs before its first sample. Takes some minutes and 9 GB: long-renders.sh [FOLDER]
set -euo pipefail
cd "$(dirname "$0")/../.."
raytracer=$(realpath src/RayTracer.Cli/bin/Release/net10.0/raytracer)
folder=$(mktemp -d -p "${1:-${TMPDIR:-/tmp}}")
trap 'rm -rf "$folder"' EXIT
now() { date +%s.%N; }

# seconds COMMAND…: how long it takes.
seconds() {
    local start
    start=$(now)
    "$@" > /dev/null
    awk "BEGIN { printf \"%.2f\", $(now) - $start }"
}

number() { grep -o "\"$1\": [0-9.]*" | cut -d ' ' -f 2; }

echo "start-up: $(seconds "$raytracer" --version) s for the program, $(seconds "$raytracer" render scenes/cornell.json --width 8 --height 8 --spp 1 -o "$folder/a.png" --quiet) s for a tiny picture"
for size in "1920 1080" "160 120"; do
    read -r width height <<< "$size"
    json=$("$raytracer" render scenes/cornell.json --width "$width" --height "$height" --spp 16777216 --time "${RAYTRACER_CHECKPOINT_TIME:-60}" \
        --checkpoint "$folder/c.rtfilm" --checkpoint-interval 1 --quiet --json)
    rm "$folder/c.rtfilm"
    echo "checkpoints of $width×$height: $(number checkpoints <<< "$json") in $(number renderSeconds <<< "$json") s took $(number checkpointSeconds <<< "$json") s, the one at the end included"
done

for i in $(seq 16); do
    "$raytracer" render scenes/report/scene1.json --width 3840 --height 2160 --spp 16 --max-diffuse-depth 0 --max-specular-depth 0 --part "$i/16" -o "$folder/p$i.rtfilm" --quiet
done
echo "16 parts of 3840×2160: $(cat "$folder"/p*.rtfilm | wc -c) bytes"
for round in 1 2 3; do
    echo "cat to nowhere $(seconds cat "$folder"/p*.rtfilm) s, cat to a file $(seconds sh -c "cat '$folder'/p*.rtfilm > '$folder/all'; sync '$folder/all'") s," \
        "merge --json $(seconds "$raytracer" merge "$folder"/p*.rtfilm --json) s, merge -o film $(seconds "$raytracer" merge "$folder"/p*.rtfilm -o "$folder/m.rtfilm") s," \
        "merge -o exr $(seconds "$raytracer" merge "$folder"/p*.rtfilm -o "$folder/m.exr") s"
    rm "$folder/all"
done
if command -v /usr/bin/time > /dev/null; then
    echo "memory of the merge: $( { /usr/bin/time -f %M "$raytracer" merge "$folder"/p*.rtfilm --json > /dev/null; } 2>&1) KiB"
fi
