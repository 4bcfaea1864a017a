// A still picture (#still) says what is wrong with its layout: words that are cut off, or that lie outside of their picture.

function stillFaults(room) {
  const faults = [], wide = document.documentElement.scrollWidth - window.innerWidth;
  if (wide > 0) faults.push(`the page is ${wide} pixels too wide`);
  for (const text of byId(room).querySelectorAll('svg text')) {
    const box = text.getBoundingClientRect(), frame = text.ownerSVGElement.getBoundingClientRect();
    const out = Math.max(frame.left - box.left, box.right - frame.right, frame.top - box.top, box.bottom - frame.bottom);
    if (out > 1) faults.push(`"${text.textContent}" is ${fixed(out, 0)} pixels outside of ${text.ownerSVGElement.id}`);
  }
  for (const part of byId(room).querySelectorAll('p, label, h2, .bar > span, output, li'))
    if (part.scrollWidth > part.clientWidth + 1 && part.clientWidth > 0) faults.push(`"${part.textContent.trim()}" is cut off`);
  for (const part of byId(room).querySelectorAll('.scroll'))
    if (part.scrollWidth > part.clientWidth + 1) faults.push(`the table is ${part.scrollWidth - part.clientWidth} pixels too wide`);
  return `${room} at ${window.innerWidth} pixels: ${faults.length === 0 ? 'nothing cut off' : faults.join('; ')}`;
}
