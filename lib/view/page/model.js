// A scene, ready to be drawn: where points lie, which is computed when it is first asked for, and what layers show.

class Model {
  constructor(scene) {
    Object.assign(this, scene);
    this.fitted = new FittedPatches(scene.patches);
    this.shells = [];
    this.merged = [];
    this.layers = ['faces', 'lines', 'points'].flatMap((type) => scene[type].map((layer) => Object.assign(layer, { type, on: false })));
    for (const layer of this.layers) if (layer.itemsOf) layer.items = this.named(layer.itemsOf).items;
    for (const layer of this.layers) if (layer.base === onNet) layer.items.count = this.fitted.all.length;
  }

  named(name) { return this.layers.find((layer) => layer.name === name); }

  // Points of a base; of meshes and surfaces also quads.
  shell(base) {
    if (this.shells[base]) return this.shells[base];
    const make = [() => this.mesh, () => this.fitted.shell(), () => this.fitted.net(), () => this.fitted.knotLines()];
    return this.shells[base] = make[base]();
  }

  // Of a shell's points those that become one when about so many are left of the mesh.
  firstInCell(base, cells) {
    const known = this.merged[base] = this.merged[base] || [];
    return known[cells] = known[cells] || firstInCell(this.shell(base).positions, cellSide(this.mesh, cells) || this.radius);
  }

  // Fills in what is not in the page but computed.
  prepare(layer) {
    if (layer.prepared) return;
    layer.prepared = true;
    const shell = this.shell(layer.base);
    if (layer.type === 'faces' && layer.base === onSurfaces) layer.groups = shell.groups;
    if (layer.base === onNet || layer.base === onKnots) {
      layer.points = shell.points;
      layer.starts = shell.starts;
      layer.items.count = shell.starts.length - 1;
      layer.items.columns = shell.columns || layer.items.columns;
    }
    if (layer.type === 'lines' && !layer.starts) {
      const each = layer.points.length / Math.max(layer.items.count, 1);
      layer.starts = Uint32Array.from({ length: layer.items.count + 1 }, (_, k) => k * each);
    }
    if (layer.type === 'lines') layer.pieces = piecesOf(layer);
    if (layer.mapped) layer.mapped.values = this.valuesOf(layer, shell);
  }

  valuesOf(layer, shell) {
    const { values, source } = layer.mapped;
    if (values) return values;
    if (layer.type === 'lines') return (layer.items.columns.find((column) => column.name === source) || { values: new Float32Array() }).values;
    return { 'mean curvature': shell.mean, 'Gauss curvature': shell.gauss }[source] || this.named(source).mapped.values;
  }

  elementCount(layer) {
    if (layer.type === 'faces') return this.shell(layer.base).quads.length / 4;
    return layer.type === 'lines' ? layer.pieces.length / 2 : layer.items.count;
  }

  itemOf(layer, element) {
    if (layer.type === 'faces') return layer.groups ? layer.groups[element] : element;
    return layer.type === 'lines' ? layer.pieces[2 * element + 1] : element;
  }

  // The points of an element, in its shell.
  pointsOf(layer, element) {
    if (layer.type === 'faces') return Array.from(this.shell(layer.base).quads.subarray(4 * element, 4 * element + 4));
    if (layer.type === 'points') return [layer.points[element]];
    const k = layer.pieces[2 * element];
    return [layer.points[k], layer.points[k + 1]];
  }

  faceOf(layer, element) { return layer.base === onMesh ? element : this.shell(layer.base).faces[element]; }

  place(base, point) { return new THREE.Vector3().fromArray(this.shell(base).positions, 3 * point); }
}

// Piece k of a layer of lines runs from points[k] to points[k + 1]: pairs of k and the item it belongs to.
function piecesOf(layer) {
  const pieces = new Uint32Array(2 * Math.max(0, layer.points.length - layer.items.count));
  let at = 0;
  for (let item = 0; item < layer.items.count; ++item)
    for (let k = layer.starts[item]; k + 1 < layer.starts[item + 1]; ++k, at += 2) pieces.set([k, item], at);
  return pieces.subarray(0, at);
}
