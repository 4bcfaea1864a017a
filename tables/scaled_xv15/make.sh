#!/bin/sh
# make.sh FROM TO: the tables of the XV-15 (FROM) as those of an aircraft of another size with four blades (TO).
#
# Froude: speed^2 over gravity and length stays. Mach: speed over the speed of sound stays. Lengths times L in air
# whose temperature is L times that at sea level do both: at 8866.15 m of the standard atmosphere for L = 0.8, where
# density is D = L^4.2559 of that at sea level. Speeds and times go with sqrt(L), masses and forces with D L^3, the
# tables' coefficients against angles and Mach number stay. What the XV-15 does at sea level this aircraft then does
# at that altitude, scaled: tests/properties/test_scaled_tables.cpp.
#
# Four blades of three quarters of the chord and of the inertia have the same solidity and the same disk inertia.
# Other breakpoints that change nothing: no flap setting 4, and the rotor wash at the tail a second time at mast 75,
# where it is that of 60 and 90. Engines and masts are sized for sea level: the engines' power is scaled at the altitude,
# the torque of the masts is L^4 there and here.
set -eu
from=$1 to=$2
export LC_ALL=C
rm -rf "$to"
mkdir -p "$to/airframe" "$to/rotor_airfoil"

laws='
  BEGIN {
    FS = ","; OFS = ","
    L = 0.8; D = exp(4.2559 * log(L)); speed = time = sqrt(L); mass = D * L ^ 3; blade = 3 / 4
    of["lb"] = of["slug"] = of["kg"] = mass
    of["slug ft2"] = of["kg m2"] = of["slug ft2/deg"] = of["kg m2/deg"] = mass * L ^ 2
    of["in"] = of["ft"] = of["m"] = L; of["ft2"] = of["m2"] = L ^ 2; of["ft3"] = of["m3"] = L ^ 3
    of["ft/s"] = of["kt"] = of["m/s"] = of["ft/s/deg"] = speed
    of["rpm"] = of["rad/s"] = of["deg/s"] = 1 / time; of["rad/s2"] = 1 / time ^ 2
    of["deg/s2"] = 1 / time ^ 2; of["1/s"] = 1 / time; of["s"] = time; of["hp/s"] = of["kW/s"] = mass * speed / time
    of["lb/hp/h"] = 1 / L
    of["N"] = mass; of["in lbf"] = of["N m"] = of["ft lbf/rad"] = of["ft lbf/deg"] = of["N m/rad"] = mass * L
    of["ft lbf s/rad"] = of["N m s/rad"] = mass * L * time
    of["hp"] = of["W"] = of["kW"] = mass * speed
    of["lb/ft2"] = of["Pa"] = D * L
    of["lbf/in"] = of["N/m"] = mass / L; of["lbf s/in"] = of["N s/m"] = mass / L * time
  }
  # Hands and feet, the atmosphere and its gusts have their own size.
  function factor(name, unit) {
    if (name ~ /^(stick|pedal|collective)_.*travel/ || name == "guess_stick_step" || name ~ /^altitude_|^gust_|^wind_/) return 1
    if (name ~ /^(scas_dead_band|smooth_stick)$/) return 1
    if (name ~ /^engine_jet_/) return name ~ /_per_power$/ ? 1 : L ^ 2
    if (name ~ /^engine_power_/) return of[unit] / (D * speed)
    if (name ~ /^(mast_torque|transmission_limit)/) return of[unit] / D
    if (name == "rotor_blade_flap_inertia" || name == "rotor_chord") return of[unit] * blade
    return unit in of ? of[unit] : 1
  }
  function times(value, by) { return by == 1 || value == "" ? value : sprintf("%.17g", value * by) }
  function made() { print "# Made from those of the XV-15 by tables/scaled_xv15/make.sh: change those." }'

awk "$laws"'
  NR == 1 { made() }
  /^#/ || /^name,/ { print; next }
  $1 == "rotor_blades" { $2 = $4 = 4; print; next }
  { by = factor($1, $3); $2 = times($2, by); $4 = times($4, by); print }' "$from/aircraft.csv" >"$to/aircraft.csv"

awk "$laws"'
  NR == 1 { made() }
  /^#/ || /^name,/ { print; next }
  $1 == "flap_setting_4" { next }
  { $2 = times($2, factor($1, $3)); print }' "$from/choices.csv" >"$to/choices.csv"

awk "$laws"'
  NR == 1 { made() }
  /^#/ || $4 != 4 { print }
  $1 == "htail.rotor_wash" && $3 == 60 { $3 = 75; print }' "$from/tables.csv" >"$to/tables.csv"

# A table: speeds on its axes, and values where they are areas, volumes or chords.
for file in "$from"/airframe/*.csv "$from"/rotor_airfoil/*.csv; do
  name=${file#"$from"/}
  awk -v name="$name" "$laws"'
    NR == 1 { made() }
    /^#/ { comments = comments $0; print; next }
    !body {
      body = 1
      first = $1 == "V_kt" || $1 == "U_KCAS" ? speed : 1
      for (i = 2; i <= NF; ++i) if ($i ~ /^V[0-9]+$/) $i = "V" times(substr($i, 2), speed)
      by = name ~ /blade_chord/ ? L * blade : 1
      if (name ~ /augmentation_gains/) by = time
      if (name ~ /\/(t3-|t4-XV_)/) by = comments ~ /\(ft3/ ? of["ft3"] : of["ft2"]
      print; next
    }
    name ~ /t4-XII_/ && $1 == "FL4" { next }
    name ~ /governor_gains/ { $3 = times($3, 1 / time); print; next }
    { $1 = times($1, first); for (i = 2; i <= NF; ++i) $i = times($i, by); print }' "$file" >"$to/$name"
done

cp "$(dirname "$0")/identity.csv" "$to/identity.csv"  # last: it says that the others are there
