#!/usr/bin/env bash
# mutate.sh COUNT BUILD [SEED]: breaks COUNT places of include/ one at a time and counts those that no test notices.
#
# A mutant is one operator or constant exchanged on one line of code; the sample is drawn by SEED, so a survivor can be
# repeated. The mutated copy stands before include/ on the search path; a small subset of the tests, chosen by the room
# of the file, is compiled against it. Broken at compile time counts as noticed. Survivors that are explained (the
# mutant is equivalent) stand in tests/mutation/explained.txt as `file | mutated line | reason`.
set -u
count=$1
build=$2
seed=${3:-1}
cxx=${CXX:-g++}  # may be two words: ccache g++
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
flags="-std=c++17 -O1 -ffp-contract=off -fno-tree-slp-vectorize -fno-math-errno -w -Isrc -Itests -I$build/generated"
defines=(-DTILTROTOR_VERSION=\"m\" -DTILTROTOR_SOURCE_DIR=\"$PWD\" -DTILTROTOR_BINARY_DIR=\"$PWD/$build\"
         -DTILTROTOR_RUNNER=\"\" -DTILTROTOR_DEFINES_INSTANCES)
fast=$(mktemp -d -p "$work")

# All mutants: file, line, what, by what.
list_mutants() {
    find include/tiltrotor/math include/tiltrotor/model include/tiltrotor/analysis -name '*.hpp' | sort | while read -r file; do
        awk -v file="$file" '
          function offer(from, to,    at) {
            at = index(code, from)
            if (at > 0) printf "%s\t%d\t%s\t%s\n", file, NR, from, to
          }
          {
            code = $0
            sub(/\/\/.*/, "", code)
            if (code ~ /^ *#|static_assert|^ *template|operator|"|friend|using|enum/) next
            offer(" + ", " - "); offer(" - ", " + "); offer(" * ", " / "); offer(" / ", " * ")
            offer(" < ", " <= "); offer(" > ", " >= "); offer(" <= ", " < "); offer(" >= ", " > ")
            offer(" == ", " != "); offer(" != ", " == "); offer(" && ", " || "); offer(" || ", " && ")
            offer("R(1)", "R(2)"); offer("R(2)", "R(1)"); offer("R(0)", "R(1)"); offer("R(0.5)", "R(0.25)")
            offer("cos(", "sin("); offer("sin(", "cos("); offer("return -", "return ")
            offer("+= ", "-= "); offer("-= ", "+= "); offer("? ", "? !true ? "); offer("right", "left")
          }' "$file"
    done | grep -v '? !true'
}

# Those that notice most, or at least cost, come first: the test of the same name, then the comparisons.
tests_for() {
    {
        ls "tests/$(basename "$(dirname "$1")")/test_$(basename "$1" .hpp).cpp"
        case $1 in
            */math/*) ls tests/math/test_*.cpp tests/properties/test_algebra.cpp | grep -v portable ;;
            */model/*) printf 'tests/model/test_%s.cpp\n' reference mirror options rotor
                       ls tests/model/test_*.cpp tests/properties/test_*.cpp | grep -v envelope ;;
            *) ls tests/analysis/test_*.cpp ;;
        esac
    } 2>/dev/null | xargs grep -L run_program.hpp | awk '!seen[$0]++'  # a built program has no mutant in it
}

# Objects that no mutant touches.
data="$fast/aircraft_data.o $fast/check.o"
$cxx $flags -Iinclude "${defines[@]}" -c src/library/aircraft_data.cpp -o "$fast/aircraft_data.o" &&
    $cxx $flags -Iinclude "${defines[@]}" -c tests/check.cpp -o "$fast/check.o" || exit 1

# built TEST INCLUDE: compiled against that copy of the headers, with its other half where it has one.
built() {
    local half
    rm -f "$work"/*.o
    for half in "$1" "${1%.cpp}_portable.cpp"; do
        [ -e "$half" ] || continue
        timeout 300 $cxx $flags -I"$2" "${defines[@]}" -c "$half" -o "$work/$(basename "$half" .cpp).o" 2>/dev/null || return
    done
    $cxx "$work"/*.o $data -o "$work/run" 2>/dev/null
}
passes() { ( timeout 120 "$work/run" --skip slow_ ) >/dev/null 2>&1; }
# sound TEST: it passes without a mutant. Asked only of tests that noticed one, once each.
sound() {
    local name
    name=$(basename "$1" .cpp)
    if [ ! -e "$fast/$name" ]; then
        if built "$1" include && passes; then echo yes; else echo no; fi >"$fast/$name"
        grep -q yes "$fast/$name" || echo "mutation: $name does not pass without a mutant, left out" >&2
    fi
    grep -q yes "$fast/$name"
}

# In the order of random numbers (Park and Miller), the same on every machine.
list_mutants >"$work/all"
total=$(wc -l <"$work/all")
awk -v seed="$seed" 'BEGIN { x = (1 + (seed - 1) * 1048583) % 2147483647  # multiples would give like samples
                             for (i = 0; i < 20; ++i) x = x * 16807 % 2147483647 }
                  { x = x * 16807 % 2147483647; printf "%.0f\t%s\n", x, $0 }' "$work/all" |
    sort -n | cut -f 2- | head -n "$count" >"$work/sample"
killed=0 survived=0 explained=0 number=0
while IFS=$'\t' read -r file line from to; do
    number=$((number + 1))
    rm -rf "$work/include" && cp -r include "$work/include"
    FROM=$from TO=$to awk -v n="$line" '
      NR == n { from = ENVIRON["FROM"]; at = index($0, from); $0 = substr($0, 1, at - 1) ENVIRON["TO"] substr($0, at + length(from)) }
      { print }' "$file" >"$work/$file"
    mutated=$(sed -n "${line}p" "$work/$file" | sed 's/^ *//')
    verdict=survived
    for test in $(tests_for "$file"); do
        # A test that does not see the file cannot notice.
        $cxx $flags -I"$work/include" "${defines[@]}" -MM "$test" 2>/dev/null | grep -q "$work/$file" || continue
        how=compiler
        if built "$test" "$work/include"; then
            passes && continue
            how=$(basename "$test" .cpp)
        fi
        sound "$test" || continue
        verdict="killed by $how"
        break
    done
    if [ "$verdict" = survived ] && grep -Fq "$file | $mutated |" tests/mutation/explained.txt; then verdict="equivalent"; fi
    case $verdict in
        survived) survived=$((survived + 1)) ;;
        equivalent) explained=$((explained + 1)) ;;
        *) killed=$((killed + 1)) ;;
    esac
    [ -n "${VERBOSE:-}" ] || [ "$verdict" = survived ] && echo "$verdict: $file:$line:$from->$to: $mutated"
done <"$work/sample"
echo "mutation: $number of $total possible mutants tried (seed $seed), $killed noticed, $explained equivalent and explained, $survived survived"
