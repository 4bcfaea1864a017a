#!/bin/sh
# assemble.sh MODULE TABLES TEMPLATE STYLE SCRIPT...: the page on standard output. A line @style.css@, @module@ or
# @scripts@ of the template stands for what is put there. Numbers of the aircraft come from TABLES/aircraft.csv.
set -e
module=$1
tables=$2
template=$3
style=$4
shift 4

wanted="stick_long_travel_half stick_lat_travel_half pedal_travel_half rotor_flap_limit elevator_limit rudder_limit
  engine_power_takeoff mast_torque_steady WL_CG_helicopter ground_WL_static"

# name,value,unit,value in SI units,...
numbers() {
    awk -F, -v wanted="$wanted" '
        BEGIN { for (n = split(wanted, name, /[ \n]+/); n > 0; --n) is_wanted[name[n]] = 1; delete is_wanted[""] }
        $1 in is_wanted { printf "  %s: %s,\n", $1, $4; delete is_wanted[$1] }
        END { for (left in is_wanted) { print "assemble.sh: no number " left >"/dev/stderr"; exit 1 } }' "$tables/aircraft.csv"
}

while IFS= read -r line; do
    case $line in
        @style.css@) cat "$style" ;;
        @module@) base64 "$module" ;;
        @scripts@)
            echo "'use strict';"
            echo 'const kAircraft = {'
            numbers
            echo '};'
            cat "$@" ;;
        *) printf '%s\n' "$line" ;;
    esac
done <"$template"
