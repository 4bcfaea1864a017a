// What moves the root of a mode, the largest effect first: every choice, with the flight trimmed again, and the elements of A.

// The usual change of a choice; backwards where the flight does not trim.
const kUsualChanges = [
  {name: 'mast', label: 'Mast', by: 5, unit: 'deg', digits: 0},
  {name: 'speed', label: 'Speed', by: 5, unit: 'm/s', digits: 0},
  {name: 'altitude', label: 'Altitude', by: 500, unit: 'm', digits: 0},
  {name: 'mass', label: 'Mass', by: 200, unit: 'kg', digits: 0},
  {name: 'cg', label: 'CG station', by: 0.025, unit: 'm', digits: 3},
  {name: 'flap', label: 'Flap', by: 10, unit: 'deg', digits: 0},
];
const kElementPart = 0.1;  // of an element of A
const kMostRows = 8;

// d(root) for 10 % of every element: exact, of the left and right eigenvectors.
function elementMotions(linear, mode) {
  const {a, n, states} = linear;
  const right = eigenvector(a, n, mode);
  const left = eigenvector(Array.from(a, (_, k) => a[(k % n) * n + Math.floor(k / n)]), n, mode);
  const times = ([p, q], [r, s]) => [p * r - q * s, p * s + q * r];
  const scale = left.reduce((sum, w, k) => { const z = times(w, right[k]); return [sum[0] + z[0], sum[1] + z[1]]; }, [0, 0]);
  const size = scale[0] ** 2 + scale[1] ** 2;
  const found = [];
  for (let i = 0; i < n; ++i) {
    for (let j = 0; j < n; ++j) {
      if (a[i * n + j] === 0) continue;
      const z = times(times(left[i], right[j]), [scale[0] / size, -scale[1] / size]);
      const part = kElementPart * a[i * n + j];
      found.push({label: `d${states[i]}/dt by ${states[j]}`, change: '10 %', real: part * z[0], imag: mode.imag > 0 ? part * z[1] : 0});
    }
  }
  return sorted(found).slice(0, kMostRows);
}
const sorted = (motions) => motions.sort((p, q) => Math.abs(q.real) - Math.abs(p.real));

// The root of that name, the nearest where there are several.
function sameMode(modes, mode) {
  const distance = (other) => Math.hypot(other.real - mode.real, other.imag - mode.imag);
  const named = modes.filter(({name}) => name === mode.name);
  return (named.length > 0 ? named : modes).reduce((best, other) => (best === null || distance(other) < distance(best) ? other : best), null);
}

class Sensitivities {
  // solve(point): {linear} as Explore has it
  constructor(choices, elements, title, solve) {
    Object.assign(this, {choices, elements, title, solve, queue: [], models: []});
  }
  // Another flight: all is to be computed again, while nobody drags.
  begin(point, linear, flapNow) {
    this.point = {...point};
    this.linear = linear;
    this.models = [];
    this.queue = linear === null ? [] : [...kUsualChanges];
    this.flapNow = flapNow;
  }
  isDone() { return this.queue.length === 0; }
  // One trim and its linear model; the change goes backwards from the end of a range.
  step() {
    const change = this.queue.shift();
    const {name, by} = change, {low, high} = kChoices[name];
    const start = name === 'flap' && this.point.flap < 0 ? this.flapNow : this.point[name];
    for (const way of [1, -1]) {
      const value = start + way * by;
      if (value < Math.max(low, 0) || value > high) continue;
      const {linear} = this.solve({...this.point, [name]: value});
      if (!linear) continue;
      this.models.push({change, way, modes: linear.modes});
      break;
    }
  }
  show(mode) {
    this.title.textContent = mode === null ? '' : mode.name;
    const rows = mode === null ? [] : this.models.map(({change, way, modes}) => {
      const other = sameMode(modes, mode);
      const amount = `${way > 0 ? '+' : '−'}${fixed(change.by, change.digits)} ${change.unit}`;
      return {label: change.label, change: amount, real: other.real - mode.real, imag: other.imag - mode.imag};
    });
    this.list(this.choices, sorted(rows));
    this.list(this.elements, mode === null ? [] : elementMotions(this.linear, mode));
  }
  list(place, rows) {
    const most = Math.max(...rows.map(({real}) => Math.abs(real)), 1e-12);
    place.replaceChildren(...rows.map(({label, change, real, imag}) => {
      const part = Math.abs(real) / most * 50;
      const track = html('div', {class: 'track open'}, html('i', {class: 'middle', style: 'left:50%'}),
        html('div', {class: real > 0 ? 'fill worse' : 'fill', style: `left:${real > 0 ? 50 : 50 - part}%;width:${part}%`}));
      return html('div', {class: 'bar sensitivity', tabindex: 0, 'data-tip': `${label} ${change}: the root moves by ` +
        `${significant(real)}${imag === 0 ? '' : `, ${significant(imag)} i`} 1/s`},
      html('span', {}, `${label} `, html('small', {}, change)), track, html('span', {class: 'value'}, signed(real)));
    }));
  }
}
const signed = (value) => (value > 0 ? '+' : '') + fixed(value, Math.abs(value) < 0.1 ? 4 : 3);
