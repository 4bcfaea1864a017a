#!/bin/sh
# assemble.sh MODULE LICENCE TABLES LIMITS TEMPLATE STYLE SCRIPT...: the page on standard output. A line @style.css@, @licence@,
# @module@ or @scripts@ of the template stands for what is put there. Numbers of the aircraft come from TABLES/aircraft.csv, those of
# handling qualities from LIMITS.
set -e
module=$1
licence=$2
tables=$3
limits=$4
template=$5
style=$6
shift 6

wanted="stick_long_travel_half stick_lat_travel_half pedal_travel_half rotor_flap_limit elevator_limit rudder_limit
  engine_power_takeoff mast_torque_steady WL_CG_helicopter ground_WL_static"

wanted_limits="dutch_zeta_L1_catB dutch_zeta_L2 dutch_zeta_L3 dutch_zeta_omega_L1_catB dutch_zeta_omega_L2 dutch_omega_L1_catB
  dutch_omega_L2_L3 sp_zeta_min_L1_catB sp_zeta_min_L2_catB sp_zeta_min_L3_catB phugoid_zeta_L1 roll_TR_L1_catB roll_TR_L2_class23
  roll_TR_L3 spiral_T2_L1_catB spiral_T2_L2 spiral_T2_L3 roll_spiral_zeta_omega_L1 roll_spiral_zeta_omega_L2
  roll_spiral_zeta_omega_L3"

# numbers FILE NAMES; its rows: name,value,unit,value in SI units,...
numbers() {
    awk -F, -v wanted="$2" '
        BEGIN { for (n = split(wanted, name, /[ \n]+/); n > 0; --n) is_wanted[name[n]] = 1; delete is_wanted[""] }
        $1 in is_wanted { printf "  %s: %s,\n", $1, $4; delete is_wanted[$1] }
        END { for (left in is_wanted) { print "assemble.sh: no number " left >"/dev/stderr"; exit 1 } }' "$1"
}

while IFS= read -r line; do
    case $line in
        @style.css@) cat "$style" ;;
        @licence@) sed 's/&/\&amp;/g; s/</\&lt;/g' "$licence" ;;
        @module@) base64 "$module" ;;
        @scripts@)
            echo "'use strict';"
            echo 'const kAircraft = {'
            numbers "$tables/aircraft.csv" "$wanted"
            echo '};'
            echo 'const kLimits = {'
            numbers "$limits" "$wanted_limits"
            echo '};'
            cat "$@" ;;
        *) printf '%s\n' "$line" ;;
    esac
done <"$template"
