// The panel beside the picture: figures, layers, and how to look at them.

const byId = (id) => document.getElementById(id);

class Panel {
  // \param panes  a model and its layers each
  // \param changed  called when something else is to be seen; moved, when likely something else again soon
  constructor(page, panes, changed, moved) {
    Object.assign(this, { page, panes, changed, moved });
    const models = panes.map((pane) => pane.model);
    document.title = models.map((model) => `${model.title} – ${model.kind}`).join(' | ');
    byId('title').textContent = [...new Set(models.map((model) => model.title))].join(' | ');
    byId('kind').textContent = models.length > 1 ? 'two documents, left and right' : `document of kind ${models[0].kind}`;
    this.listFigures(models);
    for (const layer of this.layers()) this.addChoice(layer);
    byId('transparent').addEventListener('change', (event) => {
      for (const { layers } of panes) layers.setTransparent(event.target.checked);
      changed();
    });
    byId('scale-top').addEventListener('change', () => this.refresh());
    const nouns = new Set(['vertex', 'face', ...this.layers().filter((layer) => isNumbered(layer.items)).map((layer) => layer.items.noun)]);
    for (const noun of nouns) byId('nouns').append(new Option(noun, noun + ' 0'));
    this.listenToSection();
    this.listenToTheme();
    this.refresh();
  }

  // Of all models, each name once.
  layers() {
    const names = new Map();
    for (const { layers } of this.panes) for (const layer of layers.all) if (!names.has(layer.name)) names.set(layer.name, layer);
    return [...names.values()];
  }

  listFigures(models) {
    const names = new Set(models.flatMap((model) => model.figures.map(([name]) => name)));
    byId('figures').style.gridTemplateColumns = `1fr ${'auto '.repeat(models.length)}`;
    for (const name of names) {
      const values = models.map((model) => model.figures.find(([other]) => other === name));
      byId('figures').append(element('dt', { textContent: name }),
        ...values.map((found) => element('dd', { textContent: found ? numberText(found[1]) : '–' })));
    }
  }

  addChoice(layer) {
    const faces = layer.type === 'faces';
    const input = element('input', { type: faces ? 'radio' : 'checkbox', name: faces ? 'faces' : layer.name, value: layer.name });
    input.addEventListener('change', () => {
      for (const { layers } of this.panes) layers.set(layer.name, input.checked);
      this.refresh();
    });
    byId(faces ? 'face-layers' : 'line-layers').append(element('label', {}, input, swatchOf(layer), titleOf(layer)));
  }

  listenToSection() {
    const { axis, share } = this.page.section;
    byId('section-axis').value = axis < 0 ? '' : 'xyz'[axis];
    byId('section-share').value = share;
    const update = () => {
      byId('section-share').disabled = byId('section-axis').value === '';
      this.cut('xyz'.indexOf(byId('section-axis').value || '?'), Number(byId('section-share').value));
      this.moved();
    };
    byId('section-axis').addEventListener('change', update);
    byId('section-share').addEventListener('input', update);
    update();
  }

  // The plane stands at a share of the extent of all models.
  cut(axis, share) {
    if (axis < 0) { shared.section.value.set(0, 0, 0, 1); return; }
    let low = Infinity, high = -Infinity;
    for (const { model: { mesh } } of this.panes)
      for (const point of mesh.quads) {
        const at = mesh.positions[3 * point + axis];
        if (at < low) low = at;
        if (at > high) high = at;
      }
    // Away from the eye's side, so that one looks inside.
    const sign = this.page.from[axis] < 0 ? -1 : 1;
    const place = low + (sign > 0 ? share : 1 - share) * (high - low);
    const normal = [0, 0, 0];
    normal[axis] = sign;
    shared.section.value.set(...normal, sign * place);
  }

  listenToTheme() {
    const preferred = window.matchMedia('(prefers-color-scheme: dark)');
    const root = document.documentElement;
    if (this.page.still) root.dataset.theme = 'light';
    byId('theme').addEventListener('click', () => {
      root.dataset.theme = this.isDark() ? 'light' : 'dark';
      this.refresh();
    });
    preferred.addEventListener('change', () => this.refresh());
  }

  isDark() {
    const chosen = document.documentElement.dataset.theme;
    return chosen ? chosen === 'dark' : window.matchMedia('(prefers-color-scheme: dark)').matches;
  }

  refresh() {
    const on = new Map();
    for (const { layers } of this.panes) for (const layer of layers.all) if (layer.on) on.set(layer.name, layer);
    for (const input of document.querySelectorAll('#layers input[value]')) if (input.name) input.checked = on.has(input.value);
    byId('swatches').textContent = '';
    for (const layer of on.values())
      if (!layer.mapped && layer.paint !== 'plain') byId('swatches').append(element('li', {}, swatchOf(layer), titleOf(layer)));
    this.refreshScales();
    for (const { layers } of this.panes) layers.setInk(this.isDark());
    this.changed();
  }

  // Layers of the same name have one scale in both panes.
  refreshScales() {
    byId('scales').textContent = '';
    const mapped = new Map();
    this.panes.forEach(({ layers, model }, k) => {
      const side = this.panes.length > 1 ? ['left: ', 'right: '][k] : '';
      for (const layer of layers.mapped) mapped.set(layer.name, [...(mapped.get(layer.name) || []), { layer, layers, model, side }]);
    });
    byId('scale-choice').hidden = ![...mapped.values()].some(([{ layer }]) => layer.mapped.scale !== 'verdict');
    const choice = byId('scale-top').value;
    for (const shown of mapped.values()) {
      const tops = shown.map(({ layer, model }) => scaleTops(layer.mapped, model.radius));
      const top = Math.max(...tops.map((some) => some[choice] || some.usual || some.limit));
      shown.forEach(({ layer, layers }) => layers.setScale(layer, top));
      const group = element('div', { className: 'pair' });
      for (const { layer, model, side } of shown) group.append(scaleFigure(layer, top, model, side));
      byId('scales').append(group);
    }
  }
}
