// What the pilot sees: the ground as a grid in perspective, and the instruments over it.

const kLens = 520;        // pixels a unit of slope
const kGridFar = 3000;    // m
const kNarrow = 560;      // pixels of the page; there the picture has fewer of its own, so that its words can be read
const kSky = '#a9cdea', kGround = '#7c8f63', kGridLine = '#5d7048', kInk = '#10202c', kPaper = '#ffffffd9';

class Cockpit {
  constructor(canvas) {
    this.canvas = canvas;
    if (canvas.clientWidth < kNarrow) Object.assign(canvas, {width: 480, height: 400});
    this.pen = canvas.getContext('2d');
    this.isStill = window.matchMedia('(prefers-reduced-motion: reduce)').matches;
  }

  // Body axes of a vector north, east, down.
  body({roll, pitch, yaw}, [n, e, d]) {
    const cy = Math.cos(yaw), sy = Math.sin(yaw), cp = Math.cos(pitch), sp = Math.sin(pitch);
    const cr = Math.cos(roll), sr = Math.sin(roll);
    const ahead = cy * n + sy * e, side = cy * e - sy * n;
    const x = cp * ahead - sp * d, z = sp * ahead + cp * d;
    return [x, cr * side + sr * z, cr * z - sr * side];
  }
  place([x, y, z]) {
    return [this.canvas.width / 2 + kLens * y / x, this.canvas.height / 2 + kLens * z / x];
  }
  // Part of a line in front of the eye.
  line(p, q) {
    const near = 1;
    if (p[0] < near && q[0] < near) return;
    const cut = (a, b) => {
      const t = (near - a[0]) / (b[0] - a[0]);
      return [near, a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])];
    };
    const from = p[0] < near ? cut(p, q) : p, to = q[0] < near ? cut(q, p) : q;
    this.pen.moveTo(...this.place(from));
    this.pen.lineTo(...this.place(to));
  }

  show(view) {
    const {pen, canvas} = this, {width, height} = canvas;
    pen.fillStyle = kSky;
    pen.fillRect(0, 0, width, height);
    pen.save();
    pen.translate(width / 2, height / 2);
    pen.rotate(-view.roll);
    pen.translate(0, kLens * Math.tan(clamp(view.pitch, -1.4, 1.4)));
    pen.fillStyle = kGround;
    pen.fillRect(-3 * width, 0, 6 * width, 8 * width);
    pen.strokeStyle = '#fff';
    pen.lineWidth = 2;
    pen.beginPath();
    pen.moveTo(-3 * width, 0);
    pen.lineTo(3 * width, 0);
    pen.stroke();
    pen.restore();
    if (!this.isStill) this.grid(view);
    this.ladder(view);
    this.symbol();
    this.instruments(view);
  }
  // Below the heading and beside the instruments.
  ladder(view) {
    const {pen, canvas: {width, height}} = this;
    pen.save();
    pen.beginPath();
    pen.rect(width / 2 - 90, 74, 180, height - 84);
    pen.clip();
    pen.translate(width / 2, height / 2);
    pen.rotate(-view.roll);
    pen.translate(0, kLens * Math.tan(clamp(view.pitch, -1.4, 1.4)));
    pen.strokeStyle = pen.fillStyle = '#ffffffcc';
    pen.lineWidth = 1.5;
    pen.font = '13px sans-serif';
    pen.textAlign = 'left';
    for (let angle = -30; angle <= 30; angle += 10) {
      if (angle === 0) continue;
      const y = -kLens * Math.tan(angle * kDegree);
      pen.strokeRect(-45, y, 90, 0);
      pen.fillText(String(Math.abs(angle)), 50, y + 4);
    }
    pen.restore();
  }
  grid(view) {
    const {pen} = this;
    const size = view.height < 60 ? 25 : view.height < 500 ? 100 : 400, far = Math.min(kGridFar, 30 * size);
    const down = Math.max(view.height, 0.5);
    const n0 = Math.round(view.north / size) * size - view.north, e0 = Math.round(view.east / size) * size - view.east;
    pen.strokeStyle = kGridLine;
    pen.lineWidth = 1;
    pen.beginPath();
    for (let k = -far; k <= far; k += size) {
      this.line(this.body(view, [n0 + k, e0 - far, down]), this.body(view, [n0 + k, e0 + far, down]));
      this.line(this.body(view, [n0 - far, e0 + k, down]), this.body(view, [n0 + far, e0 + k, down]));
    }
    pen.stroke();
  }
  symbol() {
    const {pen, canvas} = this, x = canvas.width / 2, y = canvas.height / 2;
    pen.strokeStyle = '#ffd34d';
    pen.lineWidth = 4;
    pen.beginPath();
    pen.moveTo(x - 60, y);
    pen.lineTo(x - 20, y);
    pen.lineTo(x - 20, y + 10);
    pen.moveTo(x + 60, y);
    pen.lineTo(x + 20, y);
    pen.lineTo(x + 20, y + 10);
    pen.stroke();
    pen.fillStyle = '#ffd34d';
    pen.fillRect(x - 3, y - 3, 6, 6);
  }

  box(x, y, name, number, unit) {
    const {pen} = this;
    pen.fillStyle = kPaper;
    pen.fillRect(x, y, 128, 54);
    pen.fillStyle = kInk;
    pen.textAlign = 'left';
    pen.font = '14px sans-serif';
    pen.fillText(name, x + 8, y + 17);
    pen.font = 'bold 22px sans-serif';
    pen.fillText(number, x + 8, y + 43);
    pen.font = '14px sans-serif';
    pen.textAlign = 'right';
    pen.fillText(unit, x + 120, y + 43);
  }
  instruments(view) {
    const {pen, canvas} = this, {width, height} = canvas;
    this.box(10, 10, 'Airspeed', fixed(view.airspeed / kKnot, 0), 'kt');
    this.box(10, 74, 'Load factor', fixed(view.loadFactor, 2), 'g');
    this.box(10, 138, 'Rotors', fixed(view.rotor * 30 / Math.PI, 0), 'rpm');
    this.box(width - 138, 10, 'Height', fixed(view.height, 0), 'm');
    this.box(width - 138, 74, 'Climb', fixed(view.climb, 1), 'm/s');
    this.box(width - 138, 138, 'Power', fixed(view.power / 1000, 0), 'kW');
    this.box(width / 2 - 64, 10, 'Heading', fixed(((degrees(view.yaw) % 360) + 360) % 360, 0), 'deg');
    this.mastDial(74, height - 16, view);
    this.leverBar(width - 60, height - 110, view.lever);
  }
  // A nacelle that turns with the masts.
  mastDial(x, y, view) {
    const {pen} = this;
    pen.fillStyle = kPaper;
    pen.fillRect(x - 64, y - 110, 140, 120);
    pen.strokeStyle = kInk;
    pen.lineWidth = 2;
    pen.beginPath();
    pen.arc(x - 30, y - 14, 66, -Math.PI / 2, 0);
    pen.stroke();
    const needle = (angle, length, lineWidth) => {
      pen.lineWidth = lineWidth;
      pen.beginPath();
      pen.moveTo(x - 30, y - 14);
      pen.lineTo(x - 30 + length * Math.sin(angle), y - 14 - length * Math.cos(angle));
      pen.stroke();
    };
    needle(view.mast * kDegree, 60, 6);
    needle(view.mastCommand * kDegree, 74, 1.5);
    pen.fillStyle = kInk;
    pen.font = '14px sans-serif';
    pen.textAlign = 'left';
    pen.fillText('Mast', x - 56, y - 92);
    pen.textAlign = 'right';
    pen.fillText(`${fixed(view.mast, 0)} deg`, x + 70, y - 92);
  }
  leverBar(x, y, lever) {
    const {pen} = this;
    pen.fillStyle = kPaper;
    pen.fillRect(x - 36, y - 22, 80, 126);
    pen.fillStyle = kInk;
    pen.textAlign = 'center';
    pen.font = '14px sans-serif';
    pen.fillText('Lever', x + 4, y - 6);
    pen.strokeStyle = kInk;
    pen.lineWidth = 1.5;
    pen.strokeRect(x, y, 8, 94);
    pen.fillRect(x - 14, y + 47 - 44 * lever - 4, 36, 8);
  }
}
