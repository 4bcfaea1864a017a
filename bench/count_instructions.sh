#!/bin/sh
# Counts instructions with callgrind and compares them with limits.csv (name,limit): more than 5 % above fails.
#
#   count_instructions.sh PROGRAM LIMITS DIRECTORY      the counts also go to DIRECTORY/instructions.csv
#   LIMITS has the form of instructions.csv: copying the one over the other refreshes the limits.
set -eu
program=$1
limits=$2
directory=$3
mkdir -p "$directory"
counts=$directory/instructions.csv

# count CASE [GRID]: instructions inside counted_CASE()
count() {
    out=$directory/callgrind.out
    valgrind --tool=callgrind --toggle-collect="counted_$1" --callgrind-out-file="$out" "$program" "$@" \
        >"$directory/callgrind.log" 2>&1 || { cat "$directory/callgrind.log" >&2; exit 1; }
    sed -n 's/^totals: //p' "$out"
}

{
    echo name,limit
    for case in derivative configuration jacobian trim frame; do
        echo "$case,$(count "$case")"
        echo "${case}_specification,$(count "$case" specification)"
    done
    for case in slow_frame systems outputs; do
        echo "$case,$(count "$case")"
    done
} >"$counts.part"
mv "$counts.part" "$counts"

awk -F, '
    FNR == 1 { next }
    NR == FNR { limit[$1] = $2; next }
    {
        known = $1 in limit
        change = known ? 100 * ($2 / limit[$1] - 1) : 0
        verdict = !known ? "no limit" : change > 5 ? "TOO MANY" : change < -5 ? "fewer: refresh the limit" : "ok"
        if (!known || change > 5) failed = 1
        printf "  %-26s %12d instructions %+7.1f %%  %s\n", $1, $2, change, verdict
    }
    { counted[$1] = $2 }
    END {
        if (counted["configuration"] > 0.06 * counted["derivative"]) {
            print "  a configuration costs more than 6 % of a derivative"
            failed = 1
        }
        exit failed
    }' "$limits" "$counts"
