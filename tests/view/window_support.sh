# For the tests of a real window: sourced with the program in $taut, inside a display of their own.
fail() { echo "$1" >&2; cat window.log >&2; exit 1; }
move() { xdotool mousemove "$1" "$2"; sleep 0.06; }
drag() {  # from x y to x y in steps; the button stays down
  move "$1" "$2"
  xdotool mousedown 1
  for step in 1 2 3 4 5 6; do
    move $(($1 + ($3 - $1) * step / 6)) $(($2 + ($4 - $2) * step / 6))
  done
}
press() { xdotool key "$1"; sleep 0.25; }
wait_for() {  # what, then a command that has to succeed within half a minute
  what=$1
  shift
  for attempt in $(seq 300); do
    "$@" && return
    sleep 0.1
  done
  fail "there is no $what"
}
wait_for_file() { wait_for "$1" test -e "$1"; }
# A scene's name and a line: saves the scene until it has the line. On a busy machine a frame may take seconds, and the
# simulation does what it is told later than the window.
save_until() {
  for attempt in $(seq 60); do
    press s
    newest=$(ls -t "$1"-*.toml 2>/dev/null | head -n 1)
    [ -n "$newest" ] && grep -q "$2" "$newest" && return
  done
  fail "no saved scene $1 has the line $2"
}
# x and y of a part of the panel, X of 10 across it; layout.txt has to be there.
place() { awk -v name="$1" -v part="$2" '$1 == name { print int($2 + ($4 - $2) * part / 10), int(($3 + $5) / 2) }' layout.txt; }
