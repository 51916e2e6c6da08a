#!/usr/bin/env bash
# Builds the page and the npm package. Usage: build.sh TAUT TAUT_IMPORT OUT
# Then OUT/page is the page, whole: any file server shows it, and a browser opens it from the disk. OUT/taut-cloth is the package.
set -euo pipefail
taut=$(realpath "$1") importer=$(realpath "$2") out=$(realpath -m "$3")
here=$(cd "$(dirname "$0")" && pwd)
assets=$here/../../../assets
for tool in emcmake esbuild; do
  command -v $tool >/dev/null || { echo "build.sh: there is no '$tool'; ./setup.sh --web installs it" >&2; exit 1; }
done
generated=$out/generated
mkdir -p "$generated" "$out/page" "$out/taut-cloth"

emcmake cmake -S "$here" -B "$out/engine" -G Ninja -DCMAKE_BUILD_TYPE=Release >"$out/configure.log" ||
  { cat "$out/configure.log" >&2; exit 1; }
cmake --build "$out/engine" -j "${CMAKE_BUILD_PARALLEL_LEVEL:-2}"
cp "$out/engine/taut.js" "$generated/taut.cjs"
python3 "$here/pack.py" "$importer" "$assets" "$out/engine/taut.wasm" "$generated"
if [ ! "$generated/hashes.json" -nt "$taut" ]; then
  python3 "$here/hashes.py" "$taut" "$generated/hashes.json"
fi

bundle() { esbuild "$1" --bundle --minify --log-level=warning "--alias:generated=$generated" "${@:2}"; }
bundle "$here/package/index.js" --format=esm --outfile="$out/taut-cloth/index.js"
bundle "$here/page/worker.js" --outfile="$generated/engine.js"
# The worker as a text: see main.js.
python3 -c 'import json, sys; print("globalThis.tautEngine=" + json.dumps(sys.stdin.read()) + ";")' \
  <"$generated/engine.js" >"$out/page/engine.js"
bundle "$here/page/main.js" --outfile="$out/page/page.js"

licence=$here/../../../LICENSE
cp "$here"/package/{index.d.ts,package.json,README.md} "$out/taut-cloth/"
cp "$here"/page/{index.html,style.css} "$out/page/"
for folder in page taut-cloth; do
  cp "$licence" "$out/$folder/LICENSE"
  cp "$assets/patterns/tshirt/LICENSE" "$out/$folder/LICENSE.garments"
  cp "$here/page/NOTICE" "$out/$folder/NOTICE"
done
echo "wrote $out/page and $out/taut-cloth"
