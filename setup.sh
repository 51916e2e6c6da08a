#!/usr/bin/env bash
# Installs every system package Taut needs, on Debian 12 or newer and its relatives. Run it again at any
# time: when all is there it does nothing. With --blender also Blender, for the tests behind TAUT_BLENDER_TESTS, and F3D,
# both for pictures beside ours; with --bench Bullet, for the race behind TAUT_BENCH; with --sweeps Snakemake,
# for assets/sweeps; with --web emscripten and Chromium, for the page; with --image podman, for the image of containers;
# with --docs MkDocs, for the documentation as a site.
set -euo pipefail

packages=(
  # build
  build-essential
  clang               # the tests compare the states that two compilers' programs end in,
  libc++-dev          # and two standard libraries'
  libc++abi-dev
  libclang-rt-dev     # libFuzzer and the sanitizers for Clang
  cmake
  ninja-build
  pkg-config
  # libraries
  libassimp-dev       # reads models
  libcairo2-dev       # text and page composition
  libcli11-dev
  libdeflate-dev      # compresses PNG for stb
  libeigen3-dev       # solves sparse systems
  libfmt-dev
  libfontconfig-dev   # finds the window's font
  libglfw3-dev        # the window
  libglm-dev
  libgmp-dev          # rational numbers of any length: whether triangles cross, exactly
  libhwy-dev          # Highway: vectors of any width
  libimgui-dev        # what is in it
  libopenmesh-dev     # half-edges, to mesh garments anew
  libseccomp-dev      # confines the reader of models
  libstb-dev          # writes PNG, and the tests read it
  libegl1             # OpenGL without a display or a GPU
  libegl-mesa0
  libgl1-mesa-dri
  libtomlplusplus-dev
  libx11-dev          # the tests drop files on the window
  nlohmann-json3-dev
  python3-glad        # generates the OpenGL loader
  # fonts
  fontconfig
  fonts-dejavu-core
  # videos
  ffmpeg
  # tests
  libgtest-dev
  librapidcheck-dev   # properties of random cases
  python3             # makes models of every format, and is a terminal
  python3-jsonschema  # checks the schema of patterns
  python3-numpy       # the library's Python
  python3-venv        # the wheel in an empty environment
  mono-mcs            # and its C#
  mono-runtime
  abigail-tools       # whether its interface has changed
  dpkg-dev            # packages, and
  file                # what of them needs libraries
  lintian             # judges them,
  appstream           # what software centres say of the program,
  desktop-file-utils  # and what desktops start
  apt-utils           # makes a folder of packages that apt reads
  git                 # tests/fresh_machine.sh clones with it
  debootstrap         # and makes a bare Debian
  patchelf            # has the libraries of a wheel find each other
  xdotool             # keys and pointer for a window
  xvfb                # a display for it
  xauth               # what xvfb-run asks for and no package brings
)

packages_of_blender=(
  blender
  f3d                 # assets/tools/pictures/beside_others.sh puts both beside ours
)
packages_of_web=(
  emscripten          # the engine as WebAssembly
  node-acorn          # what its linker asks for and does not bring
  libboost-dev        # rational numbers of any length, there
  esbuild
  chromium            # and the tests drive it
  chromium-driver
  python3-selenium
)
packages_of_docs=(
  mkdocs-material     # the documentation as a site
)
packages_of_image=(
  mmdebstrap          # makes the file system of a container's image
  podman              # and the tests run it
)
packages_of_bench=(
  libbullet-dev       # what tests/study/bench compares with
)
packages_of_sweeps=(
  snakemake           # with what it needs 700 MB
)
for wanted in "$@"; do
  case $wanted in
    --blender) packages+=("${packages_of_blender[@]}") ;;
    --bench) packages+=("${packages_of_bench[@]}") ;;
    --docs) packages+=("${packages_of_docs[@]}") ;;
    --image) packages+=("${packages_of_image[@]}") ;;
    --sweeps) packages+=("${packages_of_sweeps[@]}") ;;
    --web) packages+=("${packages_of_web[@]}") ;;
    *)
      echo "usage: setup.sh [--blender] [--bench] [--docs] [--image] [--sweeps] [--web]" >&2
      exit 2
      ;;
  esac
done

# Another way to OpenGL without a display, gone from distributions with Mesa 25.1 or newer.
packages_if_offered=(
  libosmesa6
)

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "setup.sh knows Debian and Ubuntu only. On this system, install the counterparts of:" >&2
  printf '  %s\n' "${packages[@]}" >&2
  exit 1
fi

is_installed() {
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null || true)" = installed ]
}

as_root=()
update_lists() {
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "setup.sh: not root and no sudo here. Have an administrator install: ${missing[*]}" >&2
      exit 1
    fi
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get update -qq
}

missing=()
for package in "${packages[@]}"; do
  is_installed "$package" || missing+=("$package")
done
# The image of a container comes without lists, and would offer nothing.
[ ${#missing[@]} -eq 0 ] || update_lists
for package in "${packages_if_offered[@]}"; do
  is_installed "$package" || [ -z "$(apt-cache --names-only search "^$package\$")" ] || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
  exit 0
fi

update_lists
echo "Installing: ${missing[*]}"
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
  "${missing[@]}"
