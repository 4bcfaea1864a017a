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
    flags=$(PKG_CONFIG_PATH=$prefix/lib/pkgconfig pkg-config --cflags --libs tiltrotor)
else
    flags=$(sed -n 's/^Cflags: //p; s/^Libs: //p' "$file" |
        sed "s|\${includedir}|$prefix/include|g; s|\${libdir}|$prefix/lib|g" | tr '\n' ' ')
fi

strict="-Wall -Wextra -Wpedantic -Werror -O1"
${CC:-cc} -std=c99 $strict trim_and_fly.c $flags -o trim_and_fly
${CC:-cc} -std=c99 $strict rig.c $flags -o rig
${CC:-cc} -std=c99 $strict autopilot.c $flags -o autopilot
${CXX:-c++} -std=c++17 $strict trim_curve.cpp $flags -o trim_curve
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
