// What is under the pointer: a few pixels about it are drawn with every element in the colour of its number.

class Picker {
  constructor(renderer, view) {
    Object.assign(this, { renderer, view });
    this.reach = 6;
    this.size = 2 * this.reach + 1;
    this.target = new THREE.WebGLRenderTarget(this.size, this.size);
    this.pixels = new Uint8Array(4 * this.size * this.size);
  }

  // Draws the numbers of a model's elements into a target.
  draw(layers, target, width, height) {
    const ratio = shared.pixelRatio.value, resolution = shared.resolution.value.clone();
    shared.picking.value = 1;
    shared.pixelRatio.value = 1;
    shared.resolution.value.set(width, height);
    this.view.prepare();
    this.renderer.setScissorTest(false);
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
    this.view.camera.setViewOffset(width, height, x - this.reach, y - this.reach, this.size, this.size);
    this.draw(layers, this.target, this.size, this.size);
    this.view.camera.clearViewOffset();
    this.renderer.readRenderTargetPixels(this.target, 0, 0, this.size, this.size, this.pixels);
    let best = null, min = Infinity;
    for (let pixel = 0; pixel < this.size * this.size; ++pixel) {
      const hit = layers.find(this.numberAt(this.pixels, pixel));
      if (!hit) continue;
      const away = Math.hypot(pixel % this.size - this.reach, Math.floor(pixel / this.size) - this.reach);
      const rank = { points: 0, lines: 100, faces: 200 }[hit.layer.type] + away;
      if (hit.layer.type === 'faces' ? away > 0 : hit.layer.name === 'edges' && away > 2) continue;
      if (rank < min) [best, min] = [hit, rank];
    }
    return best;
  }

  // How many items of every layer of a model that is on are seen in its pane.
  census(layers, width, height) {
    const target = new THREE.WebGLRenderTarget(width, height);
    this.draw(layers, target, width, height);
    const pixels = new Uint8Array(4 * width * height);
    this.renderer.readRenderTargetPixels(target, 0, 0, width, height, pixels);
    target.dispose();
    const seen = {};
    for (let pixel = 0; pixel < width * height; ++pixel) {
      const hit = layers.find(this.numberAt(pixels, pixel));
      if (hit) (seen[hit.layer.name] = seen[hit.layer.name] || new Set()).add(layers.model.itemOf(hit.layer, hit.element));
    }
    for (const name of Object.keys(seen)) seen[name] = seen[name].size;
    return seen;
  }
}
