#!/bin/sh
# budget.sh FOLDER TOOL_PREFIX MACHINE STATES OUTPUT [GRAPH...]: what the library needs on a target, against limits.csv.
# FOLDER holds the target's build: libtiltrotor.a, call graphs, flight.elf, measure.elf. GRAPH: call graphs of this
# machine's library; without them the limits named host_... are left out.
set -eu
folder=$1
prefix=$2
machine=$3
states=$4
output=$5
shift 5
here=$(dirname "$0")
values=$folder/budget_values.txt

# Objects that the interface is made of; the archive holds the other precision too.
objects=$(sed -n 's/^.*libtiltrotor\.a(\([a-z_]*\.o\)).*$/\1/p' "$folder/flight.elf.map" | sort -u)
{
    # Heap, exceptions, run-time types, unwinding, guards of static variables, output.
    forbidden='malloc|calloc|realloc|free|_Zn[wa]|_Zd[la]|__cxa_|_ZTI|_ZTS|_ZTV|_Unwind|__gxx_personality|__aeabi_unwind|_ZGV|printf|puts|fopen|atexit'
    found=$("${prefix}nm" "$folder/flight.elf" | awk '{ print $NF }' | grep -E "^_*($forbidden)(_|[A-Z0-9]|\$)" || true)
    [ -z "$found" ] || echo "forbidden: $found" >&2
    echo "forbidden_symbols $(printf '%s' "$found" | grep -c . || true)"

    graphs=$(for object in $objects; do echo "$folder/ad/library/${object%.o}.ci"; done)
    awk -v library_bytes=512 -v paths="${BUDGET_PATHS:-}" -f "$here/deepest_stack.awk" $graphs

    [ $# -eq 0 ] || awk -v library_bytes=512 -v paths="${BUDGET_PATHS:-}" -f "$here/deepest_stack.awk" "$@" | sed 's/^/host_/'

    "${prefix}size" -A "$folder/flight.elf" | awk '
        $1 == ".text" { code = $2 }
        $1 == ".rodata" || $1 == ".ARM.exidx" { constants += $2 }
        $1 == ".data" { ram += $2; constants += $2 }
        $1 == ".bss" { ram += $2 }
        $1 == ".stack" { reserved = $2 }
        END { print "code", code; print "constants", constants; print "code_and_constants", code + constants
              print "static_ram", ram }'
    echo "measuring under the emulator, some minutes" >&2
    "$here/../../src/firmware/emulate.sh" "$machine" "$folder/measure.elf" "$states" -icount shift=5
} >"$values" || { cat "$values"; exit 1; }

awk -F, -v values="$values" -v output="$output" -v graphs=$# '
    BEGIN {
        while ((getline line <values) > 0) { split(line, word, " "); value[word[1]] = word[2] }
        value["stack_measured"] = value["deepest_stack_bytes"]
        deepest = 0
        for (name in value) if (name ~ /^stack_tr_/ && value[name] > deepest) deepest = value[name]
        value["ram_with_stack"] = value["static_ram"] + deepest
        split("derivative jacobian step eigenvalues frame", names, " ")
        for (i in names) {
            least = value[names[i] "_min"]
            if (least > 0) value[names[i] "_spread"] = sprintf("%.2f", 100 * (value[names[i] "_max"] - least) / least)
        }
        print "name,value,limit,unit" >output
    }
    NR == 1 || (!graphs && $1 ~ /^host_/) { next }
    !($1 in value) { print "budget: " $1 " was not measured"; bad = 1; next }
    {
        print $1 "," value[$1] "," $2 "," $3 >output
        listed[$1]
        verdict = ""
        if (value[$1] + 0 > $2 + 0) { verdict = "OVER THE LIMIT"; bad = 1 }
        else if (value[$1] + 0 > $4 + 0) verdict = "goal " $4
        printf "%-26s %10s of %10s %-12s %s\n", $1, value[$1], $2, $3, verdict
    }
    END {
        split("derivative step jacobian eigenvalues frame exponential_frame slow_frame trim_iteration", names, " ")
        for (i = 1; i in names; ++i) print names[i] "_min," value[names[i] "_min"] ",,instructions" >output
        exit bad
    }' "$here/limits.csv"
