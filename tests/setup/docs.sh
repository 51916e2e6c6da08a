#!/usr/bin/env bash
# docs.sh TAUT SOURCES: the site of the documentation is made, no link of it is broken, and a broken one is noticed.
set -euo pipefail
taut=$1 sources=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
. "$(dirname "$0")/../support/fail.sh"
command -v mkdocs >/dev/null || {
  echo "SKIPPED: there is no MkDocs here; ./setup.sh --docs brings it"
  exit 77
}
python3 -B "$sources/app/install/docs.py" "$sources" "$taut" "$folder/site"
links() {
  python3 -B "$sources/tests/setup/site_links.py" "$folder/site"
}
links || fail "links are broken"
for page in gallery:figure5.png options:--supersampling keys:wind.speed statistics:max_stretch c:taut_create python:Cloth; do
  grep -qF -e "${page#*:}" "$folder/site/reference/${page%%:*}.html" || fail "the page ${page%%:*} lacks ${page#*:}"
done
if command -v chromium >/dev/null; then
  chromium --headless=new --no-sandbox --disable-gpu --virtual-time-budget=5000 --dump-dom \
    "file://$folder/site/index.html?q=taut_create+scene" 2>/dev/null >"$folder/found.html"
  grep -qF "href=\"file://$folder/site/reference/c.html" "$folder/found.html" || fail "the search finds no taut_create"
fi
rm "$folder/site/reference/c.html"
! links >/dev/null || fail "a page that is gone is not noticed"
