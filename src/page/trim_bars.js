// What a trim takes of what there is: a bar from stop to stop for every control and limit.

// kAircraft: numbers of tables/, SI units, by their names there.
function trimBarRows() {
  const inch = 0.0254;
  const table = kAircraft;
  const stick = table.stick_long_travel_half / inch, lateral = table.stick_lat_travel_half / inch;
  const pedal = table.pedal_travel_half / inch, tilt = degrees(table.rotor_flap_limit);
  const elevator = degrees(table.elevator_limit), rudder = degrees(table.rudder_limit);
  const power = 2 * table.engine_power_takeoff / 1000, torque = table.mast_torque_steady / 1000;
  const out = (place, size) => (seen) => seen.out[place] * size;
  return [
    {name: 'Long. stick', unit: 'in', low: -stick, high: stick, of: (s) => s.u[kU.longStick]},
    {name: 'Lat. stick', unit: 'in', low: -lateral, high: lateral, of: (s) => s.u[kU.latStick]},
    {name: 'Pedals', unit: 'in', low: -pedal, high: pedal, of: (s) => s.u[kU.pedal]},
    {name: 'Collective', unit: 'deg', low: 0, high: 60, isOpen: true, of: out(kOut.collective, 1 / kDegree)},
    {name: 'Elevator', unit: 'deg', low: -elevator, high: elevator, of: out(kOut.elevator, 1 / kDegree)},
    {name: 'Rudders', unit: 'deg', low: -rudder, high: rudder, of: out(kOut.rudder, 1 / kDegree)},
    {name: 'Gimbal tilt', unit: 'deg', low: 0, high: tilt, of: out(kOut.tilt, 1 / kDegree)},
    {name: 'Power', unit: 'kW', low: 0, high: power, digits: 0,
      note: 'take-off power of both engines at sea level',
      of: (s) => (s.out[kOut.power] + s.out[kOut.power + 1]) / 1000},
    {name: 'Mast torque', unit: 'kN m', low: 0, high: torque, of: out(kOut.torque, 1e-3)},
    {name: 'Pitch', unit: 'deg', low: -20, high: 20, isOpen: true, of: (s) => degrees(s.x[kX.pitch])},
  ];
}

class TrimBars {
  constructor(element) {
    this.rows = trimBarRows().map((row) => {
      const track = html('div', {class: row.isOpen ? 'track open' : 'track'});
      const fill = html('div', {class: 'fill'}), value = html('span', {class: 'value'});
      if (row.low < 0) track.append(html('i', {class: 'middle', style: `left:${-row.low / (row.high - row.low) * 100}%`}));
      track.append(fill);
      const line = html('div', {class: 'bar', tabindex: 0}, html('span', {}, row.name), track, value);
      element.append(line);
      return {...row, line, fill, value};
    });
  }
  show(seen) {
    for (const row of this.rows) {
      const number = seen === null ? NaN : row.of(seen), digits = row.digits === undefined ? 2 : row.digits;
      row.value.textContent = `${fixed(number, digits)} ${row.unit}`;
      const part = (value) => clamp((value - row.low) / (row.high - row.low), 0, 1) * 100;
      const zero = part(Math.max(row.low, 0)), end = Number.isFinite(number) ? part(number) : zero;
      row.fill.style.left = `${Math.min(zero, end)}%`;
      row.fill.style.width = `${Math.abs(end - zero)}%`;
      const isOver = !row.isOpen && (number > row.high || number < row.low);
      row.line.classList.toggle('over', isOver);
      row.line.dataset.tip = `${row.name} ${fixed(number, digits + 1)} ${row.unit}; ` + (row.isOpen ? 'no stop shown'
        : `stops at ${fixed(row.low, digits)} and ${fixed(row.high, digits)} ${row.unit}` +
          `${row.note ? `, ${row.note}` : ''}${isOver ? ': beyond its stop' : ''}`);
    }
  }
}
