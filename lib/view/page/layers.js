// The layers of a model: what each draws, and whether it is on. Nothing is computed or sent to the graphics card
// before it is first shown.

function colourUniform(text) { return { value: new THREE.Color(text) }; }

const builders = {
  faces(layer, shell) {
    const material = newMaterial(faceVertex, faceFragment, Object.assign(scaleUniforms(layer.mapped), {
      smoothly: { value: isSmooth(layer) ? 1 : 0 },
      paint: { value: { mapped: 1, stripes: 2 }[layer.paint] || 0 },
      backColour: colourUniform(backColour),
      opacity: { value: 1 },
    }));
    return new THREE.Mesh(faceGeometry(layer, shell), material);
  },
  lines(layer, shell) {
    const style = lineStyles[layer.name];
    const material = newMaterial(lineVertex, lineFragment, Object.assign(scaleUniforms(layer.mapped), {
      lineColour: colourUniform(style.colour), width: { value: widthOf(layer) }, lift: { value: style.lift },
      paint: { value: layer.mapped ? 1 : 0 },
    }));
    return new THREE.Mesh(lineGeometry(layer, shell), material);
  },
  points(layer, shell) {
    const style = pointStyles[layer.name];
    const material = newMaterial(pointVertex, pointFragment, { size: { value: style.size }, lift: { value: style.lift } });
    return new THREE.Points(pointGeometry(layer, shell), material);
  },
};

class Layers {
  constructor(model) {
    this.model = model;
    this.all = model.layers;
    this.root = new THREE.Scene();
    this.next = 1;
  }

  named(name) { return this.model.named(name); }
  get faces() { return this.all.find((layer) => layer.type === 'faces' && layer.on); }
  get mapped() { return this.all.filter((layer) => layer.on && layer.mapped); }

  // Of the layers of faces one is on at a time. A layer that the model does not have is not shown.
  set(name, on) {
    const layer = this.named(name);
    if (!layer) return;
    if (on && layer.type === 'faces')
      for (const other of this.all) if (other.type === 'faces' && other !== layer) this.set(other.name, false);
    layer.on = on;
    if (on && !layer.object) this.build(layer);
    if (layer.object) layer.object.visible = on;
  }

  build(layer) {
    if (layer.mapped && layer.mapped.source && layer.type === 'faces' && this.named(layer.mapped.source)) this.model.prepare(this.named(layer.mapped.source));
    this.model.prepare(layer);
    layer.elementCount = this.model.elementCount(layer);
    // Layers of faces share their numbers, as one of them is seen at a time.
    layer.firstElement = layer.type === 'faces' ? 1 : this.numbersFor(layer.elementCount);
    layer.object = builders[layer.type](layer, this.model.shell(layer.base));
    layer.object.frustumCulled = false;
    layer.geometries = [layer.object.geometry];
    this.root.add(layer.object);
    this.setTransparent(Boolean(this.transparent));
  }

  // Draws what is on coarsely, or with all that there is if `cells` is not given.
  setCells(cells) {
    for (const layer of this.all) if (layer.on && layer.object) layer.object.geometry = this.geometryOf(layer, cells);
  }

  geometryOf(layer, cells) {
    const all = layer.geometries[0];
    if (!cells || all.attributes.position.count < 12 * cells) return all; // about twice as many as would be left
    const shell = this.model.shell(layer.base);
    return layer.geometries[cells] = layer.geometries[cells] || coarseGeometry(layer, shell, all, this.model.firstInCell(layer.base, cells));
  }

  numbersFor(count) {
    const faces = this.model.mesh.quads.length / 4 + this.model.fitted.faces.length * this.model.fitted.steps ** 2;
    const first = 1 + faces + this.next;
    this.next += count;
    return first;
  }

  setTransparent(on) {
    this.transparent = on;
    for (const layer of this.all) {
      if (layer.type !== 'faces' || !layer.object) continue;
      layer.object.material.transparent = on;
      layer.object.material.depthWrite = !on;
      layer.object.material.uniforms.opacity.value = on ? 0.35 : 1;
      layer.object.renderOrder = on ? -1 : 0;
    }
  }

  // Black lines are drawn light where nothing but a dark page is behind them.
  setInk(dark) {
    for (const layer of this.all)
      if (layer.type === 'lines' && layer.object && lineStyles[layer.name].colour === ink)
        layer.object.material.uniforms.lineColour.value.set(dark && !this.faces ? lightInk : ink);
  }

  setScale(layer, top) { layer.object.material.uniforms.scaleTop.value = top; }

  highlight(layer, item) {
    for (const other of this.all)
      if (other.object) other.object.material.uniforms.highlighted.value = other === layer ? item : -1;
  }

  // The layer and its element that have a number among those that are on.
  find(number) {
    if (number === 0) return null;
    for (const layer of this.all)
      if (layer.on && number >= layer.firstElement && number < layer.firstElement + layer.elementCount)
        return { layer, element: number - layer.firstElement };
    return null;
  }
}
