// Puts everything together. The element #status says "ready" when the first picture stands, or what failed.

class Page {
  constructor() {
    const page = this.page = readPage();
    this.canvas = byId('canvas');
    document.body.classList.toggle('still', page.still);
    document.body.classList.toggle('pair', page.scenes.length > 1);
    this.renderer = new THREE.WebGLRenderer({ canvas: this.canvas, antialias: !page.still, alpha: true, preserveDrawingBuffer: page.still });
    this.renderer.autoClear = false;
    this.renderer.setPixelRatio(page.still ? 2 : Math.min(window.devicePixelRatio, 2));
    this.panes = page.scenes.map((scene) => {
      const model = new Model(scene);
      return { model, layers: new Layers(model) };
    });
    for (const { model, layers } of this.panes) for (const name of page.shown.length ? page.shown : model.shown) layers.set(name, true);
    const changed = () => this.request();
    this.view = new View(page, this.panes.map((pane) => pane.model), this.canvas, changed);
    this.picker = new Picker(this.renderer, this.view);
    this.panel = new Panel(page, this.panes, changed);
    this.resize();
    this.listen();
    if (!page.still) this.draw();
  }

  listen() {
    window.addEventListener('resize', () => this.resize());
    this.canvas.addEventListener('pointermove', (event) => { this.pointer = event; this.request(); });
    this.canvas.addEventListener('pointerleave', () => { this.pointer = null; this.request(); });
    this.canvas.addEventListener('pointerdown', (event) => { this.pressed = [event.clientX, event.clientY]; });
    this.canvas.addEventListener('pointerup', (event) => {
      if (this.pressed && Math.hypot(event.clientX - this.pressed[0], event.clientY - this.pressed[1]) < 4) this.keep();
    });
    this.canvas.addEventListener('keydown', (event) => { if (event.key.toLowerCase() === 't') byId('transparent').click(); });
    for (const button of document.querySelectorAll('[data-view]'))
      button.addEventListener('click', () => (button.dataset.view === 'all' ? this.view.reset() : this.view.along(button.dataset.view)));
    byId('find').addEventListener('submit', (event) => { event.preventDefault(); this.find(byId('wanted').value); });
  }

  // Of every pane, side by side.
  get paneWidth() { return Math.max(1, Math.floor(this.width / this.panes.length)); }

  resize() {
    const stage = this.canvas.getBoundingClientRect();
    const width = Math.max(1, Math.round(stage.width)), height = Math.max(1, Math.round(stage.height));
    if (width === this.width && height === this.height) return;
    Object.assign(this, { width, height });
    this.renderer.setSize(this.width, this.height, false);
    this.view.resize(this.paneWidth, this.height);
    if (this.page.still) this.draw();
    else this.request();
  }

  // At most one picture per frame, and none if nothing has changed.
  request() {
    if (this.requested || this.page.still) return;
    this.requested = true;
    requestAnimationFrame(() => { this.requested = false; this.hover(); this.draw(); });
  }

  draw() {
    const ratio = shared.pixelRatio.value = this.renderer.getPixelRatio();
    shared.resolution.value.set(this.paneWidth * ratio, this.height * ratio);
    this.view.prepare();
    this.renderer.setScissorTest(true);
    this.panes.forEach(({ layers }, k) => {
      const part = [k * this.paneWidth, 0, this.paneWidth, this.height];
      this.renderer.setViewport(...part);
      this.renderer.setScissor(...part);
      this.renderer.setClearColor(0, 0);
      this.renderer.clear();
      this.renderer.render(layers.root, this.view.camera);
    });
  }

  // The pane below the pointer, and where in it.
  paneAt(event) {
    const number = Math.min(this.panes.length - 1, Math.max(0, Math.floor(event.offsetX / this.paneWidth)));
    return { pane: this.panes[number], x: event.offsetX - number * this.paneWidth, y: event.offsetY };
  }

  hover() {
    const tip = byId('tip');
    const event = this.pointer;
    this.hit = null;
    if (event && event.buttons === 0) {
      const { pane, x, y } = this.paneAt(event);
      const hit = this.picker.at(pane.layers, x, y, this.paneWidth, this.height);
      if (hit) this.hit = Object.assign(hit, { pane, nearest: this.nearestCorners(pane.model, hit, x, y) });
    }
    tip.hidden = !this.hit;
    if (!this.kept) this.mark(this.hit);
    if (!this.hit) return;
    this.description = describe(this.hit.pane.model, this.hit.layer, this.hit.element, this.hit.nearest);
    show(tip, this.description);
    const box = tip.getBoundingClientRect();
    tip.style.left = Math.max(0, Math.min(event.offsetX + 16, this.width - box.width - 4)) + 'px';
    tip.style.top = Math.max(0, Math.min(event.offsetY + 16, this.height - box.height - 4)) + 'px';
  }

  mark(hit) {
    for (const pane of this.panes)
      if (hit && hit.pane === pane) pane.layers.highlight(hit.layer, pane.model.itemOf(hit.layer, hit.element));
      else pane.layers.highlight(null);
  }

  // Of a quad's corners the nearest to a point of the pane, and the nearer of its two neighbours.
  nearestCorners(model, hit, x, y) {
    if (hit.layer.type !== 'faces') return null;
    const away = model.pointsOf(hit.layer, hit.element).map((point) => {
      const seen = model.place(hit.layer.base, point).project(this.view.camera);
      return Math.hypot((seen.x + 1) / 2 * this.paneWidth - x, (1 - seen.y) / 2 * this.height - y);
    });
    const first = away.indexOf(Math.min(...away));
    const next = [(first + 1) % 4, (first + 3) % 4];
    return [first, away[next[0]] < away[next[1]] ? next[0] : next[1]];
  }

  // A click keeps what is under the pointer; a click beside the model lets it go.
  keep() {
    this.kept = this.hit;
    if (this.hit) show(byId('info'), this.description);
    this.mark(this.hit);
    this.request();
  }

  // "separatrix 12": shows its layer, marks it, and goes there.
  find(text) {
    const match = /^\s*(.*?)\s+(\d+)\s*$/.exec(text);
    const found = match ? this.elementOf(match[1].toLowerCase(), Number(match[2])) : null;
    byId('found').textContent = found ? '' : `There is no ${text.trim() || 'such thing'}.`;
    if (!found) return;
    const { pane: { model }, layer, element } = found;
    this.panel.refresh();
    this.kept = found;
    this.mark(found);
    const points = model.pointsOf(layer, element);
    show(byId('info'), describe(model, layer, element, found.nearest));
    this.view.goTo(model.place(layer.base, points[found.nearest ? found.nearest[0] : 0]));
  }

  // In the first pane that has it; its layer is then on.
  elementOf(noun, number) {
    for (const pane of this.panes) {
      const { model, layers } = pane, mesh = layers.named('mesh');
      if (noun === 'face' && number < model.mesh.quads.length / 4) {
        layers.set('mesh', true);
        return { pane, layer: mesh, element: number };
      }
      const at = noun === 'vertex' ? model.mesh.quads.indexOf(number) : -1;
      if (at >= 0) {
        layers.set('mesh', true);
        return { pane, layer: mesh, element: at >> 2, nearest: [at % 4, (at + 1) % 4] };
      }
      const layer = layers.all.find((candidate) => isNumbered(candidate.items) && candidate.items.noun === noun && number < candidate.items.count);
      if (!layer) continue;
      layers.set(layer.name, true);
      for (let element = 0; element < layer.elementCount; ++element)
        if (model.itemOf(layer, element) === number) return { pane, layer, element };
    }
    return null;
  }
}

try {
  const page = new Page();
  if (location.hash === '#census') {
    const seen = page.panes.map(({ layers }) => page.picker.census(layers, page.paneWidth, page.height));
    byId('status').dataset.census = JSON.stringify(seen.length > 1 ? seen : seen[0]);
  }
  byId('status').textContent = 'ready';
} catch (error) {
  byId('status').textContent = `failed: ${error.message}`;
  byId('info').textContent = `This page needs WebGL, which the browser does not offer (${error.message}).`;
  throw error;
}
