// Pictures of the models, with all that there is or in less detail.

class Pictures {
  constructor(renderer, panes, view) {
    Object.assign(this, { renderer, panes, view });
    this.ratio = renderer.getPixelRatio();
    this.target = new THREE.WebGLRenderTarget(1, 1);
    const vertexShader = 'varying vec2 at; void main() { at = 0.5 + 0.5 * position.xy; gl_Position = vec4(position.xy, 0.0, 1.0); }';
    const fragmentShader = 'uniform sampler2D picture; varying vec2 at; void main() { gl_FragColor = texture2D(picture, at); }';
    const uniforms = { picture: { value: this.target.texture } };
    const copy = new THREE.Mesh(new THREE.PlaneBufferGeometry(2, 2), new THREE.ShaderMaterial({ vertexShader, fragmentShader, uniforms, depthTest: false }));
    copy.frustumCulled = false;
    this.copy = new THREE.Scene().add(copy);
  }

  resize(width, height) {
    Object.assign(this, { width, height });
    this.renderer.setSize(width, height, false);
  }

  // Of every pane, side by side.
  get paneWidth() { return Math.max(1, Math.floor(this.width / this.panes.length)); }

  // With all that there is, and antialiased.
  draw() { this.drawPanes(1, null, undefined); }

  // Makes what a picture in some detail draws, so that it need not be made when that is.
  prepare({ cells }) { for (const { layers } of this.panes) layers.setCells(cells); }

  // In less than all detail not antialiased: that is drawn elsewhere, and copied.
  drawMoving({ share, cells }) {
    if (share === 1) return this.draw();
    this.setShare(share);
    const size = this.renderer.getDrawingBufferSize(new THREE.Vector2());
    this.target.setSize(size.x, size.y);
    this.drawPanes(share, this.target, cells);
    this.renderer.setScissorTest(false);
    this.renderer.setViewport(0, 0, this.width, this.height);
    this.renderer.clear();
    this.renderer.render(this.copy, this.view.camera);
  }

  // The browser enlarges what has fewer pixels than the page.
  setShare(share) {
    if (this.renderer.getPixelRatio() !== share * this.ratio) this.renderer.setPixelRatio(share * this.ratio);
  }

  drawPanes(share, target, cells) {
    this.setShare(share);
    const ratio = this.renderer.getPixelRatio();
    shared.pixelRatio.value = Math.max(ratio, 0.5); // or thin lines would break up
    shared.resolution.value.set(this.paneWidth * ratio, this.height * ratio);
    this.view.prepare();
    this.renderer.setRenderTarget(target);
    this.panes.forEach(({ layers }, k) => {
      this.setPart(target, [k * this.paneWidth, 0, this.paneWidth, this.height], ratio);
      layers.setCells(cells);
      this.renderer.setClearColor(0, 0);
      this.renderer.clear();
      this.renderer.render(layers.root, this.view.camera);
    });
    this.renderer.setRenderTarget(null);
  }

  setPart(target, part, ratio) {
    if (target) {
      const pixels = part.map((length) => Math.round(length * ratio));
      target.viewport.set(...pixels);
      target.scissor.set(...pixels);
      target.scissorTest = true;
      this.renderer.setRenderTarget(target);
    } else {
      this.renderer.setScissorTest(true);
      this.renderer.setViewport(...part);
      this.renderer.setScissor(...part);
    }
  }

  // Milliseconds that a picture takes: what has been asked for is done when a pixel of it can be read.
  timed(draw) {
    const begin = performance.now(), gl = this.renderer.getContext();
    draw();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    return performance.now() - begin;
  }
}
