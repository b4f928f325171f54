// From a scene's arrays to what the graphics card draws. Elements are quads, pieces of lines, or points; they are numbered
// from 1 through all layers so that a pixel tells which it is, but all layers of faces share their numbers.

function writeNumber(bytes, at, number) {
  bytes[at] = number & 255;
  bytes[at + 1] = (number >> 8) & 255;
  bytes[at + 2] = (number >> 16) & 255;
}

function attribute(values, size, normalized) { return new THREE.BufferAttribute(values, size, normalized); }

const cornersOfTriangles = [0, 1, 2, 0, 2, 3];

// Where there is no figure; other figures are smaller.
const noValue = 1e30;

// The unit normal of every quad.
function quadNormals(shell) {
  const { positions, quads } = shell, count = quads.length / 4;
  const normals = new Float32Array(3 * count);
  for (let quad = 0; quad < count; ++quad) {
    const [a, b, c, d] = [0, 1, 2, 3].map((corner) => 3 * quads[4 * quad + corner]);
    const side = (k) => positions[c + k] - positions[a + k], other = (k) => positions[d + k] - positions[b + k];
    const normal = [side(1) * other(2) - side(2) * other(1), side(2) * other(0) - side(0) * other(2), side(0) * other(1) - side(1) * other(0)];
    const length = Math.hypot(...normal) || 1;
    for (let k = 0; k < 3; ++k) normals[3 * quad + k] = normal[k] / length;
  }
  return normals;
}

// At every corner of every quad: the mean of the normals of the quads around, but not across sharp edges.
function cornerNormals(shell) {
  if (shell.cornerNormals) return shell.cornerNormals;
  const { quads } = shell, normals = quadNormals(shell), minCosine = Math.cos(0.45);
  const starts = new Uint32Array(shell.positions.length / 3 + 1);
  for (const point of quads) ++starts[point + 1];
  for (let k = 1; k < starts.length; ++k) starts[k] += starts[k - 1];
  const around = new Uint32Array(quads.length), filled = starts.slice();
  for (let k = 0; k < quads.length; ++k) around[filled[quads[k]]++] = k >> 2;
  const result = new Float32Array(3 * quads.length);
  for (let k = 0; k < quads.length; ++k) {
    const own = 3 * (k >> 2);
    for (let at = starts[quads[k]]; at < starts[quads[k] + 1]; ++at) {
      const other = 3 * around[at];
      if (dot(normals, own, normals, other) < minCosine) continue;
      for (let d = 0; d < 3; ++d) result[3 * k + d] += normals[other + d];
    }
  }
  return shell.cornerNormals = result;
}

// What all layers on a shell share: two triangles for every quad.
function quadAttributes(shell) {
  if (shell.attributes) return shell.attributes;
  const count = shell.quads.length / 4;
  const positions = new Float32Array(count * 18);
  const elements = new Uint8Array(count * 24);
  for (let quad = 0, at = 0; quad < count; ++quad)
    for (const corner of cornersOfTriangles) {
      const point = 3 * shell.quads[4 * quad + corner];
      for (let k = 0; k < 3; ++k) positions[3 * at + k] = shell.positions[point + k];
      writeNumber(elements, 4 * at, quad + 1);
      ++at;
    }
  return shell.attributes = { position: attribute(positions, 3), element: attribute(elements, 4, true) };
}

function normalAttribute(shell) {
  if (shell.normalAttribute) return shell.normalAttribute;
  const corners = shell.normals ? null : cornerNormals(shell);
  const count = shell.quads.length / 4, normals = new Float32Array(count * 18);
  for (let quad = 0, at = 0; quad < count; ++quad)
    for (const corner of cornersOfTriangles) {
      const from = 3 * (corners ? 4 * quad + corner : shell.quads[4 * quad + corner]);
      for (let k = 0; k < 3; ++k) normals[at++] = (corners || shell.normals)[from + k];
    }
  return shell.normalAttribute = attribute(normals, 3);
}

// Surfaces are shaded as the smooth surfaces that they are; of a mesh only the stripes are smooth.
function isSmooth(layer) { return layer.base === onSurfaces || layer.paint === 'stripes'; }

function faceGeometry(layer, shell) {
  const geometry = new THREE.BufferGeometry();
  const attributes = quadAttributes(shell);
  for (const name of Object.keys(attributes)) geometry.setAttribute(name, attributes[name]);
  if (isSmooth(layer)) geometry.setAttribute('normal', normalAttribute(shell));
  const count = shell.quads.length / 4;
  const groups = new Float32Array(count * 6);
  const colours = new Uint8Array(count * 24);
  const palette = faceColours.map(bytesOfColour);
  const plain = bytesOfColour(plainFace);
  const between = bytesOfColour(betweenItems);
  for (let quad = 0; quad < count; ++quad) {
    const item = layer.groups ? layer.groups[quad] : quad;
    const colour = layer.paint !== 'items' ? plain : item === noItem ? between : palette[layer.colours[item]];
    for (let at = 6 * quad; at < 6 * quad + 6; ++at) {
      groups[at] = item === noItem ? -9 : item;
      colours.set(colour, 4 * at);
    }
  }
  geometry.setAttribute('group', attribute(groups, 1));
  geometry.setAttribute('colour', attribute(colours, 4, true));
  if (layer.mapped) {
    const values = new Float32Array(count * 6);
    for (let quad = 0, at = 0; quad < count; ++quad) {
      const corners = shell.quads.subarray(4 * quad, 4 * quad + 4);
      const known = corners.every((corner) => !Number.isNaN(layer.mapped.values[corner]));
      for (const corner of cornersOfTriangles) values[at++] = known ? layer.mapped.values[corners[corner]] : noValue;
    }
    geometry.setAttribute('value', attribute(values, 1));
  }
  return geometry;
}

// A rectangle on the screen for every piece, whose corners say at which end and on which side of the line they are. No
// instances: without a graphics card each costs as much as hundreds of vertices.
const cornersOfPieces = [[0, -1, 0], [1, -1, 0], [1, 1, 0], [0, 1, 0]];

function lineGeometry(layer, shell) {
  const geometry = new THREE.BufferGeometry(), count = layer.pieces.length / 2;
  const corners = new Float32Array(12 * count), starts = new Float32Array(12 * count), ends = new Float32Array(12 * count);
  const groups = new Float32Array(4 * count), values = new Float32Array(4 * count);
  const elements = new Uint8Array(16 * count), index = new Uint32Array(6 * count);
  for (let piece = 0; piece < count; ++piece) {
    const k = layer.pieces[2 * piece], item = layer.pieces[2 * piece + 1];
    const [start, end] = [k, k + 1].map((at) => shell.positions.subarray(3 * layer.points[at], 3 * layer.points[at] + 3));
    for (let at = 4 * piece; at < 4 * piece + 4; ++at) {
      corners.set(cornersOfPieces[at - 4 * piece], 3 * at);
      starts.set(start, 3 * at);
      ends.set(end, 3 * at);
      groups[at] = item;
      if (layer.mapped) values[at] = layer.mapped.values[item];
      writeNumber(elements, 4 * at, layer.firstElement + piece);
    }
    for (let corner = 0; corner < 6; ++corner) index[6 * piece + corner] = 4 * piece + cornersOfTriangles[corner];
  }
  geometry.setIndex(attribute(index, 1));
  geometry.setAttribute('position', attribute(corners, 3));
  geometry.setAttribute('start', attribute(starts, 3));
  geometry.setAttribute('end', attribute(ends, 3));
  geometry.setAttribute('group', attribute(groups, 1));
  geometry.setAttribute('value', attribute(values, 1));
  geometry.setAttribute('element', attribute(elements, 4, true));
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
