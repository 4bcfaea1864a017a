#!/bin/sh
# check.sh PREFIX: copies the examples away from the source tree, builds them with what is installed at PREFIX, runs them.
set -eu
prefix=$1
here=$(cd "$(dirname "$0")" && pwd)
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
cp "$here"/*.c "$here"/*.cpp "$room"
cd "$room"

# pkg-config when there is one; its file is simple enough to read without.
file=$prefix/lib/pkgconfig/tiltrotor.pc
if command -v pkg-config >/dev/null; then
    cflags=$(PKG_CONFIG_PATH=$prefix/lib/pkgconfig pkg-config --cflags tiltrotor)
    libs=$(PKG_CONFIG_PATH=$prefix/lib/pkgconfig pkg-config --libs tiltrotor)
else
    cflags=$(sed -n 's/^Cflags: //p' "$file" | sed "s|\${includedir}|$prefix/include|g")
    libs=$(sed -n 's/^Libs: //p' "$file" | sed "s|\${libdir}|$prefix/lib|g")
fi
case "$cflags" in *-march*) echo "tiltrotor.pc demands the processor it was built on: $cflags"; exit 1 ;; esac
# Quotes in the file stand for a prefix with blanks.
build() { eval "$1 $cflags $2 $libs -o $3"; }

strict="-Wall -Wextra -Wpedantic -Werror -O1"
c="${CC:-cc} -std=c99 $strict"
build "$c" trim_and_fly.c trim_and_fly
build "$c" rig.c rig
build "$c" autopilot.c autopilot
build "${CXX:-c++} -std=c++17 $strict" trim_curve.cpp trim_curve
${RUNNER:-} ./trim_and_fly
${RUNNER:-} ./trim_curve
${RUNNER:-} ./autopilot 2

# One second in real time with controls that change, recorded; then three replays as fast as possible.
{ echo "0.17 1.0 0.0 0.0"; sleep 0.3; echo "0.175 1.2 0.1 0.0"; sleep 0.3; echo "0.175 nonsense"; echo "0.17 1 0 9"; } |
    ${RUNNER:-} ./rig --rate 200 --seconds 1 --record flown.txt | tee first.txt
for replay in 1 2 3; do
    ${RUNNER:-} ./rig --rate 200 --seconds 1 --fast <flown.txt | grep '^hash' >replayed.txt
    grep '^hash' first.txt | cmp - replayed.txt || { echo "rig: replay $replay differs"; exit 1; }
done
echo "rig: three replays bit for bit"
grep -q 'refused_inputs 2 ' first.txt || { echo "rig: two bad inputs were not refused"; exit 1; }

# The same program beside a file of C++ that includes the headers, compiled in its own way and never called; with the
# library archived and shared.
eval "$c $cflags -c rig.c -o rig.o"
for how in "-O0" "-O1 -march=native"; do
    echo 'int main() {}' | ${CXX:-c++} $how -x c++ - -o /dev/null 2>/dev/null || continue
    eval "${CXX:-c++} -std=c++17 $how -Dmain=never_called $cflags -c trim_curve.cpp -o beside.o"
    for library in "$prefix"/lib/libtiltrotor.a "$prefix"/lib/libtiltrotor.so; do
        [ -e "$library" ] || continue
        ${CXX:-c++} rig.o beside.o "$library" "$prefix/lib/libtiltrotor-aircraft.a" -Wl,-rpath,"$prefix/lib" -lm -o mixed
        ${RUNNER:-} ./mixed --rate 200 --seconds 1 --fast <flown.txt | grep '^hash' >replayed.txt
        grep '^hash' first.txt | cmp - replayed.txt || { echo "rig: a C++ file with $how changes the flight of $library"; exit 1; }
    done
done
if eval "${CXX:-c++} -std=c++17 -ffast-math $cflags -fsyntax-only trim_curve.cpp" 2>refused.txt; then
    echo "trim_curve: -ffast-math was not refused"
    exit 1
fi
grep -q 'tiltrotor needs IEEE arithmetic' refused.txt
echo "rig: the same bits beside C++ with other flags; -ffast-math is refused"
