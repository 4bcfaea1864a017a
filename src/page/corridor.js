// The conversion corridor: what level flight takes at every mast angle and speed, filled in while nobody drags, and the
// point that is dragged.

const kFastest = 140;                  // m/s
const kCellSpeed = 5, kCellMast = 7.5;  // m/s, deg
const kSlice = 8;                      // ms of the map at a time
// Blues that also stay ordered in grey: power of both rotors, kW.
const kShades = [[600, '#dcebf7'], [900, '#b7d4ea'], [1300, '#8bbadb'], [1800, '#5b9bc8'], [2400, '#3579b1'],
  [Infinity, '#1f5b93']];

const kColumns = Math.round(kFastest / kCellSpeed), kRows = Math.round(90 / kCellMast);

class Corridor {
  constructor(element, aircraft, onMove) {
    this.aircraft = aircraft;
    this.chart = new Chart(element, {x: [0, kFastest], y: [0, 90], xLabel: 'Speed, m/s',
      yLabel: 'Mast angle, deg', width: 400, height: 300});
    this.handle = svg('circle', {r: 9, class: 'handle', tabindex: 0, role: 'slider',
      'aria-label': 'Mast angle and speed; arrow keys move the point', 'aria-valuemin': 0, 'aria-valuemax': 90});
    this.path = svg('polyline', {class: 'trail_line'});
    this.chart.marks.append(this.path);
    element.append(this.handle);  // whole at the ends of the axes too
    const moveTo = (event) => {
      const {x, y} = this.chart.at(event);
      onMove(clamp(Math.round(x * 2) / 2, 0, kFastest), clamp(Math.round(y * 2) / 2, 0, 90));
    };
    element.addEventListener('pointerdown', (event) => {
      element.setPointerCapture(event.pointerId);
      this.isDragged = true;
      moveTo(event);
      this.handle.focus({preventScroll: true});
      event.preventDefault();
    });
    element.addEventListener('pointermove', (event) => { if (this.isDragged) moveTo(event); });
    for (const end of ['pointerup', 'pointercancel'])
      element.addEventListener(end, () => { this.isDragged = false; });
    this.handle.addEventListener('keydown', (event) => {
      const way = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key];
      if (way === undefined) return;
      event.preventDefault();
      const size = event.shiftKey ? 5 : 1;
      onMove(clamp(this.point.speed + size * way[0], 0, kFastest), clamp(this.point.mast + size * way[1], 0, 90));
    });
    this.cell = {};
    this.queue = [];
  }

  show(point, trail) {
    this.point = point;
    this.handle.setAttribute('cx', this.chart.x(point.speed));
    this.handle.setAttribute('cy', this.chart.y(point.mast));
    this.handle.setAttribute('aria-valuenow', point.mast);
    this.handle.setAttribute('aria-valuetext', `mast ${point.mast} deg, ${point.speed} m/s`);
    this.path.setAttribute('points', trail.map((p) => `${this.chart.x(p.speed)},${this.chart.y(p.mast)}`).join(' '));
  }

  // The map anew, for another loading or height; it grows from the middle of the corridor outwards.
  start(point) {
    this.setting = {...point};
    this.cell = {};
    this.chart.below.replaceChildren();
    this.queue = [];
    for (let row = 0; row <= kRows; ++row) {
      const mast = row * kCellMast;
      const middle = Math.round((20 + mast * 0.6) / kCellSpeed);
      this.queue.push({mast, k: middle, way: 1, failures: 0}, {mast, k: middle - 1, way: -1, failures: 0});
    }
  }
  isDone() { return this.queue.length === 0; }

  // Some trims; each run ends at the second flight in a row that does not trim.
  slice(milliseconds) {
    const end = performance.now() + milliseconds;
    while (!this.isDone() && performance.now() < end) {
      const run = this.queue.shift();
      if (run.k < 0 || run.k > kColumns) continue;
      const speed = run.k * kCellSpeed;
      const flown = this.fly(run.mast, speed);
      this.draw(run.mast, speed, flown);
      run.failures = flown.trimmed ? 0 : run.failures + 1;
      run.k += run.way;
      if (run.failures < 2) this.queue.push(run);
    }
  }
  fly(mast, speed) {
    const {aircraft} = this;
    if (aircraft.begin({...this.setting, mast}) !== 0) return {trimmed: false, text: aircraft.tiltrotor.lastText()};
    const status = aircraft.trim(speed);
    const text = aircraft.tiltrotor.statusText(status);
    if (!kTrimmed.has(status) || aircraft.look() !== 0) return {trimmed: false, text};
    const {outputs} = aircraft.array;
    return {trimmed: true, status, text, power: (outputs[kOut.power] + outputs[kOut.power + 1]) / 1000};
  }
  draw(mast, speed, flown) {
    const {chart} = this;
    const x0 = chart.x(Math.max(0, speed - kCellSpeed / 2)), x1 = chart.x(Math.min(kFastest, speed + kCellSpeed / 2));
    const y0 = chart.y(Math.min(90, mast + kCellMast / 2)), y1 = chart.y(Math.max(0, mast - kCellMast / 2));
    const place = {x: x0, y: y0, width: x1 - x0 + 0.3, height: y1 - y0 + 0.3};
    const tip = `Mast ${mast} deg, ${speed} m/s: ${flown.trimmed ? `${fixed(flown.power, 0)} kW` : 'no level flight'}` +
      `${flown.status === 0 ? '' : `, ${flown.text}`}`;
    const fill = flown.trimmed ? kShades.find(([most]) => flown.power < most)[1] : '#efefef';
    chart.below.append(svg('rect', {...place, fill, 'data-tip': tip}));
    if (flown.trimmed && flown.status !== 0)
      chart.below.append(svg('rect', {...place, fill: 'url(#hatch)', 'pointer-events': 'none'}));
    this.cell[`${mast},${speed}`] = flown;
  }
}
