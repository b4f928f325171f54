// Puts everything together. The element #status says "ready" when the first picture stands, or what failed.

const restDelay = 300; // milliseconds without a change after which a model is at rest

class Page {
  constructor() {
    const page = this.page = readPage();
    this.canvas = byId('canvas');
    document.body.classList.toggle('still', page.still);
    document.body.classList.toggle('keyless', !page.key);
    document.body.classList.toggle('pair', page.scenes.length > 1);
    this.renderer = new THREE.WebGLRenderer({ canvas: this.canvas, antialias: !page.still, alpha: true, preserveDrawingBuffer: page.still });
    this.renderer.autoClear = false;
    this.renderer.setPixelRatio(page.still ? 2 : Math.min(window.devicePixelRatio, 2));
    this.panes = page.scenes.map((scene) => {
      const model = new Model(scene);
      return { model, layers: new Layers(model) };
    });
    for (const { model, layers } of this.panes) for (const name of page.shown.length ? page.shown : model.shown) layers.set(name, true);
    this.pace = new Pace();
    this.view = new View(page, this.panes.map((pane) => pane.model), this.canvas, () => this.move());
    this.pictures = new Pictures(this.renderer, this.panes, this.view);
    this.picker = new Picker(this.renderer, this.view);
    this.panel = new Panel(page, this.panes, () => this.change(), () => this.move());
    this.resize();
    this.listen();
    if (page.still) return;
    this.drawAtRest();
    this.wanted = '';
  }

  listen() {
    // The key takes more room or less as layers are switched, too.
    new ResizeObserver(() => this.resize()).observe(this.canvas);
    this.canvas.addEventListener('pointermove', (event) => { this.pointer = event; this.want('pointed'); });
    this.canvas.addEventListener('pointerleave', () => { this.pointer = null; this.want('pointed'); });
    this.canvas.addEventListener('pointerdown', (event) => { this.pressed = [event.clientX, event.clientY]; });
    this.canvas.addEventListener('pointerup', (event) => {
      if (this.pressed && Math.hypot(event.clientX - this.pressed[0], event.clientY - this.pressed[1]) < 4) this.keep(event);
    });
    this.canvas.addEventListener('keydown', (event) => { if (event.key.toLowerCase() === 't') byId('transparent').click(); });
    for (const button of document.querySelectorAll('[data-view]'))
      button.addEventListener('click', () => (button.dataset.view === 'all' ? this.view.reset() : this.view.along(button.dataset.view)));
    byId('find').addEventListener('submit', (event) => { event.preventDefault(); this.find(byId('wanted').value); });
  }

  get paneWidth() { return this.pictures.paneWidth; }

  resize() {
    const stage = this.canvas.getBoundingClientRect();
    const width = Math.max(1, Math.round(stage.width)), height = Math.max(1, Math.round(stage.height));
    if (width === this.width && height === this.height) return;
    Object.assign(this, { width, height });
    this.pictures.resize(width, height);
    this.view.resize(this.paneWidth, height);
    if (this.page.still) this.pictures.draw();
    else this.move();
  }

  // What is to be done for the next frame of the browser, at most: a picture of what moves, or of what rests, or to see
  // what the pointer is at.
  want(what) {
    if (this.page.still) return;
    const order = ['', 'pointed', 'rest', 'move'];
    if (!this.wanted) requestAnimationFrame(() => this.step());
    if (order.indexOf(what) > order.indexOf(this.wanted || '')) this.wanted = what;
  }

  // Something else is to be seen.
  change() {
    this.picker.forget();
    this.want('rest');
  }

  // It is seen from elsewhere, and likely soon from elsewhere again.
  move() {
    this.picker.forget();
    this.want('move');
  }

  restLater() {
    clearTimeout(this.restTimer);
    this.restTimer = setTimeout(() => this.want('rest'), restDelay);
  }

  step() {
    const wanted = this.wanted;
    this.wanted = '';
    if (wanted === 'move') {
      if (!this.isMoving) this.pace.begin();
      this.isMoving = true;
      byId('tip').hidden = true;
      this.pictures.prepare(this.pace.detail);
      this.pace.tell(this.pictures.timed(() => this.pictures.drawMoving(this.pace.detail)));
      this.restLater();
    } else if (wanted === 'rest' || !this.isMoving) {
      const marksElse = this.hover();
      if (wanted === 'rest' || marksElse && this.pace.isQuick) this.drawAtRest();
      else if (marksElse) this.restLater();
    }
  }

  drawAtRest() {
    clearTimeout(this.restTimer);
    this.isMoving = false;
    this.pace.tellAtRest(this.pictures.timed(() => this.pictures.draw()));
  }

  // The pane below the pointer, and where in it.
  paneAt(event) {
    const number = Math.min(this.panes.length - 1, Math.max(0, Math.floor(event.offsetX / this.paneWidth)));
    return { pane: this.panes[number], x: event.offsetX - number * this.paneWidth, y: event.offsetY };
  }

  // Whether something else is marked now.
  hover() {
    const tip = byId('tip'), event = this.pointer, before = this.hit;
    if (event && event.buttons !== 0) return false;
    this.hit = null;
    if (event) {
      const { pane, x, y } = this.paneAt(event);
      const hit = this.picker.at(pane.layers, x, y, this.paneWidth, this.height);
      if (hit) this.hit = Object.assign(hit, { pane, nearest: this.nearestCorners(pane.model, hit, x, y) });
    }
    tip.hidden = !this.hit;
    if (!this.kept) this.mark(this.hit);
    if (this.hit) this.tell(tip, event);
    return !this.kept && !isSameItem(before, this.hit);
  }

  tell(tip, event) {
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
  keep(event) {
    this.pointer = event; // a finger has not been seen before
    this.hover();
    this.kept = this.hit;
    if (this.hit) show(byId('info'), this.description);
    this.mark(this.hit);
    this.want('rest');
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

function isSameItem(hit, other) {
  if (!hit || !other) return hit === other;
  return hit.layer === other.layer && hit.pane.model.itemOf(hit.layer, hit.element) === hit.pane.model.itemOf(other.layer, other.element);
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
