// Explore: a flight is chosen by hand, and trim, linear model and roots follow.

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
    this.phasors = new Phasors(byId('phasors'), byId('phasor_mode'), (name) => this.showMode(name));
    this.sensitivities = new Sensitivities(byId('by_choices'), byId('by_elements'), byId('moved_mode'), (other) => this.solve(other));
    for (const plane of [this.near, this.all]) plane.onChoose = (mode) => this.phasors.choose(mode);
    byId('show_forces').addEventListener('change', (event) => {
      this.point.forces = Number(event.target.checked);
      this.showAircraft();
      this.write();
    });
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
    byId('show_forces').checked = this.point.forces !== 0;
    document.querySelector('#choices [name=interconnect]').disabled = this.point.governor !== 2;
    for (const input of document.querySelectorAll('#choices [name]')) {
      const value = this.point[input.name], choice = kChoices[input.name];
      if (input.type === 'checkbox') input.checked = value !== 0;
      else input.value = value;
      const shown = byId(`${input.name}_value`);
      if (shown) shown.textContent = input.name === 'flap' && value < 0 ? 'by mast angle'
        : `${fixed(value, choice.digits)} ${choice.unit}`;
    }
  }

  // What belongs to the mode that is looked at; with a name it was chosen by hand.
  showMode(name) {
    if (name !== undefined) this.point.mode = name;
    if (name !== undefined) this.write();
    const mode = this.phasors.mode();
    for (const plane of [this.near, this.all]) plane.rule(mode);
    this.sensitivities.show(mode);
  }
  showAircraft() {
    const {seen = null, forces = null} = this.found, shown = this.point.forces !== 0 ? forces : null;
    for (const id of ['side', 'front']) byId(id).toggleAttribute('hidden', seen === null);
    byId('no_picture').hidden = seen !== null;
    this.view.show(seen, shown);
    this.front.show(seen, shown);
    listForces(byId('forces'), shown);
  }

  compute() {
    const start = performance.now();
    const found = this.solve(this.point);
    this.found = found;
    if (found.seen) {
      this.trail.push({...this.point});
      if (this.trail.length > 400) this.trail.shift();
    }
    this.corridor.show(this.point, this.trail);
    this.bars.show(found.seen || null);
    this.showAircraft();
    const modes = found.linear ? found.linear.modes : [];
    this.near.show(modes);
    this.all.show(modes);
    this.sensitivities.begin(this.point, found.linear || null, found.seen ? found.seen.conf[kConf.flap] : 0);
    this.phasors.show(found.linear || null, this.point.mode);
    listModes(byId('modes'), modes);
    byId('where').textContent = `Mast ${fixed(this.point.mast, 1)} deg, ${fixed(this.point.speed, 1)} m/s ` +
      `(${fixed(this.point.speed / kKnot, 0)} kt)`;
    byId('sentence').textContent = found.text;
    byId('sentence').className = found.isClean ? 'good' : 'limit';
    byId('cost').textContent = `${fixed(performance.now() - start, 0)} ms`;
    this.write();
  }
  write() {
    if (!document.body.classList.contains('flying')) history.replaceState(null, '', writeAddress(this.point));
  }

  // Trim, linear model and modes of the point; a sentence whatever happens.
  solve(point) {
    const {aircraft} = this, {tiltrotor: library} = aircraft;
    if (aircraft.begin(loading(point)) !== 0) return {text: `No such aircraft: ${library.lastText()}.`};
    if (point.governor || point.scas) {
      const status = aircraft.setSystems({governor: point.governor, engines: point.governor ? 1 : 0, scas: point.scas,
        interconnect: point.interconnect});
      if (status !== 0) return {text: `The systems refuse: ${library.statusText(status)}.`};
    }
    const status = aircraft.trim(point.speed);
    const text = `${library.statusText(status)}; ${library.lastText()}.`;
    if (!kTrimmed.has(status)) return {text: `No level flight here: ${text}`};
    const looked = aircraft.look();
    if (looked !== 0) return {text: `Nothing to see: ${library.statusText(looked)}.`};
    const seen = aircraft.seen();
    const loads = aircraft.componentForces();
    const forces = loads && withInPlane(loads, seen.conf[kConf.mast] * kDegree), linear = aircraft.linearize();
    return {seen, forces, linear, isClean: status === 0,
      text: (status === 0 ? 'Trimmed: ' : 'Trimmed beyond a limit: ') + text +
        (linear ? '' : ' No linear model there.')};
  }

  // A sentence where the flight has no mode of the name that was asked for; the usual one is shown then.
  modeFaults() {
    const {linear} = this.found, {mode} = this.point;
    if (!mode || !linear || linear.modes.some(({name}) => name === mode)) return [];
    this.point.mode = '';
    this.write();
    const names = [...new Set(linear.modes.map(({name}) => name.replace(/ /g, '_')))];
    return [`mode=${mode.replace(/ /g, '_')} is none of this flight: there are ${names.join(', ')}.`];
  }

  // Sensitivities, then the map, while nothing else is asked.
  idle() {
    if (!this.isAsked && !this.corridor.isDragged) {
      if (!this.sensitivities.isDone()) this.settle(1);
      else if (!this.corridor.isDone()) this.corridor.slice(kSlice);
    }
    byId('map_state').textContent = this.corridor.isDone() ? '' : 'map is computed…';
  }
  // So many of the choices whose effect is to be known, and what is known then.
  settle(count) {
    for (let k = 0; k < count && !this.sensitivities.isDone(); ++k) this.sensitivities.step();
    this.sensitivities.show(this.phasors.mode());
  }
}
