// The aircraft from the front, its right wing on the left: masts where they are, thrust of each rotor and weight as arrows.
// Drawn in the stations of the aircraft, inches: BL to its right, WL up. A sketch, its axes, hubs and disks to scale.

const kFront = {hub: 193, pivot: 100, cg: 82, tail: 77};

class FrontView {
  constructor(element) {
    this.element = element;
    element.setAttribute('viewBox', '-360 -240 720 430');
  }
  at(bl, wl) { return [-bl, kFront.cg - wl]; }
  polygon(points, name) {
    return svg('polygon', {points: points.map(([bl, wl]) => this.at(bl, wl).join(',')).join(' '), class: name});
  }
  rotor(side, mast, thrust, weight) {
    const [x, pivot] = this.at(side * kFront.hub, kFront.pivot), up = Math.cos(mast), ahead = Math.sin(mast);
    const hub = pivot - kSide.hub * up, name = side > 0 ? 'Right' : 'Left';
    const size = kWeightArrow * thrust / weight;
    const parts = [
      svg('rect', {x: x - 17, y: pivot - 46 * up - 17 * ahead, width: 34, height: 112 * up + 34 * ahead, rx: 14, class: 'nacelle'}),
      svg('ellipse', {cx: x, cy: hub, rx: kSide.disk, ry: Math.max(3, kSide.disk * ahead), class: 'disk_plane',
        'data-tip': `${name} rotor disk, mast angle ${fixed(degrees(mast), 1)} deg`}),
      arrow(x, hub, x, hub - size * up, {class: 'thrust',
        'data-tip': `Thrust of the ${name.toLowerCase()} rotor ${fixed(thrust / 1000, 1)} kN; the arrow is its part in this plane`}),
    ];
    return svg('g', {}, ...parts, svg('text', {x, y: 172, 'text-anchor': 'middle'}, name.toLowerCase()));
  }
  forces(forces, hub, weight, mast, thrust) {
    const scale = kWeightArrow / weight;
    const taken = [1, -1].flatMap((side, k) => {
      const [x, y] = this.at(side * kFront.hub, hub[1]);
      return placesOn([x, y], [x, y - scale * thrust[k] * Math.cos(mast)]);
    });
    return forceLayer(forceArrows(forces, hub, true).map((found) => ({found, at: this.at(found.from[2], found.from[1]),
      by: [-scale * found.force[1], scale * found.force[2]]})), [...taken, ...placesOn([0, 0], [0, kWeightArrow])]);
  }
  // `forces`: of the components, or null for none.
  show(seen, forces) {
    this.element.replaceChildren();
    if (seen === null) return;
    const mast = seen.conf[kConf.mast] * kDegree, roll = seen.x[kX.roll], weight = seen.conf[kConf.mass] * 9.80665;
    const hub = [kSide.pivot[0] - kSide.hub * Math.sin(mast), kFront.pivot + kSide.hub * Math.cos(mast)];
    const thrust = [seen.out[kOut.thrust], seen.out[kOut.thrust + 1]];
    this.element.append(
      svg('g', {transform: `rotate(${-degrees(roll)})`},
        this.polygon([[-kFront.tail, 103], [kFront.tail, 103], [kFront.tail, 109], [-kFront.tail, 109]], 'surface'),
        this.polygon([[-80, 84], [-74, 84], [-74, 177], [-80, 177]], 'surface'),
        this.polygon([[80, 84], [74, 84], [74, 177], [80, 177]], 'surface'),
        this.polygon([[-193, 94], [193, 94], [193, 108], [-193, 108]], 'surface'),
        svg('ellipse', {cx: 0, cy: 0, rx: 33, ry: 38, class: 'fuselage'}),
        this.polygon([[-22, 92], [22, 92], [15, 110], [-15, 110]], 'window'),
        this.rotor(1, mast, thrust[0], weight), this.rotor(-1, mast, thrust[1], weight),
        ...(forces === null ? [] : this.forces(forces, hub, weight, mast, thrust))),
      arrow(0, 0, 0, kWeightArrow, {class: 'weight', 'data-tip': `Weight ${fixed(weight / 1000, 1)} kN`}),
      svg('circle', {r: 6, class: 'cg', 'data-tip': 'Centre of gravity'}));
    this.element.setAttribute('aria-label', `Aircraft from the front: roll ${fixed(degrees(roll), 1)} deg, thrust right ` +
      `${fixed(thrust[0] / 1000, 1)} kN, left ${fixed(thrust[1] / 1000, 1)} kN`);
  }
}
