#!/bin/sh
# test_picture_tests.sh CMAKE COMPARE SOURCE_FOLDER FOLDER
# Runs run_picture_test.cmake and accept.sh as the tests do, with a stand-in for the program that copies a
# picture, to see that they tell right from wrong and say what to do.
set -u
cmake=$1
compare=$2
source=$3
folder=$4
rm -rf "$folder"
build=$folder/build
drawn=$build/tests/golden
mkdir -p "$drawn" "$folder/sources"
cp "$source/accept.sh" "$folder/sources"
baselines=$folder/sources/baselines
page=$build/picture-failures.html
cp "$compare" "$drawn/compare_pictures"
printf 'one\ntwo\n' > "$drawn/picture_tests.txt"
picture=$source/baselines/tshirt.png
other=$source/baselines/obstacles.png
slightly_different=$source/baselines/tshirt_one_sample.png

cat > "$folder/taut" <<'END'
#!/bin/sh
echo "{\"versions\": {\"gl_renderer\": \"$RENDERER\"}}" > run.jsonl
cp "$PICTURE" actual.png
END
chmod +x "$folder/taut"

problems=0
# expect PASSES|FAILS|SKIPPED PATTERN NAME [definitions]: runs the test NAME.
expect() {
  wanted=$1; pattern=$2; name=$3
  shift 3
  said=$("$cmake" -DNAME="$name" -DTAUT="$folder/taut" -DCOMPARE="$compare" -DARGUMENTS='scene;--frames;0' "$@" \
    -DBASELINE="$baselines/$name.png" -DOUTPUT_DIR="$drawn/$name" -DBUILD_DIR="$build" \
    -DFAILURES_PAGE="$page" -P "$source/run_picture_test.cmake" 2>&1)
  code=$?
  result=PASSES
  [ $code -eq 0 ] || result=FAILS
  printf '%s\n' "$said" | grep -q '^SKIPPED: ' && result=SKIPPED
  [ $result = "$wanted" ] || complain "$name $result, expected $wanted: $said"
  printf '%s\n' "$said" | tr -s ' \n' ' ' | grep -Eq -e "$pattern" || complain "$name: no match for $pattern: $said"
}
complain() {
  problems=$((problems + 1))
  echo "$*"
}
accept() {
  sh "$folder/sources/accept.sh" "$build" "$@" > "$folder/accepted.txt" 2>&1
}

unset CI
export RENDERER='any renderer' PICTURE="$picture"
expect FAILS 'There is no baseline .*one.png.*Look at the candidate.*actual.png and accept it:.*accept.sh .*build one' one
[ -e "$drawn/one/actual.png" ] || complain "no candidate was written"
grep -q 'no baseline yet' "$page" || complain "the page lacks a missing baseline"
accept one two && complain "accepted a picture that was never drawn"
[ ! -e "$baselines/one.png" ] || complain "accepted in part"
accept one || complain "cannot accept: $(cat "$folder/accepted.txt")"
expect PASSES '' one
[ ! -e "$page" ] || complain "a test that passes is still on the page"

# The processor that drew the baseline has to draw the same bits; limits are for others.
PICTURE=$slightly_different
expect FAILS 'differ by more than 0' one '-DLIMIT=255;1;255' -DREASON=why
sed -i '2s/.*/another processor/' "$baselines/one.renderer.txt"

PICTURE=$other
expect FAILS 'differs from its baseline.*pixels.*differ by more than 2.*mean difference.*x [0-9]+ y [0-9]+ .*side_by_side.png.*picture-failures.html.*accept.sh .*build one' one
[ "$(printf '%s\n' "$said" | grep -c '  difference ')" -eq 10 ] || complain "not the ten worst pixels: $said"
for file in expected actual difference side_by_side; do
  [ -s "$drawn/one/$file.png" ] || complain "no $file.png"
done
for link in $(sed -n 's/.*src="\([^"]*\)".*/\1/p' "$page"); do
  [ -e "$build/$link" ] || complain "a broken link: $link"
done
[ "$(grep -o '<img' "$page" | wc -l)" -eq 5 ] || complain "the page does not show three pictures and two that swap"
expect FAILS 'no baseline' two
[ "$(grep -c '<h2>' "$page")" -eq 2 ] || complain "the page does not hold both failures"

expect PASSES '' one '-DLIMIT=255;1;255' -DREASON=why
PICTURE=$other
expect FAILS 'another than that of other pictures: why' one '-DLIMIT=2;0.0001;0.002' -DREASON=why
expect FAILS 'another picture than one' one -DMUST_DIFFER=ON
PICTURE=$slightly_different
expect PASSES 'told from one' one -DMUST_DIFFER=ON
PICTURE=$picture
expect FAILS 'passes for one, although' one -DMUST_DIFFER=ON
PICTURE=$folder/taut
expect FAILS 'cannot be compared' one
expect FAILS 'cannot be compared' one -DMUST_DIFFER=ON
PICTURE=/nowhere
expect FAILS 'taut render failed' one

PICTURE=$other RENDERER='another renderer'
expect SKIPPED "drawn by 'another renderer', the baseline by 'any renderer'" one
export CI=true
expect FAILS 'differs from its baseline' one
unset CI
rm -f "$baselines/one.renderer.txt"
expect SKIPPED "the baseline by 'unknown'" one

cp "$baselines/one.png" "$baselines/orphan.png"
expect FAILS 'no baseline' two
accept --all || complain "cannot accept all: $(cat "$folder/accepted.txt")"
[ ! -e "$baselines/orphan.png" ] || complain "a baseline without a test is still there"
[ "$(head -n 1 "$baselines/one.renderer.txt")" = 'another renderer' ] || complain "the renderer was not noted"
expect PASSES '' one
expect PASSES '' two

# A relaxed limit has to say why; `declare_test` runs the line a CMakeLists.txt would have.
declare_test() {
  cat > "$folder/declare.cmake" <<END
include($source/picture_test.cmake)
function(taut_internal_picture_test)
  message("declared \${ARGV}")
endfunction()
taut_add_picture_test($*)
END
  said=$("$cmake" -P "$folder/declare.cmake" 2>&1)
}
refused() {
  declare_test "$@" && complain "declared: $*"
  printf '%s\n' "$said" | tr -s ' \n' ' ' | grep -q 'picture test one: LIMIT needs three numbers and a REASON' ||
    complain "refused without saying why: $said"
}
refused one LIMIT 4 0.01 0.1 scene
refused one LIMIT 4 0.01 REASON '"two numbers only"' scene
refused one LIMIT 4 0.01 0.1 REASON '""' scene
declare_test one LIMIT 4 0.01 0.1 REASON '"an odd lamp"' scene || complain "refused: $said"
declare_test one scene || complain "refused: $said"
[ $problems -eq 0 ]
