// A and B as a picture: blue adds, orange takes away, darker is more.

const kGap = 16;  // between A and B

class Matrices {
  constructor(canvas) {
    this.canvas = canvas;
    this.pen = canvas.getContext('2d');
    for (const type of ['pointermove', 'pointerdown']) canvas.addEventListener(type, (event) => this.point(event), {capture: true});
    this.at = [0, 0];
    canvas.addEventListener('keydown', (event) => this.walk(event));
  }
  shade(value) {
    if (value === 0) return '#ffffff';
    const part = clamp((Math.log10(Math.abs(value)) + 4) / 7, 0.06, 1);  // of four decades below 1 to three above
    return value > 0 ? `rgba(0, 90, 150, ${part})` : `rgba(200, 85, 0, ${part})`;
  }
  show(linear) {
    const {pen, canvas} = this, {n, m} = linear;
    this.linear = linear;
    this.cell = Math.min((canvas.width - kGap) / (n + m), canvas.height / n);
    pen.clearRect(0, 0, canvas.width, canvas.height);
    for (let i = 0; i < n; ++i) {
      for (let j = 0; j < n + m; ++j) {
        pen.fillStyle = this.shade(j < n ? linear.a[i * n + j] : linear.b[i * m + j - n]);
        pen.fillRect(j * this.cell + (j < n ? 0 : kGap), i * this.cell, this.cell - 1, this.cell - 1);
      }
    }
  }
  point(event) {
    if (!this.linear) return;
    const box = this.canvas.getBoundingClientRect(), {n, m, a, b, states, controls} = this.linear;
    const x = (event.clientX - box.left) / box.width * this.canvas.width;
    const i = Math.floor((event.clientY - box.top) / box.height * this.canvas.height / this.cell);
    const inA = x < n * this.cell;
    const j = Math.floor((inA ? x : x - kGap - n * this.cell) / this.cell);
    if (i < 0 || i >= n || j < 0 || j >= (inA ? n : m)) delete this.canvas.dataset.tip;
    else this.canvas.dataset.tip = this.words(i, inA ? j : n + j);
  }
  words(i, j) {
    const {n, m, a, b, states, controls} = this.linear;
    return `d(d${states[i]}/dt)/d${j < n ? states[j] : controls[j - n]} = ${significant(j < n ? a[i * n + j] : b[i * m + j - n])}`;
  }
  // From element to element by the arrow keys, which then are not the stick's.
  walk(event) {
    const way = {ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowUp: [-1, 0], ArrowDown: [1, 0]}[event.key];
    if (way === undefined || !this.linear) return;
    event.preventDefault();
    event.stopPropagation();
    const {n, m} = this.linear;
    this.at = [clamp(this.at[0] + way[0], 0, n - 1), clamp(this.at[1] + way[1], 0, n + m - 1)];
    this.canvas.dataset.tip = this.words(...this.at);
    this.canvas.setAttribute('aria-label', this.canvas.dataset.tip);
    const box = this.canvas.getBoundingClientRect(), size = this.cell * box.width / this.canvas.width;
    showTip(this.canvas, box.left + (this.at[1] + 1) * size, box.top + this.at[0] * size);
  }
}
