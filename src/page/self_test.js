// #self_test: the reference flight and a scripted hand on every control; the results stand in the page as text.

function selfTest(library) {
  const lines = [];
  const check = (name, holds, found) => lines.push(`${holds ? 'ok' : 'FAILED'} ${name}: ${found}`);
  const press = (target, key) => {
    for (const type of ['keydown', 'keyup']) target.dispatchEvent(new KeyboardEvent(type, {key, bubbles: true}));
  };
  const place = (name, value) => {
    const input = document.querySelector(name);
    if (input.type === 'checkbox') input.checked = value;
    else input.value = value;
    input.dispatchEvent(new Event('input', {bubbles: true}));
  };

  const licences = byId('licences').textContent;
  check('licences', ['Permission is hereby granted', 'IN NO EVENT', 'wasi-libc', 'musl', 'libc++'].every((words) => licences.includes(words)),
    `${licences.length} characters`);
  const explore = new Explore(library, readAddress('#mast=30&speed=60'));
  const shown = () => { explore.compute(); return explore.found; };
  check('trim', shown().isClean, explore.found.text);
  check('modes', explore.found.linear.modes.length > 8, explore.found.linear.modes.map((m) => m.name).join(', '));
  {
    const {linear} = explore.found, mode = linear.modes.find((m) => m.name === 'dutch roll') || linear.modes[0];
    const x = eigenvector(linear.a, linear.n, mode);
    const rest = x.map((_, i) => Math.hypot(...[0, 1].map((part) => x.reduce((sum, value, j) => sum + linear.a[i * linear.n + j] *
      value[part], 0) - (part === 0 ? mode.real * x[i][0] - mode.imag * x[i][1] : mode.real * x[i][1] + mode.imag * x[i][0]))));
    check('eigenvector', Math.max(...rest) < 1e-8, `${mode.name}, residual ${Math.max(...rest)}`);
    check('phasors', byId('phasor_mode').options.length === linear.modes.length && byId('phasors').querySelectorAll('text').length > 1,
      byId('phasors').getAttribute('aria-label'));
    check('front view', byId('front').querySelectorAll('.thrust').length === 2, byId('front').getAttribute('aria-label'));
  }
  {
    // All forces and the weight hold the balance in level flight, turned by the pitch; wings level.
    const {seen, forces} = explore.found, pitch = seen.x[kX.pitch], weight = seen.conf[kConf.mass] * 9.80665;
    const components = Object.keys(forces).filter((name) => !name.startsWith('in_plane'));
    const [x, y, z] = forceOf(forces, components);
    const rest = Math.hypot(x - weight * Math.sin(pitch), y, z + weight * Math.cos(pitch)) / weight;
    check('forces', components.length === 13 && rest < 1e-4, `${components.length} components, out of balance by ${rest} of the weight`);
    const letters = (id) => byId(id).querySelectorAll('.force_letter').length;
    check('force arrows', letters('side') >= 5 && letters('front') >= 7 && byId('forces').children.length >= 5,
      `${letters('side')} and ${letters('front')}, ${byId('forces').textContent}`);
    byId('show_forces').click();
    check('forces off', letters('side') + letters('front') + byId('forces').children.length === 0 &&
      byId('front').querySelectorAll('.thrust').length === 2 && location.hash.includes('forces=0'), location.hash);
    byId('show_forces').click();
    check('forces on', letters('side') >= 5 && !location.hash.includes('forces'), location.hash);
    // What an address asks for is what is seen.
    explore.change(readAddress('#mast=30&speed=60&forces=0&mode=phugoid'));
    shown();
    check('views of an address', !byId('show_forces').checked && letters('side') === 0 && explore.phasors.mode().name === 'phugoid' &&
      explore.near.chosen.name === 'phugoid' && byId('moved_mode').textContent === 'phugoid', location.hash);
    explore.change(readAddress('#mast=30&speed=60&mode=no_such'));
    shown();
    const [fault] = explore.modeFaults();
    check('a mode that is none', /^mode=no_such is none of this flight: there are .*short_period/.test(fault) &&
      explore.modeFaults().length === 0, fault);
    explore.change(readAddress('#mast=30&speed=60'));
    shown();
  }
  {
    // A root moved by a small change of an element, against the Rayleigh quotient of the changed matrix.
    const {linear} = explore.found, mode = linear.modes.find((m) => m.name === 'short period') || linear.modes[0];
    const motions = elementMotions(linear, mode), [row, column] = motions[0].label.match(/^d(.*)\/dt by (.*)$/).slice(1)
      .map((name) => linear.states.indexOf(name));
    const changed = linear.a.slice(), part = 1e-4;
    changed[row * linear.n + column] *= 1 + part;
    let root = {real: mode.real, imag: mode.imag};
    for (let turn = 0; turn < 4; ++turn) root = quotient(changed, linear.n, root);
    const off = Math.hypot((root.real - mode.real) / part * kElementPart - motions[0].real,
      (root.imag - mode.imag) / part * kElementPart - motions[0].imag) / Math.hypot(motions[0].real, motions[0].imag);
    check('sensitivity', off < 1e-3, `${mode.name}, ${motions[0].label}: to ${off}`);
    explore.settle(kUsualChanges.length);
    const size = explore.sensitivities.models.length;
    check('choices that move the root', size === kUsualChanges.length && byId('by_choices').children.length === size,
      byId('by_choices').textContent);
  }
  {
    const mark = [...byId('near').querySelectorAll('.stable')].find((m) => m.getAttribute('aria-label').startsWith('short period'));
    mark.dispatchEvent(new KeyboardEvent('keydown', {key: 'Enter', bubbles: true}));
    const tips = [...byId('near').querySelectorAll('.level_grip')].map((line) => line.dataset.tip);
    check('levels of a mode', explore.phasors.mode().name === 'short period' && tips.length === 3 && /at least 0.3 /.test(`${tips[0]} `) &&
      location.hash.endsWith('mode=short_period'), tips.join(' | '));
    const list = byId('phasor_mode');
    list.selectedIndex = [...list.options].findIndex(({text}) => text === 'phugoid');
    list.dispatchEvent(new Event('change', {bubbles: true}));
    check('mode of the list', explore.near.chosen.name === 'phugoid' && location.hash.endsWith('mode=phugoid'), location.hash);
    // The frequency of the edge and its damping are those that are asked for.
    const edge = levelEdge({zeta: 0.08, zetaOmega: 0.15, omega: 0.4}, 5);
    check('edge of a level', edge.every(([re, im]) => { const w = Math.hypot(re, im); return w > 0.4 - 1e-12 &&
      (Math.min(-re - 0.15, -re - 0.08 * w) < 1e-12 || w < 0.4 + 1e-12); }) && edge.some(([re]) => Math.abs(re + 0.4) < 1e-12), `${edge.length} points`);
  }
  press(explore.corridor.handle, 'ArrowRight');
  check('arrow key', explore.point.speed === 61, explore.point.speed);
  const box = byId('corridor').getBoundingClientRect();
  const drag = (type, x, y) => byId('corridor').dispatchEvent(new PointerEvent(type, {pointerId: 1, bubbles: true,
    clientX: box.left + x * box.width, clientY: box.top + y * box.height}));
  byId('corridor').setPointerCapture = () => {};
  drag('pointerdown', 0.5, 0.5);
  drag('pointermove', 0.7, 0.2);
  drag('pointerup', 0.7, 0.2);
  check('drag', explore.point.speed > 80 && explore.point.mast > 50, `mast ${explore.point.mast}, ${explore.point.speed} m/s`);
  explore.change({mast: 30, speed: 60});
  const unaugmented = shown().linear.n;
  place('#choices [name=governor]', 2);
  place('#choices [name=scas]', true);
  check('systems', shown().isClean && explore.found.linear.n > unaugmented, `${explore.found.linear.n} states`);
  {
    const states = explore.found.linear.n, shaft = document.querySelector('#choices [name=interconnect]'), isFree = !shaft.disabled;
    place('#choices [name=interconnect]', true);
    check('interconnect', isFree && shown().linear.n === states + 2 && explore.found.linear.states.includes('shaft_twist') &&
      location.hash.includes('interconnect=1'), `${explore.found.linear.n} states`);
    place('#choices [name=governor]', 1);
    check('interconnect without its governor', shaft.disabled && !shown().linear.states.includes('shaft_twist') &&
      understood(location.hash).faults.length === 1, understood(location.hash).faults.join(' '));
    place('#choices [name=governor]', 2);
  }
  place('#choices [name=mass]', 5000);
  check('mass', shown().seen.conf[kConf.mass] === 5000, explore.found.text);
  const again = readAddress(writeAddress(explore.point));
  check('address', JSON.stringify(again) === JSON.stringify(explore.point), writeAddress(explore.point));
  check('bad address', readAddress('#mast=x&speed=1e9&cg=').speed === 140, JSON.stringify(readAddress('#mast=x&cg=')));
  const faults = understood('#mast=x&speed=1e9&cg=&sped=3&governor=1.5&fly').faults;
  check('words for a bad address', faults.length === 5 && faults[1].includes('speed=1e9 is out of range: 0 to 140 m/s; shown with 140'),
    faults.join(' '));
  const odd = ['toString=3&constructor=2', 'flap=-0.5', 'mast=30&mast=40', 'fly=7'].map((words) => understood(`#${words}`));
  check('words for an odd address', odd.map(({faults: said}) => said.length).join() === '2,1,1,1' && odd[1].point.flap === -1 &&
    odd[2].point.mast === 30, odd.map(({faults: said}) => said.join(' ')).join(' '));
  check('no words for a good one', understood(writeAddress(explore.point)).faults.length === 0, writeAddress(explore.point));
  explore.change({mast: 90, speed: 10});
  check('no trim', shown().seen === undefined && explore.found.text.startsWith('No level flight'), explore.found.text);
  explore.corridor.start(loading(explore.point));
  explore.corridor.slice(20);
  check('map', Object.keys(explore.corridor.cell).length > 0, `${Object.keys(explore.corridor.cell).length} cells`);

  const fly = new Fly(library);
  byId('fly').hidden = false;
  check('begin', fly.begin(readAddress('#mast=0&speed=40&mode=phugoid')), byId('flight_sentence').textContent);
  const {name} = fly.roots.chosen, other = [...byId('fly_near').querySelectorAll('[role=button]')]
    .find((mark) => !mark.getAttribute('aria-label').startsWith(name));
  other.dispatchEvent(new MouseEvent('click', {bubbles: true}));
  check('address in flight', name === 'phugoid' && other.getAttribute('aria-label').startsWith(`${fly.roots.chosen.name}:`) &&
    location.hash === `#mast=0&speed=40&mode=${fly.roots.chosen.name.replace(/ /g, '_')}&fly`, location.hash);
  const before = byId('flight_sentence').textContent;
  let flies = true;
  for (let k = 0; k < 100 && flies; ++k) flies = fly.advance(2);
  check('stays in trim', flies && Math.abs(fly.seen.out[kOut.airspeed] - 40) < 0.5 && fly.steps === 200,
    `${fixed(fly.seen.out[kOut.airspeed], 3)} m/s, ${fly.steps} steps`);
  check('sentence of a flight', before.startsWith('In trim at 40 m/s') && byId('flight_sentence').textContent === kFlying,
    byId('flight_sentence').textContent);
  document.dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowRight', bubbles: true}));
  for (let k = 0; k < 50 && flies; ++k) flies = fly.advance(2);
  check('stick to the right', flies && fly.seen.x[kX.roll] > 0.05, `bank ${fixed(degrees(fly.seen.x[kX.roll]), 1)} deg`);
  document.dispatchEvent(new KeyboardEvent('keyup', {key: 'ArrowRight', bubbles: true}));
  {
    // Keys while a lever has the focus: it keeps its own, the others fly, and all are let go of.
    const {sticks} = fly, of = (name) => document.querySelector(`#levers [name=${name}]`), words = [];
    const send = (type, target, key) => target.dispatchEvent(new KeyboardEvent(type, {key, bubbles: true, cancelable: true}));
    const holds = (target, key) => {
      send('keydown', target, key);
      const held = sticks.down.size === 1;
      send('keyup', target, key);
      words.push(`${target.name} ${held ? 'flies' : 'keeps'} ${key}`);
      return held && sticks.down.size === 0;
    };
    send('keydown', document.body, 'd');
    of('gear').focus();
    send('keyup', of('gear'), 'd');
    check('a key let go of on a lever', sticks.down.size === 0, `${sticks.down.size} held`);
    check('keys beside a lever', ['gear', 'scas'].every((name) => holds(of(name), 'ArrowRight') && holds(of(name), 'd')) &&
      ['mast', 'governor'].every((name) => holds(of(name), 'a') && !holds(of(name), 'ArrowRight')), words.join(', '));
    const runs = (target) => { const was = fly.isRunning; send('keydown', target, ' '); const now = fly.isRunning; fly.run(was); return was !== now; };
    check('space bar', !runs(of('gear')) && !runs(of('w20')) && !runs(byId('again')) && runs(of('mast')) && runs(byId('cockpit')) &&
      !runs(byId('fly_near').querySelector('[role=button]')), 'stops and goes on, but on what is pressed by it');
    const focused = (type) => {
      of('w20').focus();
      of('w20').dispatchEvent(new (type === 'keydown' ? KeyboardEvent : PointerEvent)(type, {key: 'ArrowUp', bubbles: true}));
      of('w20').dispatchEvent(new Event('change', {bubbles: true}));
      return document.activeElement.id || document.activeElement.name;
    };
    const after = [focused('pointerdown'), focused('keydown')];
    check('keys after a lever', after[0] === 'cockpit' && after[1] === 'w20', after.join(', '));
    of('w20').blur();
  }
  {
    // Half of the way is a quarter of the stick; next to the middle nothing moves.
    const pad = {connected: true, axes: [0, 0, 0, 0]}, usual = navigator.getGamepads, {sticks} = fly;
    const held = (k, value) => { pad.axes[k] = value; for (let n = 0; n < 20; ++n) sticks.move(0.1); pad.axes[k] = 0; return {...sticks.hand, lever: sticks.lever}; };
    Object.defineProperty(navigator, 'getGamepads', {configurable: true, value: () => [null, pad]});
    const lat = held(0, -0.5).lat, long = held(1, -1).long, pedal = held(2, 0.05).pedal, {lever} = held(3, -1);
    check('gamepad', Math.abs(lat + kPadStick / 4) < 1e-12 && long === kPadStick && pedal === 0 && lever > 0.5,
      `lateral ${lat} in, longitudinal ${long} in, pedal ${pedal} in, lever ${lever}`);
    Object.defineProperty(navigator, 'getGamepads', {configurable: true, value: usual});
    held(3, 0);
    sticks.lever = 0;
  }
  place('#levers [name=gear]', true);
  press(document.body, 'e');
  const isRigid = !fly.matrices.linear.states.includes('shaft_twist');
  place('#levers [name=interconnect]', true);
  place('#levers [name=w20]', '15.4');
  place('#levers [name=wind]', 5);
  place('#levers [name=flap]', 20);
  place('#levers [name=scas]', false);
  for (let k = 0; k < 100 && flies; ++k) flies = fly.advance(2);
  check('masts', flies && fly.seen.conf[kConf.mast] > 4, `${fixed(fly.seen.conf[kConf.mast], 2)} deg`);
  check('interconnect in flight', isRigid && fly.matrices.linear.states.includes('shaft_twist') && fly.seen.x[kX.shaft_twist] !== 0,
    `twisted by ${degrees(fly.seen.x[kX.shaft_twist])} deg`);
  fly.draw();
  check('gear on its way', fly.seen.x[kX.gear] > 0.1 && fly.seen.x[kX.gear] < 0.9 && /\d % out/.test(byId('gear_place').textContent),
    byId('gear_place').textContent);
  lines.push(`state ${Array.from(fly.seen.x.slice(0, 31)).join(' ')}`);
  lines.push('script', fly.recorder.script(fly.steps), 'series', fly.recorder.series(), 'end of series');
  fly.sticks.rest.long = 4.8;
  for (let k = 0; k < 3000 && fly.advance(2); ++k);
  check('a flight that fails says so', fly.isOver && /^The flight ended at/.test(byId('flight_sentence').textContent),
    byId('flight_sentence').textContent);
  lines.push('reference flight', library.referenceFlight(600), 'done');
  return lines.join('\n');
}
