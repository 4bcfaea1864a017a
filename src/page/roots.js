// Roots of the linear model in a plane, with names, where they were before, and what handling qualities ask of the mode that
// was chosen: levels.js.

const kTrail = 240;         // roots kept
const kNameGap = 3;         // between names
const kLetter = 5.9;        // of a name, about

class Roots {
  constructor(element, isNear) {
    this.isNear = isNear;
    this.chart = new Chart(element, this.axes([-3, 1], [0, 3]));
    this.trail = svg('g', {class: 'trail'});
    this.lines = svg('g', {class: 'levels'});
    this.onChoose = (mode) => this.rule(mode);
    this.now = svg('g');
    this.chart.below.append(this.lines);
    this.chart.marks.append(this.trail, this.now);
    this.before = [];
    this.wanted = 'dutch roll';
    this.rule(null);
  }
  axes(x, y) {
    return {x, y, xLabel: 'Real part, 1/s', yLabel: 'Imaginary part, rad/s', width: 400, height: this.isNear ? 300 : 260};
  }
  // Edges of the levels of a mode, good to the left of them, and the half plane that grows.
  rule(mode) {
    const {chart} = this, {x: [x0, x1], y: [y0, y1]} = chart.axes;
    this.chosen = mode;
    if (mode !== null) this.wanted = mode.name;
    this.lines.replaceChildren(svg('rect', {x: chart.x(0), y: chart.top, width: Math.max(0, chart.right - chart.x(0)),
      height: chart.bottom - chart.top, class: 'unstable_side'}));
    const taken = [];
    for (const level of (mode && kModeLevels[mode.name]) || []) {
      const edge = levelEdge(level, 1.5 * Math.hypot(x0, y1));
      const seen = edge.filter(([re, im]) => re >= x0 && re <= x1 && im >= y0 && im <= y1);
      const tip = `${mode.name}, level ${level.level} to the left of this: ${levelWords(level)} (MIL-F-8785C, MIL-STD-1797A, ${kLevelText})`;
      const points = edge.map(([re, im]) => `${chart.x(re)},${chart.y(im)}`).join(' ');
      this.lines.append(svg('polyline', {points, class: `level level${level.level}`}),
        svg('polyline', {points, class: 'level_grip', 'data-tip': tip}));
      if (seen.length === 0) continue;
      const [re, im] = seen[seen.length - 1], at = {x: chart.x(re) - 4, y: Math.max(chart.y(im), chart.top) + 11};
      while (taken.some((t) => Math.abs(t.x - at.x) < 16 && Math.abs(t.y - at.y) < 11)) at.y += 12;
      taken.push(at);
      this.lines.append(svg('text', {x: at.x, y: at.y, 'text-anchor': 'end', class: 'name'}, `L${level.level}`));
    }
  }
  // Axes that hold all roots, in steps so that they stand still while a point is dragged a little.
  fit(modes) {
    const wide = (size) => {
      const power = 10 ** Math.floor(Math.log10(Math.max(size, 1)));
      return power * [1, 2, 4, 6, 10].find((step) => step * power >= size);
    };
    const least = wide(Math.max(...modes.map((mode) => -mode.real)) * 1.05);
    const most = Math.max(0.1 * least, wide(Math.max(...modes.map((mode) => mode.real), 0.1)));
    const high = wide(Math.max(...modes.map((mode) => mode.imag), 1) * 1.1);
    const {x, y} = this.chart.axes;
    if (x[0] === -least && x[1] === most && y[1] === high) return;
    this.chart.setAxes(this.axes([-least, most], [0, high]));
    this.before = [];
    this.trail.replaceChildren();
    this.rule(this.chosen);
  }
  clear() {
    this.before = [];
    this.trail.replaceChildren();
    this.now.replaceChildren();
  }
  show(modes) {
    if (!this.isNear && modes.length > 0) this.fit(modes);
    const {chart} = this;
    const [x0, x1] = chart.axes.x, [y0, y1] = chart.axes.y;
    const inside = modes.filter((m) => m.real >= x0 && m.real <= x1 && m.imag >= y0 && m.imag <= y1);
    for (const root of this.before) this.trail.append(svg('circle', {cx: root.x, cy: root.y, r: 1.6}));
    while (this.trail.childNodes.length > kTrail) this.trail.firstChild.remove();
    this.before = inside.map((m) => ({x: chart.x(m.real), y: chart.y(m.imag)}));
    this.now.replaceChildren();
    if (modes.length > 0) this.rule(modes.find(({name}) => name === this.wanted) || null);
    const taken = this.before.map(({x, y}) => ({x0: x - 6, x1: x + 6, y0: y - 6, y1: y + 6}));
    inside.forEach((mode, k) => this.now.append(this.mark(mode, this.before[k])));
    inside.forEach((mode, k) => {
      const label = this.label(mode, this.before[k], taken);
      if (label) this.now.append(label);
    });
  }
  // Round: dies out. Square: grows.
  mark(mode, {x, y}) {
    const common = {'data-tip': modeText(mode), tabindex: 0, role: 'button', 'aria-label': modeText(mode)};
    const element = mode.real <= 0 ? svg('circle', {cx: x, cy: y, r: 5.5, class: 'stable', ...common})
      : svg('rect', {x: x - 5.5, y: y - 5.5, width: 11, height: 11, class: 'unstable', ...common});
    element.addEventListener('click', () => this.onChoose(mode));
    element.addEventListener('keydown', (event) => {
      if (event.key !== 'Enter' && event.key !== ' ') return;
      event.preventDefault();
      this.onChoose(mode);
    });
    return element;
  }
  // Beside its root where no other mark or name stands; else nowhere, and the list has it.
  label(mode, {x, y}, taken) {
    const width = kLetter * mode.name.length, {chart} = this;
    const places = [[9, 4], [-9 - width, 4], [-width / 2, -10], [-width / 2, 17], [9, -8], [-9 - width, -8], [9, 16],
      [-9 - width, 16], [-width / 2, -22], [-width / 2, 29]];
    for (const [dx, dy] of places) {
      const box = {x0: x + dx, x1: x + dx + width, y0: y + dy - 10, y1: y + dy + 3};
      const fits = box.x0 > chart.left && box.x1 < chart.right && box.y0 > chart.top && box.y1 < chart.bottom;
      const free = taken.every((t) => t.x1 + kNameGap < box.x0 || t.x0 - kNameGap > box.x1 || t.y1 < box.y0 || t.y0 > box.y1);
      if (!fits || !free) continue;
      taken.push(box);
      return svg('text', {x: box.x0, y: y + dy, class: 'name', 'pointer-events': 'none'}, mode.name);
    }
    return null;
  }
}

// The same as a table, for all who do not see planes.
function listModes(body, modes) {
  body.replaceChildren(...modes.map((mode) => html('tr', {'data-tip': modeText(mode)},
    html('th', {scope: 'row'}, mode.name), html('td', {}, fixed(mode.real, 3)),
    html('td', {}, mode.imag > 0 ? fixed(mode.imag, 3) : ''), html('td', {}, mode.imag > 0 ? fixed(mode.damping, 2) : ''),
    html('td', {}, String(Number(Math.abs(mode.half).toPrecision(3))) + (mode.half < 0 ? ' ×2' : '')), html('td', {}, levelOf(mode).replace('level ', '')))));
}
