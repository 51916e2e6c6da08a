#!/bin/sh
# csharp.sh CSHARP LIBRARY FOLDER: compiles Taut.cs, the Unity component and their test, and runs it.
set -eu
here=$(dirname "$0")
mkdir -p "$3"
mcs -nologo -warnaserror -out:"$3/TestTaut.exe" "$1/Taut.cs" "$1/TautBehaviour.cs" "$here/UnityStubs.cs" "$here/TestTaut.cs"
LD_LIBRARY_PATH=$(dirname "$2") exec mono "$3/TestTaut.exe"
