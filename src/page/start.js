// The page begins: the module, then both rooms, then a frame of the screen after the other.

function openRoom(isFlying) {
  document.body.classList.toggle('flying', isFlying);
  byId('explore').hidden = isFlying;
  byId('fly').hidden = !isFlying;
  byId('tab_explore').setAttribute('aria-selected', String(!isFlying));
  byId('tab_fly').setAttribute('aria-selected', String(isFlying));
}

const kStillMap = 2500;  // ms
// As the page was opened: Explore writes another address.
const kAsked = new URLSearchParams(location.hash.slice(1));
const isStill = kAsked.has('still'), isSelfTest = kAsked.has('self_test');

function begin(instance) {
  const library = new Library(instance);
  byId('about').textContent += ` Version ${library.version()}.`;
  followPointer();
  if (isSelfTest) {
    byId('self_test').hidden = false;
    byId('self_test').textContent = selfTest(library);
    return;
  }
  const asked = understood(location.hash);
  const explore = new Explore(library, asked.point);
  sayFaults([...asked.faults, ...explore.modeFaults()]);
  let fly = null;
  const takeOff = (point) => {
    openRoom(true);
    if (fly === null) fly = new Fly(library);
    fly.begin(point);
    fly.write();
    byId('cockpit').focus({preventScroll: true});
  };
  const land = () => {
    if (fly !== null) fly.run(false);
    openRoom(false);
    explore.compute();
  };
  byId('tab_explore').addEventListener('click', land);
  byId('tab_fly').addEventListener('click', () => {
    if (fly === null) return takeOff(explore.point);
    openRoom(true);
    return fly.write();
  });
  byId('fly_here').addEventListener('click', () => takeOff(explore.point));
  window.addEventListener('hashchange', () => {
    const {point, faults} = understood(location.hash), isFlight = new URLSearchParams(location.hash.slice(1)).has('fly');
    explore.change(point);
    explore.compute();
    sayFaults([...faults, ...explore.modeFaults()]);
    if (isFlight) takeOff(explore.point);
    else land();
  });
  if (kAsked.has('fly')) takeOff(explore.point);
  if (isStill) {
    explore.settle(kUsualChanges.length);
    explore.corridor.slice(kStillMap);
    if (fly !== null) fly.advance(100);
    if (fly !== null) fly.draw();
    window.parent.postMessage(stillFaults(fly === null ? 'explore' : 'fly'), '*');
    return;
  }
  const frame = (now) => {
    if (byId('fly').hidden) explore.idle();
    else fly.frame(now);
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
}

// A script that fails, or the module, would leave a picture that stands still.
for (const kind of ['error', 'unhandledrejection'])
  window.addEventListener(kind, (event) => fail(`${event.message || (event.reason && event.reason.message) || kind}. Load it again.`));

function fail(reason) {
  byId('failure').hidden = false;
  byId('failure').textContent = `This page does not work here: ${reason}`;
}

// At once in a test and in a still picture (#mast=30&still), which do not wait.
if (typeof WebAssembly !== 'object') fail('the browser has no WebAssembly.');
else if (isStill || isSelfTest) begin(new WebAssembly.Instance(new WebAssembly.Module(moduleBytes()), {}));
else WebAssembly.instantiate(moduleBytes(), {}).then((made) => begin(made.instance)).catch((error) => fail(error.message));
