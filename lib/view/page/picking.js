// What is under the pointer: models are drawn once with every element in the colour of its number, and pixels of that
// picture are looked at until another is to be seen.

class Picker {
  constructor(renderer, view) {
    Object.assign(this, { renderer, view });
    this.reach = 6;
    this.pixels = new Uint8Array(4 * (2 * this.reach + 1) ** 2);
    this.targets = new Map();
  }

  // Something else is to be seen.
  forget() {
    for (const target of this.targets.values()) target.dispose();
    this.targets.clear();
  }

  // A picture of the numbers of a model's elements.
  numbers(layers, width, height) {
    if (!this.targets.has(layers)) {
      this.targets.set(layers, new THREE.WebGLRenderTarget(width, height));
      this.draw(layers, this.targets.get(layers), width, height);
    }
    return this.targets.get(layers);
  }

  draw(layers, target, width, height) {
    const ratio = shared.pixelRatio.value, resolution = shared.resolution.value.clone();
    shared.picking.value = 1;
    shared.pixelRatio.value = 1;
    shared.resolution.value.set(width, height);
    layers.setCells(undefined);
    this.view.prepare();
    this.renderer.setRenderTarget(target);
    this.renderer.setClearColor(0, 0);
    this.renderer.clear();
    this.renderer.render(layers.root, this.view.camera);
    this.renderer.setRenderTarget(null);
    shared.picking.value = 0;
    shared.pixelRatio.value = ratio;
    shared.resolution.value.copy(resolution);
  }

  numberAt(pixels, pixel) { return pixels[4 * pixel] + 256 * pixels[4 * pixel + 1] + 65536 * pixels[4 * pixel + 2]; }

  // The nearest point or line within reach, or the face under the pointer; x and y in pixels of its pane.
  at(layers, x, y, width, height) {
    const size = Math.min(2 * this.reach + 1, width, height);
    const across = Math.floor(x), up = height - 1 - Math.floor(y); // pixels are counted from below
    const left = Math.min(Math.max(across - this.reach, 0), width - size), low = Math.min(Math.max(up - this.reach, 0), height - size);
    this.renderer.readRenderTargetPixels(this.numbers(layers, width, height), left, low, size, size, this.pixels);
    let best = null, min = Infinity;
    for (let pixel = 0; pixel < size * size; ++pixel) {
      const hit = layers.find(this.numberAt(this.pixels, pixel));
      if (!hit) continue;
      const away = Math.hypot(left + pixel % size - across, low + Math.floor(pixel / size) - up);
      const rank = { points: 0, lines: 100, faces: 200 }[hit.layer.type] + away;
      if (hit.layer.type === 'faces' ? away > 0 : hit.layer.name === 'edges' && away > 2) continue;
      if (rank < min) [best, min] = [hit, rank];
    }
    return best;
  }

  // How many items of every layer of a model that is on are seen in its pane.
  census(layers, width, height) {
    const pixels = new Uint8Array(4 * width * height);
    this.renderer.readRenderTargetPixels(this.numbers(layers, width, height), 0, 0, width, height, pixels);
    const seen = {};
    for (let pixel = 0; pixel < width * height; ++pixel) {
      const hit = layers.find(this.numberAt(pixels, pixel));
      if (hit) (seen[hit.layer.name] = seen[hit.layer.name] || new Set()).add(layers.model.itemOf(hit.layer, hit.element));
    }
    for (const name of Object.keys(seen)) seen[name] = seen[name].size;
    return seen;
  }
}
