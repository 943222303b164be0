#!/usr/bin/env bash
# Renders the small pictures of the primer's lessons again. Run from the repository's root.
set -euo pipefail
dotnet build -c Release src/RayTracer.Cli > /dev/null
folder=docs/pictures/pages
render() {
    local name=$1
    shift
    src/RayTracer.Cli/bin/Release/net10.0/raytracer render "$@" -o "$folder/lesson-$name.jpg" --quiet 2> /dev/null
}

# Those that are denoised are shown so.
denoised() {
    render "$1" "${@:2}" --denoise
    mv "$folder/lesson-$1.denoised.jpg" "$folder/lesson-$1.jpg"
}

denoised grove scenes/gallery/grove.json --width 640 --spp 32
denoised prism scenes/gallery/prism.json --width 640
denoised cornell scenes/cornell.json --width 400 --spp 64
for n in 4 16 64; do
    render samples-$n scenes/primer/01-sphere.json --width 240 --spp $n --set render.sampler=independent
done

render scattered scenes/primer/26-importance.json --spp 16 --integrator report \
    --set render.maxDiffuseDepth=0 --set render.maxSpecularDepth=1 --set render.toneMap=soft
render weighed scenes/primer/26-importance.json --spp 16
render shutter-0 scenes/meshes/04-motion-blur.json --width 240 --set "render.shutter=[0,0]"
render shutter-half scenes/meshes/04-motion-blur.json --width 240
render shutter-1 scenes/meshes/04-motion-blur.json --width 240 --set "render.shutter=[0,1]"
for map in clamp soft reinhard aces agx; do
    render tone-$map scenes/primer/33-tone-mapping.json --width 240 --spp 64 --set render.toneMap=$map
done

denoised denoised scenes/primer/04-colour-bleeding.json --width 260 --spp 4
render noisy scenes/primer/04-colour-bleeding.json --width 260 --spp 4
render many scenes/primer/04-colour-bleeding.json --width 260 --spp 1024
