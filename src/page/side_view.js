// The aircraft from the right, in the attitude of the trim, masts where they are; thrust, weight and the way through the
// air as arrows. Drawn in the stations of the aircraft, inches: SL aft, WL up. A sketch, its axes and hubs to scale.

const kSide = {cg: [301, 82], pivot: [300, 100], hub: 56, disk: 150};  // hub: above the pivot
const kWeightArrow = 130;                                              // inches a weight

class SideView {
  constructor(element) {
    this.element = element;
    element.setAttribute('viewBox', '-330 -250 660 440');
    this.body = svg('g');
    this.arrows = svg('g');
    element.append(this.body, this.arrows);
  }
  // Stations to places: nose to the right, CG in the middle.
  at(sl, wl) { return [-(sl - kSide.cg[0]), -(wl - kSide.cg[1])]; }
  polygon(points, attributes) {
    return svg('polygon', {points: points.map(([sl, wl]) => this.at(sl, wl).join(',')).join(' '), ...attributes});
  }
  // `forces`: of the components, or null for none.
  show(seen, forces) {
    this.body.replaceChildren();
    this.arrows.replaceChildren();
    if (seen === null) return;
    const pitch = seen.x[kX.pitch], mast = seen.conf[kConf.mast] * kDegree;
    const [px, py] = this.at(...kSide.pivot);
    const along = [Math.sin(mast), -Math.cos(mast)];  // from the pivot to the hub
    const hub = [px + kSide.hub * along[0], py + kSide.hub * along[1]];
    const across = [-along[1], along[0]];
    const disk = {x1: hub[0] - kSide.disk * across[0], y1: hub[1] - kSide.disk * across[1],
      x2: hub[0] + kSide.disk * across[0], y2: hub[1] + kSide.disk * across[1]};
    this.body.append(
      this.polygon([[62, 68], [85, 84], [125, 100], [160, 116], [230, 120], [400, 112], [560, 100], [568, 90], [470, 76],
        [380, 54], [300, 46], [150, 46], [90, 54]], {class: 'fuselage'}),
      this.polygon([[532, 84], [548, 177], [588, 177], [592, 84]], {class: 'surface'}),
      this.polygon([[530, 103], [540, 108], [590, 104], [540, 99]], {class: 'surface'}),
      this.polygon([[96, 86], [125, 100], [150, 112], [165, 104], [150, 90]], {class: 'window'}),
      svg('g', {transform: `translate(${px} ${py}) rotate(${degrees(mast)})`},
        svg('rect', {x: -17, y: -46, width: 34, height: 112, rx: 14, class: 'nacelle'})),
      svg('line', {x1: px, y1: py, x2: hub[0], y2: hub[1], class: 'mast'}),
      svg('line', {...disk, class: 'disk', 'data-tip': `Rotor disk, mast angle ${fixed(degrees(mast), 1)} deg`}));
    this.body.setAttribute('transform', `rotate(${-degrees(pitch)})`);
    const weight = seen.conf[kConf.mass] * 9.80665;
    const turned = ([x, y]) => [x * Math.cos(pitch) + y * Math.sin(pitch), y * Math.cos(pitch) - x * Math.sin(pitch)];
    const thrust = seen.out[kOut.thrust] + seen.out[kOut.thrust + 1];
    const size = kWeightArrow * thrust / weight;
    const from = turned(hub), to = turned([hub[0] + size * along[0], hub[1] + size * along[1]]);
    const speed = seen.out[kOut.airspeed], inchOf = (newton) => kWeightArrow * newton / weight;
    const hubStation = [kSide.cg[0] - hub[0], kSide.cg[1] - hub[1]];
    if (forces !== null)
      this.arrows.append(...forceLayer(forceArrows(forces, hubStation, false).map((found) => ({found, at: turned(this.at(...found.from)),
        by: turned([inchOf(found.force[0]), inchOf(found.force[2])])})), [...placesOn(from, to), ...placesOn([0, 0], [0, kWeightArrow])]));
    this.arrows.append(
      arrow(...from, ...to, {class: 'thrust', 'data-tip': `Thrust of both rotors ${fixed(thrust / 1000, 1)} kN, ` +
        `${fixed(thrust / weight, 2)} of the weight`}),
      arrow(0, 0, 0, kWeightArrow, {class: 'weight', 'data-tip': `Weight ${fixed(weight / 1000, 1)} kN`}),
      svg('circle', {r: 6, class: 'cg', 'data-tip': 'Centre of gravity'}),
      arrow(200, -215, 200 + speed, -215, {class: 'speed', 'data-tip': `Airspeed ${fixed(speed, 1)} m/s`}),
      svg('text', {x: 195, y: -210, 'text-anchor': 'end'}, `${fixed(speed, 1)} m/s`),
      svg('text', {x: -325, y: -228}, `pitch ${fixed(degrees(pitch), 1)} deg`),
      svg('text', {x: -325, y: -206}, `mast ${fixed(degrees(mast), 1)} deg`));
    this.element.setAttribute('aria-label', `Aircraft from the right: pitch ${fixed(degrees(pitch), 1)} deg, mast ` +
      `${fixed(degrees(mast), 1)} deg, thrust ${fixed(thrust / weight, 2)} of the weight`);
  }
}
