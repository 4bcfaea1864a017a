// Numbers as text, and between units.

const kDegree = Math.PI / 180;
const kKnot = 0.514444;
const kHorsepower = 745.6999;

const clamp = (value, low, high) => Math.min(high, Math.max(low, value));
const degrees = (radians) => radians / kDegree;

// Without a minus before zero.
function fixed(value, digits) {
  if (!Number.isFinite(value)) return '–';
  const text = value.toFixed(digits);
  return (Number(text) === 0 ? text.replace('-', '') : text).replace('-', '−');
}
const significant = (value) => (Number.isFinite(value) ? String(Number(value.toPrecision(4))).replace('-', '−') : '–');

function modeText(mode) {
  const root = mode.imag > 0 ? `${fixed(mode.real, 3)} ± ${fixed(mode.imag, 3)}i 1/s` : `${fixed(mode.real, 3)} 1/s`;
  const life = mode.half >= 0 ? `halves in ${significant(mode.half)} s` : `doubles in ${significant(-mode.half)} s`;
  const damping = mode.imag > 0 ? `, damping ratio ${fixed(mode.damping, 2)}` : '';
  const level = levelOf(mode);
  return `${mode.name}: ${root}${damping}, ${life}${level === '' ? '' : `; ${level}`}`;
}
