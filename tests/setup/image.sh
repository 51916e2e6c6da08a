#!/usr/bin/env bash
# image.sh BUILD SOURCES [IMAGE]: the image for containers has at most 150 MB, podman loads it, and it draws a picture into
# a mounted folder. Where the system lets podman start nothing, the test is skipped with podman's reason. IMAGE: one that is
# there already. Needs root and a mirror of Debian.
set -euo pipefail
build=$1 sources=$2 image=${3-}
max_bytes=150000000
. "$(dirname "$0")/../support/fail.sh"
skip() {
  echo "SKIPPED: $*"
  exit 77
}
for tool in podman mmdebstrap apt-ftparchive; do
  command -v $tool >/dev/null || skip "there is no $tool here; ./setup.sh --image brings it"
done
[ "$(id -u)" -eq 0 ] || skip "this user is not root"
folder=$(mktemp -d)
export XDG_RUNTIME_DIR=$folder/run
podman=(podman --root "$folder/images" --runroot "$folder/run/podman" --storage-driver vfs --cgroup-manager cgroupfs)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/run" "$folder/work"

if [ -z "$image" ]; then
  image=$folder/taut.tar
  apt-get indextargets --format '$(REPO_URI)' | grep -q debian || skip "apt knows no mirror of Debian"
  "$sources/app/install/apt_folder.sh" "$build" "$folder/apt" || fail "no packages"
  python3 -B "$sources/app/install/oci_image.py" "$folder/apt" "$image" || fail "no image"
fi
size=$(stat -c %s "$image")
[ "$size" -le $max_bytes ] || fail "the image has $size bytes, expected at most $max_bytes"
"${podman[@]}" load -q -i "$image" >"$folder/log.txt" 2>&1 || fail "$(cat "$folder/log.txt")"
name=$("${podman[@]}" images --format '{{.Repository}}:{{.Tag}}')
[[ $name == localhost/taut:[0-9]* ]] || fail "the image is named $name"

limit=$(ulimit -Hn)  # podman asks for more, which not every machine grants
run=("${podman[@]}" run --rm --cgroups=disabled --network=none --ulimit "nofile=$limit:$limit" --ulimit nproc=4000:4000
  -v "$folder/work:/work" "$name" render tshirt-wind-10 --frames 10 -o /work/a.png)
# crun starts nothing where both versions of cgroups are mounted: in a mount namespace of its own there is one.
reason=$("${run[@]}" 2>&1) ||
  reason=$(unshare --mount sh -c 'mount -t cgroup2 cgroup2 /sys/fs/cgroup 2>/dev/null; exec "$@"' sh "${run[@]}" 2>&1) || {
  [[ $reason == *"OCI runtime"* || $reason == *"OCI permission"* ]] || fail "podman run: $reason"
  skip "$size bytes, but podman starts nothing here: $reason"
}
[ "$(head -c 4 "$folder/work/a.png" | tail -c 3)" = PNG ] || fail "there is no picture"
