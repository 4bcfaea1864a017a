// Forces of the components as arrows, to the scale of the weight, with the list that says what is what. A letter at every
// arrow: colours alone are not told apart by all.

// Where an arrow begins: station, water line and butt line of the sketch, inches; `parts`: components, by their names. Those of
// a side begin at +-BL.
const kForceGroups = [
  {name: 'Rotors, in their planes', letter: 'H', colour: '#0072b2', parts: ['in_plane_right', 'in_plane_left'], at: null},
  {name: 'Wing', letter: 'W', colour: '#00795a', parts: ['wing_wake_right', 'wing_wake_left', 'wing_free'], at: [300, 101], bl: 105},
  {name: 'Fuselage', letter: 'F', colour: '#a3457f', parts: ['fuselage'], at: [230, 84], bl: 0},
  {name: 'Tailplane', letter: 'T', colour: '#8a6100', parts: ['htail'], at: [560, 103], bl: 0},
  {name: 'Fins', letter: 'V', colour: '#2f7fb5', parts: ['fin_right', 'fin_left'], at: [568, 130], bl: 77},
  {name: 'Pylons, spinners', letter: 'P', colour: '#555', parts: ['pylon', 'spinners', 'pylon_side'], at: [330, 100], bl: 193},
  {name: 'Engine jets', letter: 'J', colour: '#111', parts: ['engine_jets'], at: [340, 90], bl: 193},
];
const kLeastForce = 1;  // N: none

// Of what aircraft.componentForces() gave, summed over a group: [x, y, z] of the body, N.
const forceOf = (forces, parts) => [0, 1, 2].map((k) => parts.reduce((sum, part) => sum + forces[part][k], 0));

// With what of the rotors' forces lies across the masts: along them the thrusts are drawn.
function withInPlane(forces, mast) {
  const axis = [Math.sin(mast), 0, -Math.cos(mast)];
  const across = (force) => {
    const along = force.reduce((sum, part, k) => sum + part * axis[k], 0);
    return force.map((part, k) => part - along * axis[k]);
  };
  return {...forces, in_plane_right: across(forces.rotor_right), in_plane_left: across(forces.rotor_left)};
}

// {group, from: [sl, wl, bl], force} of every arrow that is to be seen: sides apart where `isFront`.
function forceArrows(forces, hub, isFront) {
  const found = [];
  for (const group of kForceGroups) {
    const add = (parts, from) => {
      const force = forceOf(forces, parts);
      if (Math.hypot(...force) >= kLeastForce) found.push({group, from, force});
    };
    const [sl, wl] = group.at || hub, bl = group.at ? group.bl : kFront.hub;
    const sides = [['_right', 1], ['_left', -1]].map(([end, side]) => [group.parts.filter((part) => part.endsWith(end)), side]);
    if (!isFront || bl === 0 || sides[0][0].length === 0) add(group.parts, [sl, wl, 0]);
    else {
      for (const [parts, side] of sides) add(parts, [sl, wl, side * bl]);
      const rest = group.parts.filter((part) => !/_(right|left)$/.test(part));
      if (rest.length > 0) add(rest, [sl, wl, 0]);
    }
  }
  return found;
}

const kiloNewton = (force) => `${fixed(Math.hypot(...force) / 1000, 2)} kN`;
const forceText = ({name}, [x, y, z]) => `${name}: ${kiloNewton([x, y, z])}; forward ${fixed(x / 1000, 2)}, ` +
  `right ${fixed(y / 1000, 2)}, up ${fixed(-z / 1000, 2)} kN in the axes of the body`;

const kLetterGap = 19;  // of the picture: between letters
// Arrows with their letters, of {found, at: [x, y], by: [dx, dy]} in the picture; a letter stands beside the end of its arrow,
// where no other letter nor a place of `taken` is.
function forceLayer(all, taken) {
  const held = [...taken];
  return all.map(({found: {group, force}, at: [x, y], by: [dx, dy]}) => {
    const end = [x + dx, y + dy], way = Math.atan2(dy, dx);
    const places = [15, 24, 36].flatMap((far) => [0, 1, -1, 2, -2, 3, -3, 4].map((turn) => [end[0] + far * Math.cos(way + turn * Math.PI / 4),
      end[1] + far * Math.sin(way + turn * Math.PI / 4)]));
    const near = ([px, py]) => Math.min(...held.map(([qx, qy]) => Math.hypot(px - qx, py - qy)), Infinity);
    const place = places.find((p) => near(p) > kLetterGap) || places[0];
    held.push(place, end);
    return svg('g', {class: 'force', style: `color:${group.colour}`, 'data-tip': forceText(group, force)},
      svg('circle', {cx: x, cy: y, r: 3.5, fill: 'currentColor'}), arrow(x, y, ...end, {}),
      svg('text', {x: place[0], y: place[1] + 7, 'text-anchor': 'middle', class: 'force_letter'}, group.letter));
  });
}
// Places along a line, which letters keep clear of.
const placesOn = ([x1, y1], [x2, y2]) => Array.from({length: 8}, (_, k) => [x1 + (x2 - x1) * k / 7, y1 + (y2 - y1) * k / 7]);

// The legend: every group with its size, shared by both pictures.
function listForces(list, forces) {
  list.replaceChildren();
  if (forces === null) return;
  for (const group of kForceGroups) {
    const force = forceOf(forces, group.parts);
    if (Math.hypot(...force) < kLeastForce) continue;
    list.append(html('li', {'data-tip': forceText(group, force), tabindex: 0, style: `--own:${group.colour}`},
      html('b', {}, group.letter), ` ${group.name} ${kiloNewton(force)}`));
  }
}
