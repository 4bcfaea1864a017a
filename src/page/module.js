// The library as WebAssembly, and one object for each of its two aircraft. Places in the arrays are those of page.h.

const kArrays = ['setup', 'systems', 'environment', 'x', 'u', 'outputs', 'configuration', 'a', 'b', 'modes',
  'statePlaces', 'controlPlaces', 'forces'];
const kX = {u: 0, v: 1, w: 2, p: 3, q: 4, r: 5, roll: 6, pitch: 7, yaw: 8, north: 28, east: 29, down: 30,
  shaft_twist: 35, governor: 39, gear: 58};
const kU = {collective: 0, longStick: 1, latStick: 2, pedal: 3};
const kOut = {airspeed: 1, alpha: 2, beta: 3, force: 4, loadFactor: 7, climb: 8, thrust: 9, torque: 11,
  power: 13, collective: 15, longCyclic: 17, tilt: 19, elevator: 21, aileron: 22, rudder: 23};
const kConf = {mast: 0, flap: 3, rotor: 4, mass: 6, cg: 7};
const kSys = {governor: 0, conversion: 1, engines: 2, actuators: 3, scas: 4, gear: 5, groundEffect: 6,
  turbulence: 7, mast: 8, flap: 9, rotor: 10, throttle: 11, gearDown: 13, seed: 14, w20: 15, interconnect: 16};
const kInceptors = 1;      // tr_columns
const kTrimmed = new Set([0, 9, 10, 11, 15, 16, 17]);  // tr_status of a trim that fulfils the equations

// Text of the page to the bytes of the module.
function moduleBytes() {
  const packed = atob(document.getElementById('module').textContent.trim());
  return Uint8Array.from(packed, (letter) => letter.charCodeAt(0));
}

class Library {
  constructor(instance) {
    this.call = instance.exports;
    this.memory = this.call.memory.buffer;  // of fixed size: never another
    this.array = {};
    kArrays.forEach((name, k) => {
      this.array[name] = new Float64Array(this.memory, this.call.page_array(k));
    });
  }
  text(place) {
    const bytes = new Uint8Array(this.memory, place);
    return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
  }
  lastText() { return this.text(this.call.page_text()); }
  statusText(status) { return this.text(this.call.page_status_text(status)); }
  version() { return this.text(this.call.page_version()); }
  // {hash_states: '...', ...} of the reference flight.
  referenceFlight(frames) {
    this.call.page_reference_flight(frames);
    return this.lastText();
  }
}

class Aircraft {
  constructor(library, number) {
    this.tiltrotor = library;
    this.call = library.call;
    this.array = library.array;
    this.number = number;
  }
  // {mast, flap, altitude, mass, cg}; what is missing is the default of the aircraft.
  begin(point) {
    const given = (value) => (value === undefined || value === null ? -1 : value);
    this.array.setup.set([given(point.mast), given(point.flap), point.altitude || 0, given(point.mass),
      given(point.cg), -1]);
    return this.call.page_begin(this.number);
  }
  // Changes some of the systems: {scas: 1, mast: 30}.
  setSystems(changes) {
    const status = this.look();
    if (status !== 0) return status;
    for (const [name, value] of Object.entries(changes)) this.array.systems[kSys[name]] = value;
    if (changes.throttle !== undefined) this.array.systems[kSys.throttle + 1] = changes.throttle;
    return this.call.page_set_systems(this.number);
  }
  setEnvironment(wind, altitudeOrigin) {
    this.array.environment.set([...wind, altitudeOrigin]);
    return this.call.page_set_environment(this.number);
  }
  setHeight(height) { return this.call.page_set_height(this.number, height); }
  setControls(u) {
    this.array.u.set(u);
    return this.call.page_set_controls(this.number);
  }
  trim(speed) { return this.call.page_trim(this.number, speed); }
  step(dt) { return this.call.page_step(this.number, dt); }
  look() { return this.call.page_look(this.number); }
  flags() { return this.call.page_flags(this.number); }
  // {wing_free: [x, y, z], ...} of the state as it is: body axes, N; null where they are not finite.
  componentForces() {
    if (this.call.page_component_forces(this.number) !== 0) return null;
    const found = {};
    for (let k = 0; ; ++k) {
      const name = this.tiltrotor.text(this.call.page_component_name(k));
      if (name === '') return found;
      found[name] = Array.from(this.array.forces.subarray(3 * k, 3 * k + 3));
    }
  }
  fault() { return this.tiltrotor.text(this.call.page_fault(this.number)); }
  // A copy of what look() found.
  seen() {
    const copy = (name, length) => Array.from(this.array[name].subarray(0, length));
    return {x: copy('x', 75), u: copy('u', 14), out: copy('outputs', 24), conf: copy('configuration', 9),
      sys: copy('systems', 17)};
  }
  // A, B, their names and the modes; null where there is no linear model.
  linearize() {
    const status = this.call.page_linearize(this.number, kInceptors);
    const modes = this.call.page_modes();
    if (status !== 0 && modes === 0) return null;
    const n = this.call.page_states(), m = this.call.page_controls();
    const names = (places, count, name) => Array.from(places.subarray(0, count),
      (place) => this.tiltrotor.text(name(place)));
    const number = this.array.modes;
    return {
      n, m,
      a: Array.from(this.array.a.subarray(0, n * n)),
      b: Array.from(this.array.b.subarray(0, n * m)),
      states: names(this.array.statePlaces, n, this.call.page_state_name),
      controls: names(this.array.controlPlaces, m, this.call.page_control_name),
      modes: Array.from({length: modes}, (_, k) => ({
        name: this.tiltrotor.text(this.call.page_mode_name(k)).replace(/_/g, ' '),
        real: number[5 * k], imag: number[5 * k + 1], frequency: number[5 * k + 2],
        damping: number[5 * k + 3], half: number[5 * k + 4],
      })),
    };
  }
}
