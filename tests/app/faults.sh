#!/bin/sh
# Faults while the program runs: it ends with an error that says what, and files that exist are
# complete.   faults.sh PROGRAM FOLDER CASE
set -eu
program=$1 folder=$2 fault=$3
rm -rf "$folder"
mkdir -p "$folder/out"
cd "$folder"

fail() {
  echo "$1"
  cat said.txt
  ls -lA . out 2>/dev/null
  exit 1
}

# expect CODE PATTERN COMMAND...
expect() {
  code=$1 pattern=$2
  shift 2
  # Through a pipe, which has no limit of its own.
  { found=0; "$@" 2>&1 || found=$?; echo $found >code.txt; } | cat >said.txt
  found=$(cat code.txt)
  [ $found -eq "$code" ] || fail "exit code $found, expected $code"
  grep -Eq "$pattern" said.txt || fail "expected a message like: $pattern"
}

all_complete() {
  for picture in out/*.png; do
    [ ! -e "$picture" ] || tail -c 8 "$picture" | grep -q IEND || fail "$picture is incomplete"
  done
}

nothing_else() {
  [ -z "$(find out -type f ! -name '*.png')" ] || fail "unfinished files are left"
}

# Shadows are most of the work of a picture and no part of what is tested.
plain="--samples 1 --set picture.shadows=false"

# Takes the place of the shell that calls it, so that its process is the program's.
long() {
  exec "$program" render pinned-9x9-5 --frames 0:100000 --set rest.speed=0 --resolution 64,64 $plain \
    --output 'out/{frame:06}.png'
}

wait_for() {
  tries=0
  until [ -e "$1" ]; do
    tries=$((tries + 1))
    [ $tries -lt 3000 ] || fail "nothing was written"
    sleep 0.02
  done
}

film() {
  PATH="$folder/bin:$PATH" expect 1 "$1" "$program" render pinned-9x9-5 --frames 0:12 --resolution 640,480 \
    $plain --output out/film.mp4
  nothing_else
}

# fake_ffmpeg SHELL-COMMANDS; $file is what it is to make.
fake_ffmpeg() {
  mkdir -p bin
  printf '#!/bin/sh\nfor file; do :; done\nfile=${file#file:}\n%s\n' "$1" >bin/ffmpeg
  chmod +x bin/ffmpeg
}

case $fault in
  file_size)
    # A file that cannot grow beyond some blocks is like a disk that is full.
    expect 1 "cannot write 'out/[0-5].png': File too large" sh -c 'ulimit -f 4; exec "$@"' sh \
      "$program" render pinned-9x9-5 --resolution 320,240 $plain --frames 0:5 --output 'out/{frame}.png'
    expect 1 "cannot write 'out/run.jsonl': File too large" sh -c 'ulimit -f 1; exec "$@"' sh \
      "$program" simulate pinned-9x9-5 --frames 20 --stats out/run.jsonl
    expect 1 "cannot write 'out/[0-9]*.obj': File too large" sh -c 'ulimit -f 1; exec "$@"' sh \
      "$program" simulate pinned-9x9-5 --frames :20 --export 'out/{frame}.obj'
    nothing_else
    all_complete ;;
  full_device)
    [ -c /dev/full ] || { echo "SKIPPED: there is no /dev/full"; exit 77; }
    # By a link of the test's own, so that nothing can happen to the device.
    ln -s /dev/full full
    expect 1 "cannot write 'full': No space left" "$program" simulate pinned-9x9-5 --frames 2 --stats full
    [ -L full ] || fail "the link was replaced"
    expect 1 "cannot write to the standard output" sh -c 'exec "$@" >/dev/full' sh "$program" scenes ;;
  standard_output)
    # By a link of the test's own, since a program that renames would put a file in the place of /dev/stdout.
    ln -s /proc/self/fd/1 link
    "$program" simulate pinned-9x9-5 --frames 2 --stats link >said.txt
    [ -L link ] || fail "the link was replaced"
    grep -q '"summary"' said.txt && grep -q 'frames, .* ms of processor time each' said.txt || fail "no statistics, or nothing else" ;;
  folder_removed)
    long >said.txt 2>&1 &
    run=$!
    wait_for out/000010.png
    mv out gone
    code=0
    wait $run || code=$?
    [ $code -eq 1 ] || fail "exit code $code, expected 1"
    grep -q "cannot write 'out/.*png': No such file" said.txt || fail "expected a message"
    mv gone out
    nothing_else
    all_complete ;;
  killed)
    draw() {
      exec "$program" render pinned-9x9-5 --frames 0:200 --set rest.speed=0 --resolution 64,64 $plain \
        --output 'out/{frame:06}.png' "$@" >said.txt 2>&1
    }
    draw &
    run=$!
    wait_for out/000010.png
    kill -KILL $run
    wait $run || true
    [ ! -e out/000200.png ] || fail "the run ended before it was killed"
    all_complete ;;
  ffmpeg_stops)
    fake_ffmpeg 'head -c 3000000 >"$file"; echo "disk on fire" >&2; exit 3'
    film "ffmpeg stopped with exit code 3 after [0-9]+ frames: disk on fire" ;;
  ffmpeg_killed)
    fake_ffmpeg 'head -c 3000000 >"$file"; kill -KILL $$'
    film "ffmpeg stopped with signal 9 after [0-9]+ frames" ;;
  ffmpeg_stops_content)
    fake_ffmpeg 'head -c 3000000 >"$file"; exit 0'
    film "ffmpeg stopped with exit code 0 after [0-9]+ frames" ;;
  ffmpeg_fails_at_the_end)
    fake_ffmpeg 'cat >"$file"; exit 4'
    film "ffmpeg failed with exit code 4 after 13 frames" ;;
  ffmpeg_makes_nothing)
    fake_ffmpeg 'cat >/dev/null'
    film "ffmpeg failed with exit code 0 after 13 frames" ;;
  ffmpeg_hides_a_failure)
    fake_ffmpeg 'cat >"$file"; echo "Error writing trailer" >&2'
    film "ffmpeg failed with exit code 0 after 13 frames: Error writing trailer" ;;
  full_disk)
    # A disk of 20 kB of its own, which the process and its children alone see.
    unshare --mount true 2>/dev/null || { echo "SKIPPED: only root may mount"; exit 77; }
    for output in '--output out/film.mp4' '--output out/{frame}.png' '--stats out/run.csv' '--export out/{frame}.obj' \
      '--export out/a.pc2' '--export out/a.glb' '--export out/a.usda' '--checkpoint out/run.checkpoint'; do
      case $output in
        --output*) command="render --frames 0:60 --resolution 640,480 $plain" ;;
        *) command="simulate --frames 0:300 --set rest.speed=0" ;;
      esac
      expect 1 "No space left" unshare --mount sh -c 'mount -t tmpfs -o size=20k tmpfs out && "$@"
        code=$?; ls -A out >left.txt; for file in out/*.png out/*.csv out/*.obj; do [ -e "$file" ] && cp "$file" .; done
        exit $code' sh "$program" $command pinned-9x9-5 $output
      ! grep -Ev '^([0-9]+[.](png|obj)|run.csv|run.checkpoint)$' left.txt || fail "$output leaves more"
      for picture in *.png; do [ ! -e "$picture" ] || tail -c 8 "$picture" | grep -q IEND || fail "$picture is incomplete"; done
      for shape in *.obj; do [ ! -e "$shape" ] || [ "$(grep -c '^f' "$shape")" -eq 64 ] || fail "$shape is incomplete"; done
      [ ! -e run.csv ] || [ -z "$(tail -c 1 run.csv | tr -d '\n')" ] || fail "the table ends within a line"
      rm -f ./*.png ./*.obj ./*.csv
    done ;;
  *) fail "unknown fault $fault" ;;
esac
