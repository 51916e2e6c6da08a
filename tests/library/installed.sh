#!/usr/bin/env bash
# installed.sh CMAKE SOURCES PREFIX COMMAND...: other programs build against the installed library, in C through pkg-config
# and in C++ through CMake, and run with what is installed alone. COMMAND is what hides the sources while they run.
set -euo pipefail
cmake=$1 sources=$2 prefix=$3
without_sources=("${@:4}")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
. "$(dirname "$0")/../support/fail.sh"
export PKG_CONFIG_PATH=$prefix/lib/pkgconfig LD_LIBRARY_PATH=$prefix/lib
cp "$sources/tests/library/consumer.cpp" "$sources/assets/garments/tshirt_1028.obj" "$folder"
cd "$folder"

flags=(-Wall -Wextra -pedantic -Werror)
cc -std=c99 "${flags[@]}" -o drape "$prefix/share/taut/examples/drape.c" $(pkg-config --cflags --libs taut) -Wl,--no-undefined
"${without_sources[@]}" ./drape | grep -q '^largest stretch 0\.[0-9]* % at 1.00 s$' || fail "drape.c does not say its stretch"

cat >CMakeLists.txt <<'END'
cmake_minimum_required(VERSION 3.16)
project(consumer CXX)
find_package(Taut 0.1 REQUIRED)
add_executable(consumer consumer.cpp)
target_link_libraries(consumer Taut::taut)
END
"$cmake" -B built -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_FLAGS="${flags[*]}" >log.txt && "$cmake" --build built >>log.txt ||
  fail "$(cat log.txt)"
"${without_sources[@]}" built/consumer "$folder/tshirt_1028.obj" | grep -qx '545 vertices, bound kept: 1' ||
  fail "the model is not read: $("${without_sources[@]}" built/consumer "$folder/tshirt_1028.obj")"
mv "$prefix/libexec/taut/taut-import" .
"${without_sources[@]}" built/consumer "$folder/tshirt_1028.obj" >log.txt && fail "without the importer a model is read"
grep -q "there is no program that reads models; expected '.*libexec/taut/taut-import'" log.txt ||
  fail "that there is no importer is said so: $(cat log.txt)"
mv taut-import "$prefix/libexec/taut"

python3 -m zipfile -l "$prefix/share/taut/taut_cloth.zip" >log.txt
for file in __init__.py taut/__init__.py fabrics/cotton.toml; do
  grep -q "^taut_cloth/$file " log.txt || fail "Blender's add-on has no $file"
done

for python in python3 /usr/bin/python3; do
  "$python" -c 'import numpy' 2>/dev/null || continue
  PYTHONPATH=$prefix/lib/python3/dist-packages LD_LIBRARY_PATH= "${without_sources[@]}" \
    "$python" -B "$prefix/share/taut/examples/drape.py" | grep -q '^1.00 s 0\.[0-9]* % #' || fail "drape.py does not plot"
  break
done
