// What was done in a flight, as a script and a series of inputs with which `tiltrotor fly` flies the same again. Numbers have
// all their digits.

const kSeriesColumns = ['time_s', 'th75_rad', 'lon_in', 'lat_in', 'ped_in', 'throttle_1', 'throttle_2'];
const kGovernors = ['off', 'ideal', 'pi'], kShafts = ['rigid', 'twists'];

class Recorder {
  // start: {mast, speed, height, flap, altitude, mass, cg, governor, interconnect}; SCAS on, gear up, as the command line begins
  constructor(start, dt) {
    this.start = start;
    this.dt = dt;
    this.rows = [];
    this.events = [];
    this.last = '';
  }
  // Inputs in force from a step on; written where they differ from those before.
  inputs(step, u, throttle) {
    const text = [...u.slice(0, 4), throttle, throttle].map(String).join(',');
    if (text === this.last) return;
    if (step === this.lastStep) this.rows.pop();  // never in force
    this.lastStep = step;
    this.last = text;
    // Half a step early: a time that is rounded still comes before its step.
    const time = step === 0 ? 0 : (step - 0.5) * this.dt;
    this.rows.push(`${time.toFixed(4)},${text}`);
  }
  command(step, words) {
    this.events.push(`${(step * this.dt).toFixed(4)} ${words}`);
  }
  series() { return [kSeriesColumns.join(','), ...this.rows, ''].join('\n'); }
  script(steps) {
    const s = this.start;
    const flap = s.flap === null ? '' : ` --flap ${s.flap}`;
    const cg = s.cg / 0.0254;
    return [
      `# tiltrotor fly --mast ${s.mast} --speed ${s.speed} --height ${s.height} --altitude ${s.altitude}${flap}` +
        ` --mass ${s.mass} --cg-sl ${cg} --dt ${this.dt} --script flight.txt`,
      '0 release all',
      `0 governor ${kGovernors[s.governor]}`,
      `0 interconnect ${kShafts[s.interconnect]}`,
      '0 series flight.csv held',
      ...this.events,
      `${Math.max(steps * this.dt, this.dt).toFixed(4)} end`,
      ''].join('\n');
  }
}

function download(name, text) {
  const link = html('a', {href: URL.createObjectURL(new Blob([text], {type: 'text/plain'})), download: name});
  document.body.append(link);
  link.click();
  link.remove();
}
