// The layers: what each draws, and whether it is on. Nothing is sent to the graphics card before it is first shown.

function colourUniform(text) { return { value: new THREE.Color(text) }; }

const builders = {
  faces(layer, shell) {
    const material = newMaterial(faceVertex, faceFragment, {
      smoothly: { value: shell.normals.length ? 1 : 0 },
      mapped: { value: layer.values ? 1 : 0 },
      scaleTop: { value: layer.scale || 1 },
      opacity: { value: 1 },
      ramp: { value: rampColours.map((text) => new THREE.Color(text)) },
    });
    return new THREE.Mesh(faceGeometry(layer, shell), material);
  },
  lines(layer, shell) {
    const style = lineStyles[layer.name];
    const material = newMaterial(lineVertex, lineFragment, {
      lineColour: colourUniform(style.colour), width: { value: style.width }, lift: { value: style.lift },
    });
    return new THREE.Mesh(lineGeometry(layer, shell), material);
  },
  points(layer, shell) {
    const style = pointStyles[layer.name];
    const material = newMaterial(pointVertex, pointFragment, { size: { value: style.size }, lift: { value: style.lift } });
    return new THREE.Points(pointGeometry(layer, shell), material);
  },
};

class Layers {
  constructor(scene) {
    this.scene = scene;
    this.root = new THREE.Scene();
    this.all = [];
    let next = 1 + Math.max(...scene.shells.map((shell) => shell.quads.length / 4));
    for (const type of ['faces', 'lines', 'points'])
      for (const layer of scene[type]) {
        layer.type = type;
        layer.on = false;
        if (type === 'lines') layer.pieces = piecesOf(layer);
        layer.firstElement = type === 'faces' ? 1 : next;
        layer.elementCount = type === 'faces' ? scene.shells[layer.base].quads.length / 4
          : type === 'lines' ? layer.pieces.length / 2 : layer.items.count;
        if (type !== 'faces') next += layer.elementCount;
        this.all.push(layer);
      }
    for (const name of scene.shown) this.set(name, true);
  }

  named(name) { return this.all.find((layer) => layer.name === name); }
  get faces() { return this.all.find((layer) => layer.type === 'faces' && layer.on); }

  // Of the layers of faces one is on at a time.
  set(name, on) {
    const layer = this.named(name);
    if (on && layer.type === 'faces')
      for (const other of this.all) if (other.type === 'faces' && other !== layer) this.set(other.name, false);
    layer.on = on;
    if (on && !layer.object) {
      layer.object = builders[layer.type](layer, this.scene.shells[layer.base]);
      layer.object.frustumCulled = false;
      this.root.add(layer.object);
      this.setTransparent(Boolean(this.transparent));
    }
    if (layer.object) layer.object.visible = on;
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

  itemOf(layer, element) {
    return layer.type === 'faces' ? itemOfQuad(layer, element) : layer.type === 'lines' ? layer.pieces[2 * element + 1] : element;
  }

  // The points of an element, in its shell.
  pointsOf(layer, element) {
    const shell = this.scene.shells[layer.base];
    if (layer.type === 'faces') return Array.from(shell.quads.subarray(4 * element, 4 * element + 4));
    if (layer.type === 'points') return [layer.points[element]];
    const k = layer.pieces[2 * element];
    return [layer.points[k], layer.points[k + 1]];
  }

  place(base, point) { return new THREE.Vector3().fromArray(this.scene.shells[base].positions, 3 * point); }
}
