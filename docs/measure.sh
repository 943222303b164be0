#!/usr/bin/env bash
# Measures again what stands between "<!-- measured: COMMAND | SECTION -->" and "<!-- end of measured -->" in the pages that are named, or in
# all of them. A command with a SECTION writes a page into FOLDER, whose tables of that section are shown, and charts, which replace those of
# the same name; what any other command prints is shown. Run it from the repository's root, on a machine that does nothing else.
set -euo pipefail
pages=("$@")
[ $# -gt 0 ] || mapfile -t pages < <(grep -l '^<!-- measured: ' docs/*.md)
dotnet build -c Release src/RayTracer.Cli > /dev/null
dotnet build -c Release tests/RayTracer.Benchmarks > /dev/null
PATH=$PWD/src/RayTracer.Cli/bin/Release/net10.0:$PATH
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

# Prints the figures of a block; each command runs once.
figures() {
    local command=${1% | *} folder
    folder=$work/$(cksum <<< "$command" | tr ' ' -)
    if [ ! -d "$folder" ]; then
        mkdir "$folder"
        echo "$command" >&2
        eval "${command//FOLDER/$folder}" > "$folder/printed"
    fi
    if [ "$command" = "$1" ]; then
        cat "$folder/printed"
    else
        awk -v heading="## ${1##* | }" '/^## / { wanted = $0 == heading } wanted && /^\|/' "$folder/index.md"
    fi
}

for page in "${pages[@]}"; do
    inside=
    while IFS= read -r line; do
        case $line in
            '<!-- end of measured -->') inside= ;;&
            '<!-- measured: '*)
                spec=${line#<!-- measured: }
                printf '%s\n\n%s\n\n' "$line" "$(figures "${spec% -->}")"
                inside=yes ;;
            *) [ -n "$inside" ] || printf '%s\n' "$line" ;;
        esac
    done < "$page" > "$work/page"
    cat "$work/page" > "$page"
done
for chart in "$work"/*/*.svg; do
    [ ! -e "$chart" ] || find docs -name "$(basename "$chart")" -exec cp "$chart" {} \;
done
