// Puts everything together. The element #status says "ready" when the first picture stands, or what failed.

class Page {
  constructor() {
    this.scene = readScene();
    this.canvas = byId('canvas');
    document.body.classList.toggle('still', this.scene.still);
    this.renderer = new THREE.WebGLRenderer({ canvas: this.canvas, antialias: true, alpha: true, preserveDrawingBuffer: this.scene.still });
    this.renderer.autoClear = false;
    this.renderer.setPixelRatio(this.scene.still ? 2 : Math.min(window.devicePixelRatio, 2));
    this.layers = new Layers(this.scene);
    const changed = () => this.request();
    this.view = new View(this.scene, this.canvas, changed);
    this.picker = new Picker(this.renderer, this.layers, this.view);
    this.panel = new Panel(this.scene, this.layers, changed);
    this.resize();
    this.listen();
    this.draw();
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

  resize() {
    const stage = this.canvas.getBoundingClientRect();
    this.width = Math.max(1, Math.round(stage.width));
    this.height = Math.max(1, Math.round(stage.height));
    this.renderer.setSize(this.width, this.height, false);
    this.view.resize(this.width, this.height);
    this.request();
  }

  // At most one picture per frame, and none if nothing has changed.
  request() {
    if (this.requested) return;
    this.requested = true;
    requestAnimationFrame(() => { this.requested = false; this.hover(); this.draw(); });
  }

  draw() {
    shared.pixelRatio.value = this.renderer.getPixelRatio();
    this.renderer.getDrawingBufferSize(shared.resolution.value);
    this.view.prepare();
    this.renderer.setClearColor(0, 0);
    this.renderer.clear();
    this.renderer.render(this.layers.root, this.view.camera);
  }

  hover() {
    const tip = byId('tip');
    const event = this.pointer;
    const hit = event && event.buttons === 0 ? this.picker.at(event.offsetX, event.offsetY, this.width, this.height) : null;
    this.hit = hit;
    tip.hidden = !hit;
    if (!this.kept) this.layers.highlight(hit && hit.layer, hit && this.layers.itemOf(hit.layer, hit.element));
    if (!hit) return;
    this.description = describe(this.scene, this.layers, hit.layer, hit.element, this.nearestCorners(hit, event));
    show(tip, this.description);
    const box = tip.getBoundingClientRect();
    tip.style.left = Math.max(0, Math.min(event.offsetX + 16, this.width - box.width - 4)) + 'px';
    tip.style.top = Math.max(0, Math.min(event.offsetY + 16, this.height - box.height - 4)) + 'px';
  }

  // Of a quad's corners the nearest to the pointer on the screen, and the nearer of its two neighbours.
  nearestCorners(hit, event) {
    if (hit.layer.type !== 'faces') return null;
    const away = this.layers.pointsOf(hit.layer, hit.element).map((point) => {
      const seen = this.layers.place(hit.layer.base, point).project(this.view.camera);
      return Math.hypot((seen.x + 1) / 2 * this.width - event.offsetX, (1 - seen.y) / 2 * this.height - event.offsetY);
    });
    const first = away.indexOf(Math.min(...away));
    const next = [(first + 1) % 4, (first + 3) % 4];
    return [first, away[next[0]] < away[next[1]] ? next[0] : next[1]];
  }

  // A click keeps what is under the pointer; a click beside the model lets it go.
  keep() {
    this.kept = this.hit;
    if (this.hit) show(byId('info'), this.description);
    this.layers.highlight(this.hit && this.hit.layer, this.hit && this.layers.itemOf(this.hit.layer, this.hit.element));
    this.request();
  }

  // "separatrix 12": shows its layer, marks it, and goes there.
  find(text) {
    const match = /^\s*(.*?)\s+(\d+)\s*$/.exec(text);
    const found = match ? this.elementOf(match[1].toLowerCase(), Number(match[2])) : null;
    byId('found').textContent = found ? '' : `There is no ${text.trim() || 'such thing'}.`;
    if (!found) return;
    const { layer, element } = found;
    this.layers.set(layer.name, true);
    this.panel.refresh();
    this.kept = found;
    this.layers.highlight(layer, this.layers.itemOf(layer, element));
    const points = this.layers.pointsOf(layer, element);
    show(byId('info'), describe(this.scene, this.layers, layer, element, found.nearest));
    this.view.goTo(this.layers.place(layer.base, points[found.nearest ? found.nearest[0] : 0]));
  }

  elementOf(noun, number) {
    const mesh = this.layers.named('mesh');
    if (noun === 'face') return number < mesh.elementCount ? { layer: mesh, element: number } : null;
    if (noun === 'vertex') {
      const at = this.scene.shells[0].quads.indexOf(number);
      return at < 0 ? null : { layer: mesh, element: at >> 2, nearest: [at % 4, (at + 1) % 4] };
    }
    const layer = this.layers.all.find((candidate) => candidate.items.pointer && candidate.items.noun === noun && number < candidate.items.count);
    if (!layer) return null;
    for (let element = 0; element < layer.elementCount; ++element)
      if (this.layers.itemOf(layer, element) === number) return { layer, element };
    return null;
  }
}

try {
  const page = new Page();
  if (location.hash === '#census') byId('status').dataset.census = JSON.stringify(page.picker.census(page.width, page.height));
  byId('status').textContent = 'ready';
} catch (error) {
  byId('status').textContent = `failed: ${error.message}`;
  byId('info').textContent = `This page needs WebGL, which the browser does not offer (${error.message}).`;
  throw error;
}
