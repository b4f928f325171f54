// Coarser versions of what is drawn, for pictures that have to be quick: all points in a cell of a grid become one.

// A side of cells of which about so many lie on the mesh.
function cellSide({ positions, quads }, cells) {
  let area = 0;
  const at = (point, k) => positions[3 * point + k];
  for (let quad = 0; quad < quads.length; quad += 4) {
    const [a, b, c, d] = quads.subarray(quad, quad + 4);
    const one = [0, 1, 2].map((k) => at(c, k) - at(a, k)), other = [0, 1, 2].map((k) => at(d, k) - at(b, k));
    area += Math.hypot(one[1] * other[2] - one[2] * other[1], one[2] * other[0] - one[0] * other[2], one[0] * other[1] - one[1] * other[0]) / 2;
  }
  return Math.sqrt(area / cells);
}

// For every point the first that lies in the same cell.
function firstInCell(positions, side) {
  const low = [0, 1, 2].map((k) => {
    let min = Infinity;
    for (let at = k; at < positions.length; at += 3) if (positions[at] < min) min = positions[at];
    return min;
  });
  const across = 2 ** 17; // three such numbers are told apart in a double
  const cell = (at, k) => Math.min(across - 1, Math.floor((positions[at + k] - low[k]) / side));
  const firsts = new Map(), result = new Uint32Array(positions.length / 3);
  for (let point = 0; point < result.length; ++point) {
    const number = (cell(3 * point, 0) * across + cell(3 * point, 1)) * across + cell(3 * point, 2);
    if (!firsts.has(number)) firsts.set(number, point);
    result[point] = firsts.get(number);
  }
  return result;
}

// Triangles, pieces of lines, or points: how many vertices each has in a geometry, and which points of the shell it joins.
const primitives = {
  faces: { vertices: 3, points: (layer, shell, k) => [0, 1, 2].map((corner) => shell.quads[4 * (k >> 1) + cornersOfTriangles[3 * (k & 1) + corner]]) },
  lines: { vertices: 4, points: (layer, shell, k) => [layer.points[layer.pieces[2 * k]], layer.points[layer.pieces[2 * k] + 1]] },
  points: { vertices: 1, points: (layer, shell, k) => [layer.points[k]] },
};

// Those that are left when points have become one: none that has lost a side, and of lines and points none twice.
function keptPrimitives(layer, shell, geometry, first) {
  const { vertices, points } = primitives[layer.type];
  const kept = [], joined = [], seen = new Set(), count = geometry.attributes.position.count / vertices;
  for (let k = 0; k < count; ++k) {
    const ends = points(layer, shell, k).map((point) => first[point]);
    if (new Set(ends).size < ends.length) continue;
    if (layer.type !== 'faces') {
      const name = Math.min(...ends) * first.length + Math.max(...ends);
      if (seen.has(name)) continue;
      seen.add(name);
    }
    kept.push(k);
    joined.push(ends);
  }
  return { kept, joined };
}

// The vertices of some primitives, in order.
function pickedAttribute({ array, itemSize, normalized }, kept, vertices) {
  const each = itemSize * vertices, result = new array.constructor(each * kept.length);
  kept.forEach((k, to) => result.set(array.subarray(each * k, each * (k + 1)), each * to));
  return attribute(result, itemSize, normalized);
}

function coarseGeometry(layer, shell, geometry, first) {
  const { vertices } = primitives[layer.type], { kept, joined } = keptPrimitives(layer, shell, geometry, first);
  const result = new THREE.BufferGeometry();
  for (const name of Object.keys(geometry.attributes)) result.setAttribute(name, pickedAttribute(geometry.attributes[name], kept, vertices));
  if (geometry.index) result.setIndex(attribute(geometry.index.array.slice(0, 6 * kept.length), 1));
  const place = (name, vertex, point) => result.attributes[name].array.set(shell.positions.subarray(3 * point, 3 * point + 3), 3 * vertex);
  joined.forEach((ends, k) => {
    for (let vertex = 0; vertex < vertices; ++vertex) {
      if (layer.type === 'faces') place('position', vertices * k + vertex, ends[vertex]);
      if (layer.type === 'lines') ['start', 'end'].forEach((name, end) => place(name, vertices * k + vertex, ends[end]));
    }
  });
  return result;
}
