#!/usr/bin/env bash
# apt_folder.sh BUILD FOLDER: makes the packages of a build and what apt asks of a server beside them, static files that can
# lie on a disk or a web host: deb [trusted=yes] file:/FOLDER ./
set -euo pipefail
if [ $# -ne 2 ]; then
  sed -n '2,3s/^# //p' "$0" >&2
  exit 2
fi
build=$(cd "$1" && pwd)
mkdir -p "$2"
cd "$2"
rm -rf -- *.deb _CPack_Packages  # of an earlier version
cpack --config "$build/CPackConfig.cmake" -G DEB -B "$PWD" >log.txt 2>&1 || {
  cat log.txt >&2
  exit 1
}
rm -rf _CPack_Packages log.txt
apt-ftparchive packages . >Packages
gzip -9kf Packages
apt-ftparchive -o APT::FTPArchive::Release::Origin=Taut -o APT::FTPArchive::Release::Label=Taut \
  -o APT::FTPArchive::Release::Architectures="$(dpkg --print-architecture) all" release . >Release.part
mv Release.part Release
