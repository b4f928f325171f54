// The panel beside the picture: figures, layers, the key and the scale.

const byId = (id) => document.getElementById(id);

function swatchOf(layer) {
  const swatch = document.createElement('span');
  swatch.className = 'swatch ' + { faces: '', lines: 'line', points: 'point' }[layer.type];
  if (layer.type === 'lines') swatch.style.borderColor = lineStyles[layer.name].colour;
  if (layer.type === 'points') swatch.style.background = layer.name === 'extraordinary'
    ? `linear-gradient(90deg, ${fewerEdges} 50%, ${pointStyles.extraordinary.colour} 50%)` : pointStyles[layer.name].colour;
  if (layer.type === 'faces')
    swatch.style.background = layer.values ? `linear-gradient(90deg, ${rampColours.join()})`
      : layer.groups ? `linear-gradient(90deg, ${faceColours.slice(0, 4).map((c, k) => `${c} ${25 * k}% ${25 * k + 25}%`).join()})` : plainFace;
  return swatch;
}

function titleOf(layer) {
  const more = layer.name === 'extraordinary' ? ' (blue: few edges, orange: many)' : '';
  return document.createTextNode(layer.title + more);
}

class Panel {
  constructor(scene, layers, changed) {
    Object.assign(this, { scene, layers, changed });
    document.title = `${scene.title} – ${scene.kind}`;
    byId('title').textContent = scene.title;
    byId('kind').textContent = `document of kind ${scene.kind}`;
    for (const [name, value] of scene.figures) {
      const term = document.createElement('dt'), detail = document.createElement('dd');
      term.textContent = name;
      detail.textContent = numberText(value);
      byId('figures').append(term, detail);
    }
    for (const layer of layers.all) this.addChoice(layer);
    byId('transparent').addEventListener('change', (event) => { layers.setTransparent(event.target.checked); changed(); });
    byId('scale-top').addEventListener('change', () => this.refresh());
    const nouns = new Set(['vertex', 'face', ...layers.all.filter((layer) => layer.items.pointer).map((layer) => layer.items.noun)]);
    for (const noun of nouns) byId('nouns').append(new Option(noun, noun + ' 0'));
    this.refresh();
  }

  addChoice(layer) {
    const label = document.createElement('label');
    const input = document.createElement('input');
    input.type = layer.type === 'faces' ? 'radio' : 'checkbox';
    input.name = layer.type === 'faces' ? 'faces' : layer.name;
    input.value = layer.name;
    input.addEventListener('change', () => { this.layers.set(layer.name, input.checked); this.refresh(); });
    layer.input = input;
    label.append(input, swatchOf(layer), titleOf(layer));
    byId(layer.type === 'faces' ? 'face-layers' : 'line-layers').append(label);
  }

  refresh() {
    byId('swatches').textContent = '';
    for (const layer of this.layers.all) {
      layer.input.checked = layer.on;
      if (!layer.on || layer.name === 'mesh') continue;
      const entry = document.createElement('li');
      entry.append(swatchOf(layer), titleOf(layer));
      if (!layer.values) byId('swatches').append(entry);
    }
    this.refreshScale();
    this.changed();
  }

  refreshScale() {
    const layer = this.layers.faces;
    const mapped = Boolean(layer && layer.values);
    byId('scale').hidden = byId('scale-choice').hidden = !mapped;
    if (!mapped) return;
    const top = layer.scale * Number(byId('scale-top').value);
    layer.object.material.uniforms.scaleTop.value = top > 0 ? top : 1;
    byId('scale-title').textContent = layer.unit;
    byId('ramp').style.background = `linear-gradient(90deg, ${rampColours.join()})`;
    byId('ticks').textContent = '';
    for (let k = 0; k <= 4; ++k) {
      const tick = document.createElement('span');
      tick.textContent = (k === 4 && top < layer.scale ? '≥ ' : '') + Number((top * k / 4).toPrecision(2));
      byId('ticks').append(tick);
    }
  }
}
