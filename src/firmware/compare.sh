#!/bin/sh
# compare.sh NAME MACHINE IMAGE HOST_COMMAND FRAMES: the flight of the image line by line against that of the host.
# Every number must agree to 1e-9 (double) or 1e-4 (single) of its size or of 1, and every hash exactly.
set -u
name=$1
folder=$(dirname "$3")
$4 "$5" >"$folder/flight_on_host.txt" || { echo "$name: the flight on this machine failed"; exit 1; }
"$(dirname "$0")/emulate.sh" "$2" "$3" "$5" >"$folder/flight_on_target.txt"
status=$?
cat "$folder/flight_on_target.txt"
[ "$status" -eq 0 ] || { echo "$name: the image ended with status $status"; exit 1; }
awk -v name="$name" '
    function size(x) { return x < 0 ? -x : x }
    NR == FNR { if ($1 != "deepest_stack_bytes") { target[++lines] = $0 }; next }
    { ++host; split(target[host], word, " ") }
    $1 == "precision" { bound = $2 == "double" ? 1e-9 : 1e-4 }
    word[1] != $1 || NF != 2 { print name ": line " host " is \"" target[host] "\", on this machine \"" $0 "\""; bad = 1; next }
    /^hash/ || /^precision/ {
        if (/^hash/) { ++hashes; equal += word[2] == $2 }
        if (word[2] != $2) { print name ": " $1 " differs: " word[2] ", on this machine " $2; bad = 1 }
        next
    }
    {
        ++numbers
        scale = size($2) > 1 ? size($2) : 1
        difference = size(word[2] - $2) / scale
        if (difference > worst) { worst = difference; where = $1 }
        if (!(difference <= bound)) { print name ": " $1 " " word[2] ", on this machine " $2; bad = 1 }
    }
    END {
        if (host != lines) { print name ": " lines " lines, on this machine " host; bad = 1 }
        printf "%s: %d numbers within %g of this machine (bound %g), %d of %d hashes equal\n", name, numbers, worst, bound, equal, hashes
        exit bad || hashes == 0
    }' "$folder/flight_on_target.txt" "$folder/flight_on_host.txt"
