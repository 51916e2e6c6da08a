#!/usr/bin/env bash
# The wheel in a virtual environment with nothing else in it, without a network: it simulates and draws, with the bits and the
# picture of the program, and in Debian's Python its arrays are numpy's. Usage: wheel.sh FOLDER_OF_WHEEL TAUT COMPARE_PICTURES
set -euo pipefail
wheel=$(echo "$1"/taut_cloth-*.whl)
taut=$2 compare=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
fail() { echo "wheel.sh: $*" >&2; exit 1; }
[ "$(stat -c %s "$wheel")" -lt 8000000 ] || fail "the wheel has $(stat -c %s "$wheel") bytes, expected fewer than 8000000"

# RHEL 9 has glibc 2.34 and Ubuntu 22.04 2.35.
[[ $wheel == *-manylinux_2_34_x86_64.whl ]] || fail "$wheel, expected to run on glibc 2.34"

unset TAUT_LIBRARY TAUT_IMPORTER TAUT_ASSETS PYTHONPATH
/usr/bin/python3 -m venv bare
unshare -n bare/bin/pip install --quiet --no-index "$wheel"
# Packages of the build machine must not stand in for what is missing.
libraries=$(echo bare/lib/python3*/site-packages/taut_cloth/lib)
[ -f "$libraries/../py.typed" ] || fail "its annotations do not count: there is no py.typed"
for file in "$libraries"/* "$libraries"/../libexec/taut/taut-import; do
  if objdump -T "$file" | grep -F '*UND*' | grep -E 'GLIBC_2\.(3[5-9]|[4-9][0-9])'; then fail "$file needs a newer glibc"; fi
  ldd "$file" | awk '$3 ~ /^\// && $3 !~ /taut_cloth/ {print $1}' |
    grep -Ev '^(libc|libm|libstdc\+\+|libgcc_s|libz)\.so' && fail "$file needs more than every Linux has"
done
unshare -n bare/bin/python3 -m taut_cloth --wind 10 --frames 60 -o shirt.png --set garment.file=tshirt_1028 | tee said.txt
"$taut" render tshirt-gravity --set garment.file=tshirt_1028 --set wind.speed=10 --set 'wind.direction=[0.3, 0.0, 1.0]' \
  --resolution 640,640 --frames 60 -o program.png --stats stats.csv >/dev/null
hash=$(tail -n 1 stats.csv | grep -oE '\b[0-9a-f]{16}\b') || fail "no hash in the statistics"
grep -q "$hash" said.txt || fail "the program has the state $hash"
"$compare" program.png shirt.png . 0 0 0 || fail "the program draws another picture"
cp shirt.png "$1/"

# Libraries that cannot be loaded stand before those of the machine.
mkdir broken
touch broken/lib{OSMesa.so,OSMesa.so.6,OSMesa.so.8,EGL.so,EGL.so.1}
LD_LIBRARY_PATH=broken bare/bin/python3 -m taut_cloth --frames 1 -o none.png >said.txt 2>error.txt && fail "it draws without OpenGL"
grep -q '^1 frames in .* s: the largest stretch is' said.txt || fail "without OpenGL it does not simulate"
grep -q '^taut_cloth: cannot draw: .*(apt install libosmesa6)' error.txt || fail "$(cat error.txt)"

PYTHONPATH=$(dirname "$(dirname "$libraries")") /usr/bin/python3 - <<'END'
import numpy, taut_cloth
with taut_cloth.Cloth('tshirt', settings={'wind.direction': numpy.array([0.0, 0.0, 1.0])}) as cloth:
    start = cloth.positions()
    assert isinstance(start, numpy.ndarray) and start.shape == (cloth.info.vertex_count, 3)
    cloth.step(5)
    assert numpy.allclose(cloth.positions(), cloth.shape()[0], atol=0) and (cloth.positions() != start).any()
END
bare/bin/python3 - <<'END'
import taut_cloth
with taut_cloth.Cloth('tshirt') as cloth:
    try:
        cloth.positions()
    except taut_cloth.Error as error:
        assert 'numpy' in str(error), error
    else:
        raise SystemExit('arrays without numpy')
END
