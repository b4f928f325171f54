// The key below the picture: what colours mean, and how figures are spread over their scale.

function element(name, properties, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

function swatchOf(layer) {
  const swatch = element('span', { className: `swatch ${layer.type}` });
  if (layer.type === 'lines') {
    const style = lineStyles[layer.name];
    const mark = element('span');
    mark.style.height = `${Math.max(1.5, style.width)}px`;
    mark.style.background = layer.mapped ? gradient(layer.mapped.scale) : style.colour;
    swatch.append(mark);
  }
  if (layer.type === 'points') {
    const mark = element('span');
    mark.style.background = layer.name === 'extraordinary'
      ? `linear-gradient(90deg, ${fewerEdges} 50%, ${pointStyles.extraordinary.colour} 50%)` : pointStyles[layer.name].colour;
    swatch.append(mark);
  }
  if (layer.type === 'faces') swatch.style.background = {
    plain: plainFace,
    items: `linear-gradient(90deg, ${faceColours.slice(0, 4).map((colour, k) => `${colour} ${25 * k}% ${25 * k + 25}%`).join()})`,
    mapped: layer.mapped ? gradient(layer.mapped.scale) : '',
    stripes: 'repeating-linear-gradient(90deg, #4f6175 0 3px, #f6f7f8 3px 6px)',
  }[layer.paint];
  return swatch;
}

function titleOf(layer) {
  const more = layer.name === 'extraordinary' ? ' (blue: few edges, orange: many)' : '';
  return layer.title + more;
}

function tickText(value) {
  const size = Math.abs(value);
  if (size === 0) return '0';
  return size >= 1e-4 && size < 1e5 ? String(Number(value.toPrecision(3))) : value.toExponential(1);
}

function percentText(share) { return `${Number((100 * share).toPrecision(2))} %`; }

// Bars above the scale, as high as the root of their counts, so that few are seen beside many.
function bars(counts) {
  const largest = Math.sqrt(Math.max(1, ...counts)), step = 240 / counts.length;
  const path = counts.map((count, k) => {
    const height = 26 * Math.sqrt(count) / largest;
    return count ? `M${k * step} 26v${-Math.max(height, 0.7)}h${step * 0.86}V26z` : '';
  }).join('');
  const box = document.createElement('span');
  box.className = 'bars';
  box.innerHTML = `<svg viewBox="0 0 240 26" preserveAspectRatio="none" aria-hidden="true"><path d="${path}"/></svg>`;
  return box;
}

function ticksOf(mapped, top) {
  if (mapped.scale === 'verdict') return [['0', 0], [tickText(mapped.limit / 2), 0.4], [tickText(mapped.limit), 0.8]];
  if (mapped.scale === 'centred') return [[tickText(-top), 0], ['0', 0.5], [tickText(top), 1]];
  const ticks = [0, 0.25, 0.5, 0.75, 1].map((share) => [tickText(share * top), share]);
  const fit = ticks.every(([text]) => text.length < 6); // on a scale of 240 pixels, whose last text ends at its end
  return fit ? ticks : ticks.filter((_, k) => k % 2 === 0);
}

function notesOf(mapped, model) {
  const largest = largestSize(mapped.values);
  if (mapped.scale === 'verdict') return largest > mapped.limit ? [] : [`passes: all samples are within ${tickText(mapped.limit)} ${mapped.unit}`];
  const notes = [`largest ${withUnit(tickText(largest), mapped.unit)}`];
  if (mapped.source === undefined) notes.push(`${percentText(largest / (2 * model.radius))} of the diagonal`);
  if (mapped.limit > 0) notes.push(`limit ${withUnit(tickText(mapped.limit), mapped.unit)}`);
  return notes;
}

// What the colour beyond the end of the scale stands for, if it is there.
function beyondText(mapped, top) {
  const { beyond, all } = histogram(mapped, mapped.scale === 'verdict' ? mapped.limit : top);
  if (!beyond) return '';
  return mapped.scale === 'verdict' ? `fails: ${percentText(beyond / all)} of the samples are beyond` : `${percentText(beyond / all)} beyond the scale`;
}

function unknownText(mapped) { return mapped.values.some(Number.isNaN) ? 'nothing to measure from' : ''; }

// The scale of a layer, with its histogram.
function scaleFigure(layer, top, model, side) {
  const { mapped } = layer;
  const ramp = element('div', { className: 'ramp' });
  ramp.style.background = gradient(mapped.scale);
  if (mapped.scale === 'rising' && mapped.limit > 0 && mapped.limit <= top) {
    const mark = element('i', { className: 'limit', title: 'limit' });
    mark.style.left = `${100 * mapped.limit / top}%`;
    ramp.append(mark);
  }
  const ticks = element('div', { className: 'ticks' });
  for (const [text, share] of ticksOf(mapped, top)) {
    const tick = element('span', { textContent: text });
    tick.style.left = `${100 * share}%`;
    ticks.append(tick);
  }
  const note = element('p', { className: 'note' });
  for (const text of notesOf(mapped, model)) note.append(element('span', { textContent: text }));
  for (const [text, colour] of [[beyondText(mapped, top), beyondColours[mapped.scale]], [unknownText(mapped), unknownColour]]) {
    if (!text) continue;
    const swatch = element('span', { className: 'swatch' });
    swatch.style.background = colour;
    note.append(element('span', {}, swatch, text));
  }
  const caption = element('figcaption', { textContent: [side + mapped.quantity, mapped.unit].filter(Boolean).join(', ') });
  return element('figure', { className: 'scale' }, caption, bars(histogram(mapped, top).counts), ramp, ticks, note);
}
