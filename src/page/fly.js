// Fly: the whole vehicle in steps of 0.01 s, with the hands of sticks.js.

const kStep = 0.01;               // s
const kMostSteps = 10;            // a frame of the screen; then the flight is slower than the clock
const kModelEvery = 0.2;          // s between linear models
const kHeight = 300;              // m, of the wheels where a flight begins
const kOffload = 0.5;             // 1/s: the lever takes over what the governor has added
const kLeverCollective = 3 * kDegree, kLeverAlone = 8 * kDegree;  // of half its travel; alone: without a governor
const kMastKey = 5;               // deg
const kRotorRate = 1;             // rad/s^2, of the governor's reference: as the command line moves it
const kClear = 1;                 // m, of the wheels: no weight on them

const kFlying = 'In flight; the space bar pauses and resumes it.';

// Keys that a lever or switch keeps while it has the focus; all others fly.
const kArrows = ['ArrowUp', 'ArrowDown', 'ArrowLeft', 'ArrowRight', 'Home', 'End', 'PageUp', 'PageDown'];
const kLeverKeys = {range: kArrows, checkbox: [' ', 'Enter'], 'select-one': [...kArrows, ' ', 'Enter', 'Escape']};

// Of the CG above the wheels, m: as the command line counts heights.
const restHeight = (seen) => kAircraft.WL_CG_helicopter - kAircraft.ground_WL_static;

class Fly {
  constructor(library) {
    this.aircraft = new Aircraft(library, 1);
    this.sticks = new Sticks();
    this.cockpit = new Cockpit(byId('cockpit'));
    this.roots = new Roots(byId('fly_near'), true);
    this.roots.onChoose = (mode) => {
      this.roots.rule(mode);
      this.point.mode = mode.name;
      this.write();
    };
    this.matrices = new Matrices(byId('matrices'));
    this.isRunning = false;
    this.levers = byId('levers');
    this.levers.addEventListener('input', (event) => this.moveLever(event.target));
    // After a hand with a pointer the keys are the cockpit's again.
    for (const type of ['pointerdown', 'keydown']) this.levers.addEventListener(type, () => { this.isPointed = type === 'pointerdown'; });
    this.levers.addEventListener('change', () => { if (this.isPointed) byId('cockpit').focus({preventScroll: true}); });
    byId('run').addEventListener('click', () => this.run(!this.isRunning));
    byId('again').addEventListener('click', () => this.begin(this.point));
    byId('trim_here').addEventListener('click', () => this.sticks.hold());
    byId('save_script').addEventListener('click', () => download('flight.txt', this.recorder.script(this.steps)));
    byId('save_series').addEventListener('click', () => download('flight.csv', this.recorder.series()));
    document.addEventListener('keydown', (event) => this.key(event, true));
    document.addEventListener('keyup', (event) => this.key(event, false));
  }

  // In trim, systems on.
  begin(point) {
    this.point = {...point};
    this.steps = 0;
    this.owed = 0;
    this.isOver = true;
    this.run(false);
    const {aircraft} = this, governor = point.governor === 0 ? 2 : point.governor;
    if (aircraft.begin(loading(point)) !== 0) return this.say(`No such aircraft: ${aircraft.tiltrotor.lastText()}.`);
    const rest = restHeight();
    const status = [() => aircraft.setHeight(kHeight + rest), () => aircraft.setEnvironment([0, 0, 0], point.altitude),
      () => aircraft.setSystems({governor: 2, conversion: 1, engines: 1, actuators: 1, scas: 1, gear: 1, gearDown: 0}),
    ].reduce((before, call) => (before === 0 ? call() : before), 0);
    const refuses = (code) => this.say(`The flight cannot begin: ${aircraft.tiltrotor.statusText(code)}.`);
    if (status !== 0) return refuses(status);
    const trimmed = aircraft.trim(point.speed);
    if (!kTrimmed.has(trimmed))
      return this.say(`The flight cannot begin: no level flight at mast ${point.mast} deg and ${point.speed} m/s. ` +
        'Choose another point under Explore.');
    aircraft.look();
    const {u, sys} = aircraft.seen();
    this.throttle = this.throttleOfTrim = clamp(sys[kSys.throttle], 0, 1);
    const {interconnect} = point, begun = aircraft.setSystems({governor, interconnect, groundEffect: 1, throttle: this.throttle}) ||
      aircraft.setControls(u.slice(0, 4)) || aircraft.look();
    if (begun !== 0) return refuses(begun);
    this.seen = aircraft.seen();
    this.collective = this.seen.u[kU.collective];
    this.rotor = this.rotorOfTrim = this.seen.conf[kConf.rotor];
    this.sticks.reset({long: u[kU.longStick], lat: u[kU.latStick], pedal: u[kU.pedal]});
    this.recorder = new Recorder({...loading(point), speed: point.speed, height: kHeight, governor, interconnect}, kStep);
    this.recorder.inputs(0, this.seen.u, this.throttle);
    this.lever('mast').value = point.mast;
    this.lever('flap').value = Math.round(sys[kSys.flap]);
    this.lever('wind').value = this.lever('w20').value = 0;
    this.lever('governor').value = governor;
    this.lever('interconnect').checked = point.interconnect !== 0;
    this.lever('scas').checked = true;
    this.lever('gear').checked = false;
    this.nameLevers();
    this.roots.clear();
    this.roots.wanted = point.mode || kUsualMode;
    this.isOver = false;
    this.model();
    this.draw();
    return this.say(`In trim at ${fixed(point.speed, 0)} m/s, mast ${fixed(point.mast, 0)} deg, ${kHeight} m. ` +
      'Start, or the space bar.', true);
  }
  write() { history.replaceState(null, '', writeAddress(this.point, true)); }
  say(sentence, isGood = false) {
    const place = byId('flight_sentence');
    place.textContent = sentence;
    place.className = isGood ? 'good' : 'limit';
    return isGood;
  }
  run(isRunning) {
    this.isRunning = isRunning && !this.isOver;
    this.before = undefined;
    byId('run').textContent = this.isRunning ? 'Pause' : 'Start';
  }
  // A key that goes up is let go of wherever that is; one that goes down and means something there does not fly.
  key(event, isDown) {
    if (!isDown) this.sticks.key(event, false);
    if (byId('fly').hidden || event.ctrlKey || event.metaKey || event.altKey) return;
    const target = event.target instanceof Element ? event.target : document.body;
    const isKept = event.defaultPrevented || (kLeverKeys[target.type] || []).includes(event.key);
    if (!isDown || isKept) return;
    const key = event.key.toLowerCase(), isPause = key === ' ' && target.tagName !== 'BUTTON';
    if (!event.repeat) {
      if (isPause) this.run(!this.isRunning);
      if (key === 't') this.sticks.hold();
      if (key === 'q' || key === 'e') {
        const mast = this.lever('mast');
        mast.value = clamp(Number(mast.value) + (key === 'e' ? kMastKey : -kMastKey), 0, 90);
        this.moveLever(mast);
      }
    }
    if (this.sticks.key(event, true) || isPause) event.preventDefault();
  }

  // ---- levers and switches, which are commands of the script ----

  lever(name) { return this.levers.elements[name]; }
  nameLevers() {
    this.lever('interconnect').disabled = this.lever('governor').value !== '2';
    byId('mast_lever').textContent = `${this.lever('mast').value} deg`;
    byId('flap_lever').textContent = `${this.lever('flap').value} deg`;
    byId('wind_lever').textContent = `${this.lever('wind').value} m/s`;
  }
  moveLever(input) {
    this.nameLevers();
    if (this.isOver) return;
    const {aircraft, recorder, steps} = this, value = Number(input.value);
    if (input.name === 'gear' && !input.checked && this.height() < kClear) {
      input.checked = true;
      return this.say('The gear stays down near the ground.');
    }
    const shaft = input.checked ? 1 : 0;
    const commands = {
      mast: () => [aircraft.setSystems({mast: value}), `mast ${value}`],
      flap: () => [aircraft.setSystems({flap: value}), `flap ${value}`],
      wind: () => [aircraft.setEnvironment([-value, 0, 0], this.point.altitude), `wind ${-value} 0 0`],
      w20: () => [aircraft.setSystems({turbulence: value > 0 ? 1 : 0, w20: value, seed: 1}), `turbulence ${value} 1`],
      scas: () => [aircraft.setSystems({scas: input.checked ? 1 : 0}), `scas ${input.checked ? 'on' : 'off'}`],
      gear: () => [aircraft.setSystems({gearDown: input.checked ? 1 : 0}), `gear ${input.checked ? 'down' : 'up'}`],
      governor: () => this.moveGovernor(value),
      interconnect: () => [aircraft.setSystems({interconnect: shaft}), `interconnect ${kShafts[shaft]}`],
    };
    const [status, words] = commands[input.name]();
    if (status !== 0) return this.say(`Not obeyed: ${aircraft.tiltrotor.statusText(status)}.`);
    for (const line of words.split('\n')) recorder.command(steps, line);
    if (aircraft.look() === 0) this.seen = aircraft.seen();
    if (steps > 0) this.say(kFlying, true);
    return true;
  }
  // The lever takes over what the governor has added, and the rotors turn on as they do; a governor that is switched on leads
  // them back to the speed of the trim.
  moveGovernor(value) {
    const {aircraft} = this, rotor = this.seen.conf[kConf.rotor];
    if (value === 0) this.collective += this.seen.x[kX.governor];
    this.rotor = value === 2 ? rotor : this.rotorOfTrim;
    const target = value === 2 ? this.rotorOfTrim : rotor;
    return [aircraft.setSystems({governor: value, rotor}), `governor ${kGovernors[value]}\nrotor ${target}rad/s`];
  }
  leadRotor() {
    if (this.rotor === this.rotorOfTrim) return 0;
    this.rotor += clamp(this.rotorOfTrim - this.rotor, -kRotorRate * kStep, kRotorRate * kStep);
    return this.aircraft.setSystems({rotor: this.rotor});
  }

  // ---- a frame ----

  // At every frame of the screen, with its time in ms.
  frame(now) {
    if (!this.isRunning) return;
    const passed = this.before === undefined ? 0 : Math.min((now - this.before) / 1000, 0.1);
    this.before = now;
    this.owed += passed;
    const steps = Math.min(Math.floor(this.owed / kStep), kMostSteps);
    this.owed = Math.min(this.owed - steps * kStep, kMostSteps * kStep);
    const start = performance.now();
    if (steps > 0) this.advance(steps);
    this.draw();
    byId('frame_time').textContent = `${fixed(performance.now() - start, 1)} ms for ${steps} steps`;
  }

  // So many steps with the hands as they are now; false where the flight ends.
  advance(steps) {
    if (this.steps === 0) this.say(kFlying, true);
    const {aircraft} = this, seconds = steps * kStep, sys = this.seen.sys;
    const hand = this.sticks.move(seconds), isGoverned = sys[kSys.governor] !== 0;
    if (sys[kSys.governor] === 2) this.collective += kOffload * seconds * this.seen.x[kX.governor];
    const collective = this.collective + hand.lever * (isGoverned ? kLeverCollective *
      Math.cos(this.seen.conf[kConf.mast] * kDegree) : kLeverAlone);
    const trim = this.throttleOfTrim;
    const throttle = clamp(trim + hand.lever * (hand.lever > 0 ? 1 - trim : trim), 0, 1);
    const u = [collective, hand.long, hand.lat, hand.pedal];
    let status = aircraft.setControls(u);
    const inForce = Array.from(aircraft.array.u.subarray(0, 4));
    if (status === 0 && throttle !== this.throttle) status = aircraft.setSystems({throttle});
    this.throttle = throttle;
    this.recorder.inputs(this.steps, inForce, throttle);
    for (let k = 0; k < steps && status === 0; ++k) {
      status = this.leadRotor() || aircraft.step(kStep);
      if (status === 0) ++this.steps;
    }
    if (status === 0) status = aircraft.look();
    if (status !== 0) return this.end(status);
    this.seen = aircraft.seen();
    if (this.height() < (this.seen.sys[kSys.gearDown] && this.seen.x[kX.gear] >= 1 ? -restHeight() : 0)) return this.strike();
    if (this.steps % Math.round(kModelEvery / kStep) < steps) this.model();
    return true;
  }
  end(status) {
    const {aircraft} = this, fault = aircraft.fault();
    this.isOver = true;
    this.run(false);
    return this.say(`The flight ended at ${fixed(this.steps * kStep, 2)} s: ${aircraft.tiltrotor.statusText(status)}` +
      `${fault === '' ? '' : ` (state ${fault})`}. Begin again.`);
  }
  height() { return -this.seen.x[kX.down] - restHeight(); }  // of the wheels
  strike() {
    this.isOver = true;
    this.run(false);
    const out = this.seen.x[kX.gear], gear = !this.seen.sys[kSys.gearDown] ? ' with the gear up' : out < 1 ? ' before the gear was down' : '';
    return this.say(`The flight ended at ${fixed(this.steps * kStep, 2)} s: the aircraft met the ground${gear}, sinking at ` +
      `${fixed(-this.seen.out[kOut.climb], 1)} m/s. Begin again.`);
  }
  model() {
    const start = performance.now();
    const linear = this.aircraft.linearize();
    if (linear === null) return;
    this.roots.show(linear.modes);
    this.matrices.show(linear);
    byId('linear_time').textContent = `${fixed(performance.now() - start, 1)} ms, ${linear.n} states`;
  }
  draw() {
    const {x, out, conf, sys} = this.seen, gear = x[kX.gear];
    byId('gear_place').textContent = gear >= 1 ? 'down and locked' : gear > 0 ? `on its way, ${Math.floor(100 * gear)} % out` : 'up';
    this.cockpit.show({roll: x[kX.roll], pitch: x[kX.pitch], yaw: x[kX.yaw], north: x[kX.north], east: x[kX.east],
      height: this.height(), airspeed: out[kOut.airspeed], climb: out[kOut.climb],
      loadFactor: out[kOut.loadFactor], power: out[kOut.power] + out[kOut.power + 1], rotor: conf[kConf.rotor],
      mast: conf[kConf.mast], mastCommand: sys[kSys.mast], lever: this.sticks.lever});
  }
}
