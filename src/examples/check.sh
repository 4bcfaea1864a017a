#!/bin/sh
# check.sh PREFIX: copies the examples away from the source tree, builds them with what is installed at PREFIX, runs them.
set -eu
prefix=$1
here=$(cd "$(dirname "$0")" && pwd)
room=$(mktemp -d)
trap 'kill $(jobs -p) 2>/dev/null || true; rm -rf "$room"' EXIT
cp "$here"/*.c "$here"/*.h "$here"/*.cpp "$here"/hop.txt "$here"/mission.txt "$room"
cp -r "$here"/cmake "$here"/python "$room"
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
[ -s "$prefix/share/doc/tiltrotor/LICENSE" ] || { echo "no licence is installed"; exit 1; }
case "$cflags" in *-march*) echo "tiltrotor.pc demands the processor it was built on: $cflags"; exit 1 ;; esac
# Quotes in the file stand for a prefix with blanks.
build() { eval "$1 $cflags $2 $libs -o $3"; }

strict="-Wall -Wextra -Wpedantic -Werror -O1"
c="${CC:-cc} -std=c99 $strict"
build "$c" trim_and_fly.c trim_and_fly
build "$c" "rig.c rig_text.c ground_start.c" rig
build "$c" autopilot.c autopilot
build "$c" "flightgear.c rig_text.c ground_start.c" flightgear
build "$c" "ardupilot.c ground_start.c" ardupilot
build "$c" peer.c peer
build "${CXX:-c++} -std=c++17 $strict" trim_curve.cpp trim_curve
${RUNNER:-} ./trim_and_fly
${RUNNER:-} ./trim_curve
${RUNNER:-} ./autopilot 2

# The same by CMake, and from Python; what is not installed is left out in one line.
if [ -n "${RUNNER:-}" ]; then
    echo "cmake, python: libraries of another machine, left out"
elif ! command -v cmake >/dev/null; then
    echo "cmake: not installed: cmake (Debian: cmake), left out"
else
    CC="${CC:-cc}" CXX="${CXX:-c++}" cmake -S cmake -B cmake/built -DCMAKE_PREFIX_PATH="$prefix" >cmake.txt && cmake --build cmake/built >>cmake.txt || { cat cmake.txt; exit 1; }
    cmake/built/example && cmake/built/example_cpp
    ./trim_and_fly >by_hand.txt
    cp trim_and_fly.c cmake/example.c
    cmake --build cmake/built >cmake.txt || { cat cmake.txt; exit 1; }
    cmake/built/example | cmp - by_hand.txt
    mkdir refused
    printf '%s\n' 'cmake_minimum_required(VERSION 3.13)' 'project(refused NONE)' \
        'find_package(tiltrotor 0.2 REQUIRED COMPONENTS static nonsense)' >refused/CMakeLists.txt
    ! cmake -S refused -B refused/built -DCMAKE_PREFIX_PATH="$prefix" >cmake.txt 2>&1 || { cat cmake.txt; exit 1; }
    grep -q "no component 'nonsense': there are .*static" cmake.txt || { cat cmake.txt; exit 1; }
    echo "cmake: find_package(tiltrotor), shared and static"
fi
if [ -z "${RUNNER:-}" ] && [ -e "$prefix/lib/python" ]; then
    if ! command -v python3 >/dev/null; then
        echo "python: not installed: python3 (Debian: python3), left out"
    else
        "$prefix/bin/tiltrotor" fly --script mission.txt --every 1 --format csv --output mission.csv 2>fly.txt || { cat fly.txt; exit 1; }
        for example in trim_curve.py lqr.py closed_loop.py "mission_plot.py mission.csv"; do
            # shellcheck disable=SC2086 # words
            PYTHONPATH=$prefix/lib/python python3 python/$example >python.txt 2>&1 ||
                grep 'not installed, left out' python.txt || { cat python.txt; exit 1; }
        done
        echo "python: the examples"
    fi
fi

# One second in real time with controls that change, recorded; then three replays as fast as possible.
{ echo "0.17 1.0 0.0 0.0"; sleep 0.3; echo "0.175 1.2 0.1 0.0"; sleep 0.3; echo "0.175 nonsense"; echo "0.17 1 0 9"; } |
    ${RUNNER:-} ./rig --rate 200 --seconds 1 --record flown.txt | tee first.txt
for replay in 1 2 3; do
    ${RUNNER:-} ./rig --rate 200 --seconds 1 --fast <flown.txt | grep '^hash' >replayed.txt
    grep '^hash' first.txt | cmp - replayed.txt || { echo "rig: replay $replay differs"; exit 1; }
done
echo "rig: three replays bit for bit"
grep -q 'refused_inputs 2 ' first.txt || { echo "rig: two bad inputs were not refused"; exit 1; }

# From the ground in real time over UDP, commands in and sensors out; the recording replays.
port() { # port FILE LINE: the number that a program in the background has written there
    for tenth in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do
        number=$(sed -n "$2s/.*port //p" "$1" 2>/dev/null) || true
        [ -z "$number" ] || break
        sleep 0.1
    done
    echo "$number"
}
${RUNNER:-} ./peer pilot >pilot.txt &
pilot=$!
to_rig=$(port pilot.txt 2)
${RUNNER:-} ./rig --ground --seconds 2 --udp "$to_rig" --sensors "$(port pilot.txt 1)" --record ground.txt >ground_first.txt
wait $pilot || { cat pilot.txt; echo "rig: its sensors are not what they should be"; exit 1; }
${RUNNER:-} ./rig --ground --seconds 2 --fast <ground.txt | grep '^hash' >replayed.txt
grep '^hash' ground_first.txt | cmp - replayed.txt || { echo "rig: the replay from the ground differs"; exit 1; }
grep -q 'refused_inputs 4 ' ground_first.txt || { cat ground_first.txt; echo "rig: four bad commands were not refused"; exit 1; }
printf '1 mast 5\n0.5 mast 6\n' >backwards.txt
! ${RUNNER:-} ./rig --ground --fast --script backwards.txt </dev/null 2>refused.txt || exit 1
grep -q 'backwards.txt:2: ' refused.txt
echo "rig: commands in and sensors out over UDP"

# A hop as FlightGear sees it: what arrives is what was sent, and it ends on the ground.
${RUNNER:-} ./peer visual >seen.txt &
visual=$!
${RUNNER:-} ./flightgear --port "$(port seen.txt 1)" --fast --seconds 20 hop.txt >shown.txt
wait $visual || { grep peer seen.txt; echo "flightgear: packets that are none"; exit 1; }
sed 1d seen.txt >arrived.txt
if [ "$(wc -l <arrived.txt)" -lt 100 ] || grep -Fxvf shown.txt arrived.txt; then
    echo "flightgear: packets are not what was sent"
    exit 1
fi
awk '$4 > highest { highest = $4 } END { exit !(highest > 4 && highest < 6 && $4 < 0.1 && $11 == 1) }' shown.txt ||
    { echo "flightgear: this was no hop"; exit 1; }
echo "flightgear: $(wc -l <arrived.txt) packets, as sent"

# ArduPilot's part is played by a peer that lifts off.
${RUNNER:-} ./ardupilot --port 0 --frames 1601 >served.txt &
served=$!
${RUNNER:-} ./peer autopilot "$(port served.txt 1)" || { echo "ardupilot: answers are not what they should be"; exit 1; }
wait $served
echo "ardupilot: 1600 frames, lifted off"

# The same program beside a file of C++ that includes the headers, compiled in its own way and never called; with the
# library archived and shared.
for part in rig rig_text ground_start; do eval "$c $cflags -c $part.c -o $part.o"; done
for how in "-O0" "-O1 -march=native"; do
    echo 'int main() {}' | ${CXX:-c++} $how -x c++ - -o /dev/null 2>/dev/null || continue
    eval "${CXX:-c++} -std=c++17 $how -Dmain=never_called $cflags -c trim_curve.cpp -o beside.o"
    for library in "$prefix"/lib/libtiltrotor.a "$prefix"/lib/libtiltrotor.so; do
        [ -e "$library" ] || continue
        ${CXX:-c++} rig.o rig_text.o ground_start.o beside.o "$library" "$prefix/lib/libtiltrotor-aircraft.a" -Wl,-rpath,"$prefix/lib" -lm -o mixed
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
