#!/usr/bin/env bash
# package.sh CPACK BUILD: Debian's packages have the program, the library, what other programs build with, the Python
# module and the add-on, each in its own; lintian warns of none of them; desktops and software centres can read what they
# ask for. apt finds all in the folder that app/install/apt_folder.sh makes.
set -euo pipefail
build=$1 sources=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
. "$(dirname "$0")/../support/fail.sh"

for tool in apt-ftparchive lintian appstreamcli desktop-file-validate; do
  command -v $tool >/dev/null || {
    echo "SKIPPED: there is no $tool here; ./setup.sh brings it"
    exit 77
  }
done
"$sources/app/install/apt_folder.sh" "$build" "$folder" || fail "no packages"

# has PACKAGE FILE...: the package has these files, its own documents, and nothing that another has.
: >"$folder/all.txt"
has() {
  local name=$1
  shift
  local file package
  package=$(echo "$folder/$name"_*.deb)
  [ -f "$package" ] || fail "there is no package $name"
  dpkg-deb --contents "$package" >"$folder/files.txt"
  for file in "$@" "share/doc/$name/copyright" "share/doc/$name/changelog.gz"; do
    grep -qE " \./usr/$file( -> .*)?$" "$folder/files.txt" || fail "the package $name lacks /usr/$file"
  done
  ! grep -v ' \./usr/\| \./$' "$folder/files.txt" || fail "the package $name has files outside /usr"
  grep '^-' "$folder/files.txt" | awk '{print $6}' >>"$folder/all.txt"
  [ "$name" = libtaut1 ] || dpkg-deb --field "$package" Depends | grep -q "libtaut1 (= " ||
    fail "the package $name does without libtaut1 of its version"
}
has taut bin/taut share/man/man1/taut.1.gz share/bash-completion/completions/taut \
  share/metainfo/taut.metainfo.xml share/applications/taut.desktop
has libtaut1 lib/libtaut.so.1 libexec/taut/taut-import share/taut/scenes/tshirt.toml share/taut/sweeps/Snakefile
has libtaut-dev include/taut.h lib/libtaut.so 'lib/[^/]*-linux-gnu/pkgconfig/taut.pc' lib/cmake/Taut/TautConfig.cmake share/taut/csharp/Taut.cs
has python3-taut lib/python3/dist-packages/taut/__init__.py
has blender-taut share/taut/taut_cloth.zip
[ "$(ls "$folder"/*.deb | wc -l)" = 5 ] || fail "expected five packages, found $(ls "$folder"/*.deb)"
twice=$(sort "$folder/all.txt" | uniq -d)
[ -z "$twice" ] || fail "in two packages: $twice"
lintian --fail-on error,warning "$folder"/*.deb || fail "lintian objects"

dpkg-deb --extract "$folder"/taut_*.deb "$folder/files"
share=$folder/files/usr/share
said=$(desktop-file-validate "$share/applications/taut.desktop") && [ -z "$said" ] || fail "the desktop file: $said"
said=$(appstreamcli validate --no-net --pedantic "$share/metainfo/taut.metainfo.xml") || fail "the metainfo: $said"
version=$(dpkg-deb --field "$folder"/taut_*.deb Version)
grep -q "<release version=\"$version\"" "$share/metainfo/taut.metainfo.xml" || fail "the metainfo is not of version $version"

# apt reads the folder with lists of its own, apart from those of this machine.
mkdir -p "$folder/lists/partial"
echo "deb [trusted=yes] file:$folder ./" >"$folder/taut.list"
apt=(-o Dir::Etc::SourceList="$folder/taut.list" -o Dir::Etc::SourceParts=- -o Dir::State::Lists="$folder/lists"
  -o Dir::Cache::pkgcache= -o Dir::Cache::srcpkgcache= -o APT::Sandbox::User=)
apt-get "${apt[@]}" -o Debug::NoLocking=1 update >"$folder/log.txt" 2>&1 || fail "$(cat "$folder/log.txt")"
for name in taut libtaut1 libtaut-dev python3-taut blender-taut; do
  [[ $(apt-cache "${apt[@]}" policy "$name") == *"Candidate: $version"* ]] || fail "apt does not know $name"
done
