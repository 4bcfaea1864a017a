// Boundaries of handling qualities in the plane of the roots: of each mode its own. Numbers of tables/xv15/published/
// handling_qualities.csv, category B where they differ, by their names there (kLimits).

const kLevelText = 'flight phase category B';
// At least so much damping ratio, its product with the frequency (rad/s) and frequency.
const kModeLevels = {
  'dutch roll': [1, 2, 3].map((level) => ({level, zeta: kLimits[['dutch_zeta_L1_catB', 'dutch_zeta_L2', 'dutch_zeta_L3'][level - 1]],
    zetaOmega: level < 3 ? kLimits[['dutch_zeta_omega_L1_catB', 'dutch_zeta_omega_L2'][level - 1]] : 0,
    omega: kLimits[level === 1 ? 'dutch_omega_L1_catB' : 'dutch_omega_L2_L3']})),
  'short period': [1, 2, 3].map((level) => ({level, zeta: kLimits[`sp_zeta_min_L${level}_catB`]})),
  phugoid: [{level: 1, zeta: kLimits.phugoid_zeta_L1}],
  'roll spiral': [1, 2, 3].map((level) => ({level, zetaOmega: kLimits[`roll_spiral_zeta_omega_L${level}`]})),
  roll: ['roll_TR_L1_catB', 'roll_TR_L2_class23', 'roll_TR_L3'].map((name, k) => ({level: k + 1, real: -1 / kLimits[name]})),
  spiral: ['spiral_T2_L1_catB', 'spiral_T2_L2', 'spiral_T2_L3'].map((name, k) => ({level: k + 1, real: Math.LN2 / kLimits[name]})),
};

// [real, imaginary] along the edge of what a level asks for, up to a frequency; it is met to the left.
function levelEdge({zeta = 0, zetaOmega = 0, omega = 0, real}, most) {
  if (real !== undefined) return [[real, 0], [real, most]];
  const points = [];
  const edge = (w) => -Math.min(w, Math.max(zetaOmega, zeta * w));
  for (let k = 0; omega > 0 && k <= 24; ++k) {
    const sigma = -omega + (edge(omega) + omega) * k / 24;
    points.push([sigma, Math.sqrt(Math.max(0, omega * omega - sigma * sigma))]);
  }
  for (let k = 0; k <= 60; ++k) {
    const w = Math.max(omega, zetaOmega) + (most - Math.max(omega, zetaOmega)) * (k / 60) ** 2;
    points.push([edge(w), Math.sqrt(Math.max(0, w * w - edge(w) ** 2))]);
  }
  return points;
}

// Whether a root is on the good side.
function meets({zeta = 0, zetaOmega = 0, omega = 0, real}, mode) {
  if (real !== undefined) return mode.real <= real;
  const size = Math.hypot(mode.real, mode.imag);
  return -mode.real >= zeta * size && -mode.real >= zetaOmega && size >= omega;
}

// "level 1", or what is said where none is met or none is asked for.
function levelOf(mode) {
  const levels = kModeLevels[mode.name];
  if (levels === undefined) return '';
  const met = levels.find((level) => meets(level, mode));
  return met ? `level ${met.level}` : `below level ${levels[levels.length - 1].level}`;
}

function levelWords({zeta, zetaOmega, omega, real}) {
  const at = (name, value, unit) => (value === undefined || value === 0 ? [] : [`${name} at least ${significant(value)}${unit}`]);
  if (real !== undefined) return real < 0 ? `time constant at most ${significant(-1 / real)} s` : `doubles in no less than ${significant(Math.LN2 / real)} s`;
  return [...at('damping ratio', zeta, ''), ...at('damping', zetaOmega, ' 1/s'), ...at('frequency', omega, ' rad/s')].join(', ') || 'no damping below 0';
}
