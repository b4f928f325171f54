// From a scene's arrays to what the graphics card draws. Elements are quads, pieces of lines, or points; they are numbered
// from 1 through all layers so that a pixel tells which it is, but all layers of faces share their numbers.

function writeNumber(bytes, at, number) {
  bytes[at] = number & 255;
  bytes[at + 1] = (number >> 8) & 255;
  bytes[at + 2] = (number >> 16) & 255;
}

function attribute(values, size, normalized) { return new THREE.BufferAttribute(values, size, normalized); }
function instanced(values, size, normalized) { return new THREE.InstancedBufferAttribute(values, size, normalized); }

const cornersOfTriangles = [0, 1, 2, 0, 2, 3];

// What all layers on a shell share: two triangles for every quad.
function quadAttributes(shell) {
  if (shell.attributes) return shell.attributes;
  const count = shell.quads.length / 4;
  const positions = new Float32Array(count * 18);
  const normals = shell.normals.length ? new Float32Array(count * 18) : null;
  const elements = new Uint8Array(count * 24);
  for (let quad = 0, at = 0; quad < count; ++quad)
    for (const corner of cornersOfTriangles) {
      const point = 3 * shell.quads[4 * quad + corner];
      for (let k = 0; k < 3; ++k) {
        positions[3 * at + k] = shell.positions[point + k];
        if (normals) normals[3 * at + k] = shell.normals[point + k];
      }
      writeNumber(elements, 4 * at, quad + 1);
      ++at;
    }
  shell.attributes = { position: attribute(positions, 3), element: attribute(elements, 4, true) };
  if (normals) shell.attributes.normal = attribute(normals, 3);
  return shell.attributes;
}

function itemOfQuad(layer, quad) { return layer.groups ? layer.groups[quad] : quad; }

function faceGeometry(layer, shell) {
  const geometry = new THREE.BufferGeometry();
  const shared = quadAttributes(shell);
  for (const name of Object.keys(shared)) geometry.setAttribute(name, shared[name]);
  const count = shell.quads.length / 4;
  const groups = new Float32Array(count * 6);
  const colours = new Uint8Array(count * 24);
  const palette = faceColours.map(bytesOfColour);
  const plain = bytesOfColour(plainFace);
  const between = bytesOfColour(betweenItems);
  for (let quad = 0; quad < count; ++quad) {
    const item = itemOfQuad(layer, quad);
    const colour = !layer.groups ? plain : item === noItem ? between : palette[layer.colours[item]];
    for (let at = 6 * quad; at < 6 * quad + 6; ++at) {
      groups[at] = item === noItem ? -9 : item;
      colours.set(colour, 4 * at);
    }
  }
  geometry.setAttribute('group', attribute(groups, 1));
  geometry.setAttribute('colour', attribute(colours, 4, true));
  if (layer.values) {
    const values = new Float32Array(count * 6);
    for (let quad = 0, at = 0; quad < count; ++quad)
      for (const corner of cornersOfTriangles) values[at++] = layer.values[shell.quads[4 * quad + corner]];
    geometry.setAttribute('value', attribute(values, 1));
  }
  return geometry;
}

// Piece k of a layer of lines runs from points[k] to points[k + 1]; itemOfPiece skips from item to item.
function piecesOf(layer) {
  const pieces = [];
  for (let item = 0; item < layer.items.count; ++item)
    for (let k = layer.starts[item]; k + 1 < layer.starts[item + 1]; ++k) pieces.push(k, item);
  return Uint32Array.from(pieces);
}

function lineGeometry(layer, shell) {
  const geometry = new THREE.InstancedBufferGeometry();
  geometry.setAttribute('position', attribute(new Float32Array([0, -1, 0, 1, -1, 0, 1, 1, 0, 0, -1, 0, 1, 1, 0, 0, 1, 0]), 3));
  const count = layer.pieces.length / 2;
  const starts = new Float32Array(3 * count), ends = new Float32Array(3 * count);
  const groups = new Float32Array(count);
  const elements = new Uint8Array(4 * count);
  for (let piece = 0; piece < count; ++piece) {
    const k = layer.pieces[2 * piece];
    for (let d = 0; d < 3; ++d) {
      starts[3 * piece + d] = shell.positions[3 * layer.points[k] + d];
      ends[3 * piece + d] = shell.positions[3 * layer.points[k + 1] + d];
    }
    groups[piece] = layer.pieces[2 * piece + 1];
    writeNumber(elements, 4 * piece, layer.firstElement + piece);
  }
  geometry.setAttribute('start', instanced(starts, 3));
  geometry.setAttribute('end', instanced(ends, 3));
  geometry.setAttribute('group', instanced(groups, 1));
  geometry.setAttribute('element', instanced(elements, 4, true));
  geometry.maxInstancedCount = count;
  return geometry;
}

function pointGeometry(layer, shell) {
  const geometry = new THREE.BufferGeometry();
  const count = layer.items.count;
  const positions = new Float32Array(3 * count);
  const colours = new Uint8Array(4 * count);
  const elements = new Uint8Array(4 * count);
  for (let item = 0; item < count; ++item) {
    for (let d = 0; d < 3; ++d) positions[3 * item + d] = shell.positions[3 * layer.points[item] + d];
    colours.set(bytesOfColour(pointColour(layer, item)), 4 * item);
    writeNumber(elements, 4 * item, layer.firstElement + item);
  }
  geometry.setAttribute('position', attribute(positions, 3));
  geometry.setAttribute('colour', attribute(colours, 4, true));
  geometry.setAttribute('group', attribute(Float32Array.from({ length: count }, (_, k) => k), 1));
  geometry.setAttribute('element', attribute(elements, 4, true));
  return geometry;
}
