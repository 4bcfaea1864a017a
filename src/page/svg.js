// Elements, and the words that follow the pointer.

function svg(name, attributes = {}, ...children) {
  const element = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

function html(name, attributes = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

const byId = (id) => document.getElementById(id);

// Whatever carries data-tip shows it under the pointer, or beside it while it has the focus.
function showTip(target, x, y) {
  const tip = byId('tip'), carrier = target instanceof Element ? target.closest('[data-tip]') : null;
  tip.hidden = carrier === null;
  if (carrier === null) return;
  tip.textContent = carrier.dataset.tip;
  const box = tip.getBoundingClientRect();
  tip.style.left = `${clamp(x + 14, 4, Math.max(4, window.innerWidth - box.width - 4))}px`;
  tip.style.top = `${y + 18 + box.height > window.innerHeight ? y - box.height - 10 : y + 18}px`;
}
function followPointer() {
  for (const type of ['pointermove', 'pointerdown'])
    document.addEventListener(type, (event) => showTip(event.target, event.clientX, event.clientY));
  document.addEventListener('focusin', (event) => {
    const box = event.target.getBoundingClientRect();
    if (event.target instanceof Element && event.target.matches('[data-tip]')) showTip(event.target, box.left, box.top);
  });
  document.addEventListener('scroll', () => { byId('tip').hidden = true; }, {passive: true});
}

// An arrow with its point at (x2, y2).
function arrow(x1, y1, x2, y2, attributes) {
  const length = Math.hypot(x2 - x1, y2 - y1);
  if (length < 1) return svg('g');
  const head = Math.min(13, length / 2), ux = (x2 - x1) / length, uy = (y2 - y1) / length;
  const bx = x2 - head * ux, by = y2 - head * uy, side = 0.45 * head;
  return svg('g', attributes,
    svg('line', {x1, y1, x2: bx, y2: by, 'stroke-width': 4, stroke: 'currentColor'}),
    svg('polygon', {fill: 'currentColor',
      points: `${x2},${y2} ${bx - side * uy},${by + side * ux} ${bx + side * uy},${by - side * ux}`}));
}
