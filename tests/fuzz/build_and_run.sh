#!/bin/sh
# Builds one fuzz target with Clang, libFuzzer and the sanitizers, and runs it for some seconds over its corpus.
# build_and_run.sh SOURCE_FOLDER BUILD_FOLDER TARGET SECONDS
set -eu
source=$1 build=$2 target=$3 seconds=$4
corpus=$source/tests/fuzz/corpus/$target
mkdir -p "$build/include" "$build/found_$target"
for folder in sim renderer app; do
  ln -sfn "$source/$folder" "$build/include/$folder"
done
case $target in
  fuzz_mesh) sources=$(find "$source/sim" -name '*.cpp') libraries=-lhwy ;;
  fuzz_arrays) sources=$source/app/garment/model_arrays.cpp libraries= ;;
esac
export FLAGS="-std=c++20 -O1 -g -ffp-contract=off \
  -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=undefined -I$build/include"
rm -rf "$build/$target.objects"
mkdir -p "$build/$target.objects"
# Names in the objects' folder are the sources' checksums: two folders hold a file of the same name.
# shellcheck disable=SC2016,SC2086
printf '%s\n' "$source/tests/fuzz/$target.cpp" $sources | xargs -P "$(nproc)" -I{} \
  sh -c 'clang++ $FLAGS -c {} -o "$0/$(echo {} | cksum | cut -d" " -f1).o"' "$build/$target.objects"
# shellcheck disable=SC2086
clang++ $FLAGS "$build/$target.objects"/*.o $libraries -o "$build/$target"
cd "$build"
"./$target" -max_total_time="$seconds" -rss_limit_mb=2048 -timeout=10 -print_final_stats=0 -verbosity=0 \
  "$build/found_$target" "$corpus"
