// A frame with two axes in an SVG: x() and y() turn numbers into places.

function ticks(low, high, wanted) {
  const raw = (high - low) / wanted;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = power * [1, 2, 5, 10].find((size) => size * power >= raw);
  const found = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) found.push(k * step);
  return found;
}

class Chart {
  // {x: [low, high], y: [low, high], xLabel, yLabel, width, height}
  constructor(element, axes) {
    this.element = element;
    this.below = svg('g');
    this.frame = svg('g', {class: 'frame'});
    this.marks = svg('g');
    this.clip = `${element.id}_clip`;
    this.area = svg('rect');
    element.append(svg('defs', {}, svg('clipPath', {id: this.clip}, this.area)));
    this.below.setAttribute('clip-path', `url(#${this.clip})`);
    this.marks.setAttribute('clip-path', `url(#${this.clip})`);
    element.append(this.below, this.frame, this.marks);
    this.setAxes(axes);
  }
  setAxes(axes) {
    this.axes = axes;
    const {width, height} = axes;
    this.left = 44;
    this.right = width - 10;
    this.top = 10;
    this.bottom = height - 36;
    this.element.setAttribute('viewBox', `0 0 ${width} ${height}`);
    for (const [key, value] of Object.entries({x: this.left, y: this.top, width: this.right - this.left,
      height: this.bottom - this.top})) this.area.setAttribute(key, value);
    this.frame.replaceChildren();
    for (const x of ticks(...axes.x, 5)) {
      this.frame.append(svg('line', {x1: this.x(x), x2: this.x(x), y1: this.top, y2: this.bottom,
        class: x === 0 ? 'zero' : 'grid'}));
      this.frame.append(svg('text', {x: this.x(x), y: this.bottom + 14, 'text-anchor': 'middle'}, significant(x)));
    }
    for (const y of ticks(...axes.y, 5)) {
      this.frame.append(svg('line', {x1: this.left, x2: this.right, y1: this.y(y), y2: this.y(y),
        class: y === 0 ? 'zero' : 'grid'}));
      this.frame.append(svg('text', {x: this.left - 5, y: this.y(y) + 4, 'text-anchor': 'end'}, significant(y)));
    }
    this.frame.append(
      svg('text', {x: (this.left + this.right) / 2, y: height - 6, 'text-anchor': 'middle'}, axes.xLabel),
      svg('text', {transform: `translate(11 ${(this.top + this.bottom) / 2}) rotate(-90)`,
        'text-anchor': 'middle'}, axes.yLabel));
  }
  x(value) {
    const [low, high] = this.axes.x;
    return this.left + (this.right - this.left) * (value - low) / (high - low);
  }
  y(value) {
    const [low, high] = this.axes.y;
    return this.bottom - (this.bottom - this.top) * (value - low) / (high - low);
  }
  // The numbers at a pointer event.
  at(event) {
    const box = this.element.getBoundingClientRect();
    const px = (event.clientX - box.left) / box.width * this.axes.width;
    const py = (event.clientY - box.top) / box.height * this.axes.height;
    const [x0, x1] = this.axes.x, [y0, y1] = this.axes.y;
    return {x: x0 + (px - this.left) / (this.right - this.left) * (x1 - x0),
      y: y0 + (this.bottom - py) / (this.bottom - this.top) * (y1 - y0)};
  }
}
