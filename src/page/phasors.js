// Eigenvectors as phasors: how the motions of the body stand to each other in one mode.

const kRigid = {u: 'speed', v: 'speed', w: 'speed', p: 'rate', q: 'rate', r: 'rate', phi: 'angle', theta: 'angle'};
const kOffRoot = 1e-7;     // of the size of the root: the matrix of the iteration is not singular
const kUsualMode = 'dutch roll';
const kLeastPhasor = 0.05;  // of the longest of its kind: shorter ones are not drawn

// The eigenvector of a (n rows) at a root by inverse iteration, [real, imaginary] of every state.
function eigenvector(a, n, {real, imag}) {
  const off = kOffRoot * Math.max(Math.hypot(real, imag), 1e-3);
  let x = Array.from({length: n}, (_, k) => [1, 1 / (k + 1)]);
  for (let turn = 0; turn < 3; ++turn) {
    const rows = Array.from({length: n}, (_, i) => Array.from({length: n}, (__, j) => [a[i * n + j] - (i === j ? real + off : 0),
      i === j ? -imag : 0]));
    x = solveComplex(rows, x);
    const largest = Math.max(...x.map(([re, im]) => Math.hypot(re, im)));
    x = x.map(([re, im]) => [re / largest, im / largest]);
  }
  return x;
}

// A root from a nearby number.
function quotient(a, n, near) {
  const x = eigenvector(a, n, near), k = x.reduce((best, z, i) => (Math.hypot(...z) > Math.hypot(...x[best]) ? i : best), 0);
  const sum = [0, 1].map((part) => x.reduce((total, z, j) => total + a[k * n + j] * z[part], 0)), size = x[k][0] ** 2 + x[k][1] ** 2;
  return {real: (sum[0] * x[k][0] + sum[1] * x[k][1]) / size, imag: (sum[1] * x[k][0] - sum[0] * x[k][1]) / size};
}

// Gauss with the largest pivot; rows and right side are used up.
function solveComplex(rows, right) {
  const n = rows.length, x = right.map((value) => [...value]);
  const size = ([re, im]) => Math.hypot(re, im);
  const over = ([a, b], [c, d]) => [(a * c + b * d) / (c * c + d * d), (b * c - a * d) / (c * c + d * d)];
  const take = (to, f, from) => { to[0] -= f[0] * from[0] - f[1] * from[1]; to[1] -= f[0] * from[1] + f[1] * from[0]; };
  for (let k = 0; k < n; ++k) {
    let pivot = k;
    for (let i = k + 1; i < n; ++i) if (size(rows[i][k]) > size(rows[pivot][k])) pivot = i;
    [rows[k], rows[pivot]] = [rows[pivot], rows[k]];
    [x[k], x[pivot]] = [x[pivot], x[k]];
    for (let i = k + 1; i < n; ++i) {
      if (size(rows[i][k]) === 0) continue;
      const f = over(rows[i][k], rows[k][k]);
      for (let j = k; j < n; ++j) take(rows[i][j], f, rows[k][j]);
      take(x[i], f, x[k]);
    }
  }
  for (let k = n - 1; k >= 0; --k) {
    for (let j = k + 1; j < n; ++j) take(x[k], x[j], rows[k][j]);
    x[k] = over(x[k], rows[k][k]);
  }
  return x;
}

// Those of the body: {name, kind, size, angle}, the longest of a kind 1; angles from the longest angle of attitude, else speed.
function bodyPhasors(linear, mode) {
  const x = eigenvector(linear.a, linear.n, mode);
  const found = linear.states.map((name, k) => ({name, kind: kRigid[name], size: Math.hypot(...x[k]),
    angle: Math.atan2(x[k][1], x[k][0])})).filter(({kind}) => kind !== undefined);
  const longest = (kind) => found.filter((p) => p.kind === kind).reduce((most, p) => (p.size > most.size ? p : most), {size: 0});
  const first = longest('angle').size > 0 ? longest('angle') : longest('speed');
  const most = {speed: longest('speed').size, rate: longest('rate').size, angle: longest('angle').size};
  return found.map(({name, kind, size, angle}) => ({name, kind, size: most[kind] > 0 ? size / most[kind] : 0,
    angle: Math.atan2(Math.sin(angle - first.angle), Math.cos(angle - first.angle))}));
}

class Phasors {
  // onChoose(name): what belongs to the mode is to be shown; a name where it was chosen by hand
  constructor(element, choice, onChoose) {
    this.element = element;
    this.choice = choice;
    this.linear = null;
    element.setAttribute('viewBox', '-150 -125 300 250');
    this.onChoose = onChoose;
    choice.addEventListener('change', () => this.choose(this.mode()));
  }
  // The mode of that name, '': the usual one; where there is none, the first.
  show(linear, wanted) {
    this.linear = linear;
    const modes = linear === null ? [] : linear.modes;
    this.choice.replaceChildren(...modes.map((mode, k) => html('option', {value: `${mode.name} ${k}`}, mode.name)));
    const place = Math.max(0, modes.findIndex((mode) => mode.name === (wanted || kUsualMode)));
    this.choice.selectedIndex = modes.length > 0 ? place : -1;
    this.draw();
  }
  mode() { return this.linear === null ? null : this.linear.modes[this.choice.selectedIndex] || null; }
  choose(mode) {
    this.choice.selectedIndex = this.linear.modes.indexOf(mode);
    this.draw(mode.name);
  }
  draw(chosen) {
    this.onChoose(chosen);
    this.element.replaceChildren(svg('circle', {r: 100, class: 'phasor_circle'}),
      svg('line', {x1: -112, x2: 112, y1: 0, y2: 0, class: 'zero'}), svg('line', {y1: -112, y2: 112, x1: 0, x2: 0, class: 'zero'}));
    const mode = this.mode();
    if (mode === null) return;
    const phasors = bodyPhasors(this.linear, mode).filter(({size}) => size >= kLeastPhasor);
    const text = phasors.map((p) => `${p.name} ${fixed(p.size, 2)} at ${fixed(degrees(p.angle), 0)} deg`);
    this.element.setAttribute('aria-label', `${mode.name}: ${text.join(', ')}`);
    const taken = [];
    phasors.forEach((p, k) => {
      const x = 100 * p.size * Math.cos(p.angle), y = -100 * p.size * Math.sin(p.angle);
      this.element.append(arrow(0, 0, x, y, {class: `phasor_${p.kind}`, 'data-tip': `${text[k]} (${p.kind}, of the longest)`}));
      // Names of phasors that coincide stand one above the other.
      const at = {x: x * 1.1 + 5 * Math.sign(x), y: y * 1.1 + 4};
      while (taken.some((t) => Math.abs(t.x - at.x) < 26 && Math.abs(t.y - at.y) < 12)) at.y += 12;
      taken.push(at);
      this.element.append(svg('text', {x: at.x, y: at.y, class: 'name', 'text-anchor': x < -1 ? 'end' : 'start'}, p.name));
    });
  }
}
