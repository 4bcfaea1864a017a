// Explore: a flight is chosen by hand, and trim, linear model and roots follow.

// What is chosen, with the range of its slider; `usual` says what stands when nothing was chosen.
const kChoices = {
  mast: {low: 0, high: 90, usual: 0},
  speed: {low: 0, high: 140, usual: 40},
  altitude: {low: 0, high: 6000, usual: 0, unit: 'm', digits: 0},
  mass: {low: 4300, high: 7200, usual: 5897, unit: 'kg', digits: 0},
  cg: {low: 7.5, high: 7.8, usual: 7.65, unit: 'm', digits: 3},
  flap: {low: -1, high: 75, usual: -1, unit: 'deg', digits: 0},
  governor: {low: 0, high: 2, usual: 0},
  scas: {low: 0, high: 1, usual: 0},
};

// The address: #mast=30&speed=60; numbers that are none, or out of range, are left out.
function readAddress(address) {
  const point = {};
  const given = new URLSearchParams(address.replace(/^#/, ''));
  for (const [name, choice] of Object.entries(kChoices)) {
    const number = given.get(name) === null || given.get(name).trim() === '' ? NaN : Number(given.get(name));
    point[name] = Number.isFinite(number) ? clamp(number, choice.low, choice.high) : choice.usual;
  }
  point.governor = Math.round(point.governor);
  point.scas = Math.round(point.scas);
  return point;
}
function writeAddress(point) {
  const changed = Object.keys(kChoices).filter((name) => point[name] !== kChoices[name].usual ||
    name === 'mast' || name === 'speed');
  return `#${changed.map((name) => `${name}=${point[name]}`).join('&')}`;
}

// What begin() takes.
function loading(point) {
  return {mast: point.mast, flap: point.flap < 0 ? null : point.flap, altitude: point.altitude, mass: point.mass,
    cg: point.cg};
}

class Explore {
  constructor(library, point) {
    this.aircraft = new Aircraft(library, 0);
    this.point = point;
    this.trail = [];
    this.corridor = new Corridor(byId('corridor'), this.aircraft, (speed, mast) => this.change({speed, mast}));
    this.near = new Roots(byId('near'), true);
    this.all = new Roots(byId('all'), false);
    this.bars = new TrimBars(byId('bars'));
    this.view = new SideView(byId('side'));
    this.front = new FrontView(byId('front'));
    this.phasors = new Phasors(byId('phasors'), byId('phasor_mode'));
    for (const input of document.querySelectorAll('#choices [name]'))
      input.addEventListener('input', () => this.change({[input.name]: input.type === 'checkbox' ? Number(input.checked)
        : Number(input.value)}));
    byId('clear').addEventListener('click', () => this.clear());
    this.corridor.start(loading(this.point));
    this.fill();
    this.compute();
  }

  clear() {
    this.trail = [];
    this.near.clear();
    this.all.clear();
    this.compute();
  }

  // One computation a frame of the screen, of what was chosen last.
  change(chosen) {
    const before = loading(this.point);
    Object.assign(this.point, chosen);
    const after = loading(this.point);
    if (['flap', 'altitude', 'mass', 'cg'].some((name) => before[name] !== after[name])) this.corridor.start(after);
    this.fill();
    if (this.isAsked) return;
    this.isAsked = true;
    requestAnimationFrame(() => { this.isAsked = false; this.compute(); });
  }

  fill() {
    for (const input of document.querySelectorAll('#choices [name]')) {
      const value = this.point[input.name], choice = kChoices[input.name];
      if (input.type === 'checkbox') input.checked = value !== 0;
      else input.value = value;
      const shown = byId(`${input.name}_value`);
      if (shown) shown.textContent = input.name === 'flap' && value < 0 ? 'by mast angle'
        : `${fixed(value, choice.digits)} ${choice.unit}`;
    }
  }

  compute() {
    const start = performance.now();
    const found = this.solve();
    this.found = found;
    if (found.seen) {
      this.trail.push({...this.point});
      if (this.trail.length > 400) this.trail.shift();
    }
    this.corridor.show(this.point, this.trail);
    this.bars.show(found.seen || null);
    this.view.show(found.seen || null);
    this.front.show(found.seen || null);
    this.phasors.show(found.linear || null);
    const modes = found.linear ? found.linear.modes : [];
    this.near.show(modes);
    this.all.show(modes);
    listModes(byId('modes'), modes);
    byId('where').textContent = `Mast ${fixed(this.point.mast, 1)} deg, ${fixed(this.point.speed, 1)} m/s ` +
      `(${fixed(this.point.speed / kKnot, 0)} kt)`;
    byId('sentence').textContent = found.text;
    byId('sentence').className = found.isClean ? 'good' : 'limit';
    byId('cost').textContent = `${fixed(performance.now() - start, 0)} ms`;
    if (!document.body.classList.contains('flying')) history.replaceState(null, '', writeAddress(this.point));
  }

  // Trim, linear model and modes of the point; a sentence whatever happens.
  solve() {
    const {aircraft, point} = this, {tiltrotor: library} = aircraft;
    if (aircraft.begin(loading(point)) !== 0) return {text: `No such aircraft: ${library.lastText()}.`};
    if (point.governor || point.scas) {
      const status = aircraft.setSystems({governor: point.governor, engines: point.governor ? 1 : 0, scas: point.scas});
      if (status !== 0) return {text: `The systems refuse: ${library.statusText(status)}.`};
    }
    const status = aircraft.trim(point.speed);
    const text = `${library.statusText(status)}; ${library.lastText()}.`;
    if (!kTrimmed.has(status)) return {text: `No level flight here: ${text}`};
    const looked = aircraft.look();
    if (looked !== 0) return {text: `Nothing to see: ${library.statusText(looked)}.`};
    const seen = aircraft.seen();
    const linear = aircraft.linearize();
    return {seen, linear, isClean: status === 0,
      text: (status === 0 ? 'Trimmed: ' : 'Trimmed beyond a limit: ') + text +
        (linear ? '' : ' No linear model there.')};
  }

  // The map grows while nothing else is asked.
  idle() {
    if (!this.isAsked && !this.corridor.isDragged && !this.corridor.isDone()) this.corridor.slice(kSlice);
    byId('map_state').textContent = this.corridor.isDone() ? '' : 'map is computed…';
  }
}
