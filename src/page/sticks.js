// The pilot's hands: keys, a gamepad or pads under fingers move stick, pedals and power lever.

const kKeyStick = 1.2, kKeyPedal = 0.8;    // in, of a key held down
const kPadStick = 2.5, kPadPedal = 1.5;    // in, of a pad or gamepad at its end
const kHandRate = 5;                       // in/s
const kLeverRate = 0.35;                   // of the half travel of the lever, 1/s
const kDeadBand = 0.08;
const kKeys = {ArrowUp: ['long', 1], ArrowDown: ['long', -1], ArrowRight: ['lat', 1], ArrowLeft: ['lat', -1],
  d: ['pedal', 1], a: ['pedal', -1], w: ['lever', 1], s: ['lever', -1]};

class Sticks {
  constructor() {
    this.down = new Set();
    this.pad = {long: 0, lat: 0, pedal: 0, lever: 0};
    this.follow(byId('left_pad'), 'pedal', 'lever');
    this.follow(byId('right_pad'), 'lat', 'long');
    window.addEventListener('blur', () => this.down.clear());
    this.reset({long: 0, lat: 0, pedal: 0});
  }
  // Where the sticks stand with no hand on them.
  reset(rest) {
    this.rest = {...rest};
    this.hand = {long: 0, lat: 0, pedal: 0};
    this.lever = 0;  // -1 .. 1 about the power of the trim
  }
  hold() {
    for (const name of Object.keys(this.rest)) this.rest[name] += this.hand[name];
    this.hand = {long: 0, lat: 0, pedal: 0};
  }
  key(event, isDown) {
    const name = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if (kKeys[name] === undefined) return false;
    if (isDown) this.down.add(name);
    else this.down.delete(name);
    return true;
  }
  follow(pad, horizontal, vertical) {
    const knob = pad.querySelector('i');
    const place = (x, y) => {
      this.pad[horizontal] = x;
      this.pad[vertical] = y;
      knob.style.transform = `translate(${x * 50}px, ${-y * 50}px)`;
    };
    pad.addEventListener('pointerdown', (event) => { pad.setPointerCapture(event.pointerId); this.grasped = pad; move(event); });
    const move = (event) => {
      if (!pad.hasPointerCapture(event.pointerId)) return;
      const box = pad.getBoundingClientRect();
      place(clamp((event.clientX - box.left) / box.width * 2.6 - 1.3, -1, 1),
        clamp(1.3 - (event.clientY - box.top) / box.height * 2.6, -1, 1));
    };
    pad.addEventListener('pointermove', move);
    for (const end of ['pointerup', 'pointercancel']) pad.addEventListener(end, () => place(0, 0));
  }
  gamepad() {
    const pads = navigator.getGamepads ? Array.from(navigator.getGamepads()) : [];
    const found = pads.find((pad) => pad !== null && pad !== undefined && pad.connected);
    const axis = (k) => {
      const value = found && found.axes.length > k ? found.axes[k] : 0;
      return Math.abs(value) < kDeadBand ? 0 : value;
    };
    return {lat: axis(0), long: -axis(1), pedal: axis(2), lever: -axis(3)};
  }
  // Moved on by so many seconds: {long, lat, pedal} in, lever.
  move(seconds) {
    const asked = {long: 0, lat: 0, pedal: 0, lever: 0}, gamepad = this.gamepad();
    for (const name of this.down) asked[kKeys[name][0]] += kKeys[name][1];
    const eased = (value) => value * Math.abs(value);  // fine about the middle
    for (const name of ['long', 'lat', 'pedal']) {
      const size = name === 'pedal' ? [kKeyPedal, kPadPedal] : [kKeyStick, kPadStick];
      const to = size[0] * asked[name] + size[1] * eased(clamp(this.pad[name] + gamepad[name], -1, 1));
      this.hand[name] += clamp(to - this.hand[name], -kHandRate * seconds, kHandRate * seconds);
    }
    const rate = asked.lever + eased(clamp(this.pad.lever + gamepad.lever, -1, 1));
    this.lever = clamp(this.lever + kLeverRate * seconds * rate, -1, 1);
    return {long: this.rest.long + this.hand.long, lat: this.rest.lat + this.hand.lat,
      pedal: this.rest.pedal + this.hand.pedal, lever: this.lever};
  }
}
