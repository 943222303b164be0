#!/usr/bin/env bash
# Restores the desktop's head with all of Avalonia, opens its window on a screen that nobody sees, renders scene 1 of the report, and keeps a screenshot.
# usage: tests/desktop-full.sh [SCREENSHOT.png]. Exit status: 0 fine, 1 not, 77 where Avalonia or what else is needed cannot be had.
set -uo pipefail
cd "$(dirname "$0")/.."
export DOTNET_CLI_TELEMETRY_OPTOUT=1 DOTNET_NOLOGO=1 AVALONIA_TELEMETRY_OPTOUT=1
screenshot=$(realpath -m "${1:-desktop.png}")
work=$(mktemp -d)
server=
window=

end() {
    [ -n "$window" ] && kill "$window" 2> /dev/null
    [ -n "$server" ] && kill "$server" 2> /dev/null
    rm -rf "$work"
}
trap end EXIT

# Restoring for the other mode again afterwards is up to whoever needs it.
build=(-p:AvaloniaPackages=full)
if ! dotnet restore src/RayTracer.Desktop "${build[@]}" > "$work/restore.log" 2>&1; then
    echo "cannot restore: $(grep -m 1 -o 'error NU[0-9]*: [^[]*' "$work/restore.log" || tail -n 1 "$work/restore.log")"
    exit 77
fi

for tool in Xvfb import; do
    if ! command -v "$tool" > /dev/null; then
        echo "cannot take a screenshot: there is no $tool"
        exit 77
    fi
done

dotnet build -c Release -v q --no-restore src/RayTracer.Desktop "${build[@]}" || exit 1
display=:$((90 + RANDOM % 100))
Xvfb "$display" -screen 0 1400x900x24 > "$work/screen.log" 2>&1 &
server=$!
sleep 2

# The user's own folders are left alone.
export DISPLAY=$display XDG_STATE_HOME=$work/state XDG_CACHE_HOME=$work/cache
dotnet src/RayTracer.Desktop/bin/Release/net10.0/RayTracer.Desktop.dll scenes/report/scene1.json > "$work/out.log" 2>&1 &
window=$!
sleep 30
if ! kill -0 "$window" 2> /dev/null; then
    echo "the window has gone:"
    cat "$work/out.log"
    exit 1
fi

import -window root "$screenshot" || exit 1

# Of one colour, there is no window.
colours=$(identify -format %k "$screenshot")
echo "the window shows $colours colours: $screenshot"
[ "$colours" -gt 100 ]
