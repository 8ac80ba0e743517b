#!/usr/bin/env bash
# Fetches what the drawings are made of, at the versions they were made from, into the folder SOURCES, by npm.
# Usage: fetch.sh SOURCES
set -euo pipefail

sources=${1:?usage: fetch.sh SOURCES}
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
mkdir -p "$sources"
cd "$sources"

npm install --no-save --ignore-scripts world-atlas@2.0.2 @mdi/svg@7.4.47 lucide-static@1.62.0 dejavu-fonts-ttf@2.37.3 \
    @dicebear/core@9.4.3 @dicebear/open-peeps@9.4.3

cp node_modules/world-atlas/{countries-110m,land-50m}.json node_modules/dejavu-fonts-ttf/ttf/DejaVuSans.ttf .
cp "$here/gauge.svg" "$here/../../../examples/assets/world.svg" .
ln -sfn node_modules/@mdi/svg/svg mdi
ln -sfn node_modules/lucide-static/icons lucide
cp "$here/peeps.mjs" .
node peeps.mjs
