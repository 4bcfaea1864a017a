// The address of the page holds what is chosen and how it is looked at: #mast=30&speed=60&mode=phugoid&fly.

// What is chosen, with the range of its slider; `usual` says what stands when nothing was chosen.
const kChoices = {
  mast: {low: 0, high: 90, usual: 0, unit: 'deg'},
  speed: {low: 0, high: 140, usual: 40, unit: 'm/s'},
  altitude: {low: 0, high: 6000, usual: 0, unit: 'm', digits: 0},
  mass: {low: 4300, high: 7200, usual: 5897, unit: 'kg', digits: 0},
  cg: {low: 7.5, high: 7.8, usual: 7.65, unit: 'm', digits: 3},
  flap: {low: -1, high: 75, usual: -1, unit: 'deg', digits: 0},
  governor: {low: 0, high: 2, usual: 0, unit: '', isWhole: true},
  scas: {low: 0, high: 1, usual: 0, unit: '', isWhole: true},
  interconnect: {low: 0, high: 1, usual: 0, unit: '', isWhole: true},
  forces: {low: 0, high: 1, usual: 1, unit: '', isWhole: true},
};
// Numbers within a range that are none: flaps are set, or follow the masts.
const isBetween = (name, number) => name === 'flap' && number > kChoices.flap.usual && number < 0;
// What an address may hold beside them, without a value.
const kWords = ['fly', 'still', 'self_test'];

// The point of an address, with the name of the mode that is looked at ('': the usual one), and in `faults` a sentence for everything there that is none of its own.
function understood(address) {
  const point = {}, faults = [];
  const given = new URLSearchParams(address.replace(/^#/, ''));
  const range = ({low, high, unit}, name) => (name === 'flap' ? '0 to 75 deg, or -1: by the mast angle' : `${low} to ${high} ${unit}`.trim());
  for (const [name, choice] of Object.entries(kChoices)) {
    point[name] = choice.usual;
    if (!given.has(name)) continue;
    const text = given.get(name), number = text.trim() === '' ? NaN : Number(text);
    const isNumber = Number.isFinite(number);
    if (isNumber && !isBetween(name, number)) point[name] = clamp(choice.isWhole ? Math.round(number) : number, choice.low, choice.high);
    if (point[name] === number) continue;
    faults.push(`${name}=${text} is ${!isNumber ? 'no number' : choice.isWhole && !Number.isInteger(number) ? 'no whole number'
      : 'out of range'}: ${range(choice, name)}; shown with ${point[name]}.`);
  }
  if (point.interconnect === 1 && point.governor !== 2)
    faults.push(`interconnect=1 goes with governor=2 alone, the PI governor; the shaft is rigid with governor=${point.governor}.`);
  point.mode = (given.get('mode') || '').replace(/_/g, ' ');
  for (const name of new Set(given.keys())) {
    const count = given.getAll(name).length, isWord = kWords.includes(name);
    if (!Object.hasOwn(kChoices, name) && name !== 'mode' && !isWord)
      faults.push(`${name} is not known: there are ${Object.keys(kChoices).join(', ')}, mode.`);
    else if (isWord && given.get(name) !== '') faults.push(`${name}=${given.get(name)}: ${name} stands without a value.`);
    else if (count > 1 && !isWord) faults.push(`${name} stands there ${count} times; the first counts: ${name}=${given.get(name)}.`);
  }
  return {point, faults};
}
const readAddress = (address) => understood(address).point;

function writeAddress(point, isFlying = false) {
  const changed = Object.keys(kChoices).filter((name) => point[name] !== kChoices[name].usual || name === 'mast' || name === 'speed');
  const words = changed.map((name) => `${name}=${point[name]}`);
  if (point.mode) words.push(`mode=${point.mode.replace(/ /g, '_')}`);
  if (isFlying) words.push('fly');
  return `#${words.join('&')}`;
}

function sayFaults(faults) {
  byId('address_faults').hidden = faults.length === 0;
  byId('address_faults').textContent = faults.length === 0 ? '' : `In the address of this page: ${faults.join(' ')}`;
}
