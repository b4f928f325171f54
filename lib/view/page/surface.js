// B-spline patches, evaluated: points, normals and curvatures on a lattice.

// The functions of a degree that do not vanish in the knot interval `span`, or a derivative of theirs, at t.
function basis(knots, degree, span, t, order) {
  if (degree === 0) return [order === 0 ? 1 : 0];
  const lower = basis(knots, degree - 1, span, t, order === 0 ? 0 : order - 1);
  const result = new Array(degree + 1).fill(0);
  for (let k = 0; k < degree; ++k) { // lower[k] is function span - degree + 1 + k of the degree below
    const first = knots[span - degree + 1 + k], width = knots[span + 1 + k] - first;
    if (!(width > 0)) continue;
    if (order > 0) {
      result[k] -= degree * lower[k] / width;
      result[k + 1] += degree * lower[k] / width;
    } else {
      result[k] += (first + width - t) / width * lower[k];
      result[k + 1] += (t - first) / width * lower[k];
    }
  }
  return result;
}

// Values, first and second derivatives at every parameter.
function basisTable(knots, degree, parameters) {
  const last = knots.length - degree - 2;
  let span = degree;
  return parameters.map((t) => {
    while (span < last && knots[span + 1] <= t) ++span;
    while (span > degree && knots[span] === knots[span + 1]) --span;
    return { first: span - degree, of: [0, 1, 2].map((order) => basis(knots, degree, span, t, order)) };
  });
}

// All that a surface has at the lattice (us[i], vs[j]), for every order of derivation by u and v up to `order` in sum:
// coordinates at 3 * (j * us.length + i).
function evaluateLattice(patch, us, vs, order) {
  const tables = [basisTable(patch.knots[0], patch.degree[0], us), basisTable(patch.knots[1], patch.degree[1], vs)];
  const width = patch.count[0];
  const orders = [];
  for (let v = 0; v <= order; ++v) for (let u = 0; u + v <= order; ++u) orders.push([u, v, new Float64Array(3 * us.length * vs.length)]);
  const row = [0, 1, 2].map(() => new Float64Array(3 * width));
  tables[1].forEach((across, j) => {
    for (let d = 0; d <= order; ++d) {
      row[d].fill(0);
      across.of[d].forEach((weight, k) => {
        const begin = 3 * (across.first + k) * width;
        for (let c = 0; c < 3 * width; ++c) row[d][c] += weight * patch.points[begin + c];
      });
    }
    for (const [u, v, result] of orders)
      tables[0].forEach((along, i) => {
        const at = 3 * (j * us.length + i);
        const weights = along.of[u], from = row[v];
        for (let k = 0; k < weights.length; ++k) {
          const place = 3 * (along.first + k), weight = weights[k];
          result[at] += weight * from[place];
          result[at + 1] += weight * from[place + 1];
          result[at + 2] += weight * from[place + 2];
        }
      });
  });
  return (u, v) => orders.find(([a, b]) => a === u && b === v)[2];
}

function cross(a, b, i, result) {
  result[0] = a[i + 1] * b[i + 2] - a[i + 2] * b[i + 1];
  result[1] = a[i + 2] * b[i] - a[i] * b[i + 2];
  result[2] = a[i] * b[i + 1] - a[i + 1] * b[i];
}

function dot(a, i, b, j) { return a[i] * b[j] + a[i + 1] * b[j + 1] + a[i + 2] * b[j + 2]; }

// Multiples of a step up to the end of the domain, which begins at 0.
function latticeParameters(knots, degree, steps) {
  const count = Math.round(knots[knots.length - degree - 1] * steps);
  return Array.from({ length: count + 1 }, (_, k) => k / steps);
}

// The different knots inside a patch.
function innerKnots(knots, degree) {
  const begin = knots[degree], end = knots[knots.length - degree - 1], slack = 1e-9 * (end - begin);
  return knots.filter((knot, k) => knot > begin + slack && knot < end - slack && knot > knots[k - 1] + slack);
}

class FittedPatches {
  constructor(packed) {
    this.steps = packed.steps;
    this.faces = packed.faces;
    let first = 0;
    this.all = packed.counts.map((count, k) => {
      const size = 3 * count[0] * count[1];
      const patch = { count, degree: packed.degrees[k], knots: packed.knots[k], points: packed.controlPoints.subarray(first, first + size) };
      first += size;
      patch.lattice = [0, 1].map((d) => latticeParameters(patch.knots[d], patch.degree[d], this.steps));
      return patch;
    });
    this.controlPoints = packed.controlPoints;
  }

  // The lattice of all patches as a shell, with the patch and the mesh face of every quad.
  shell() {
    const { steps } = this;
    const cells = (patch, d) => patch.lattice[d].length - 1;
    const points = this.all.reduce((sum, patch) => sum + patch.lattice[0].length * patch.lattice[1].length, 0);
    const quads = this.all.reduce((sum, patch) => sum + cells(patch, 0) * cells(patch, 1), 0);
    const shell = { positions: new Float32Array(3 * points), normals: new Float32Array(3 * points),
      mean: new Float32Array(points), gauss: new Float32Array(points),
      quads: new Uint32Array(4 * quads), faces: new Uint32Array(quads), groups: new Uint32Array(quads) };
    let point = 0, quad = 0, face = 0;
    this.all.forEach((patch, number) => {
      this.writePoints(patch, shell, point);
      const width = patch.lattice[0].length, columns = cells(patch, 0) / steps;
      for (let j = 0; j < cells(patch, 1); ++j)
        for (let i = 0; i < cells(patch, 0); ++i, ++quad) {
          const corner = point + j * width + i;
          shell.quads.set([corner, corner + 1, corner + width + 1, corner + width], 4 * quad);
          shell.faces[quad] = this.faces[face + Math.floor(j / steps) * columns + Math.floor(i / steps)];
          shell.groups[quad] = number;
        }
      point += width * patch.lattice[1].length;
      face += columns * cells(patch, 1) / steps;
    });
    return shell;
  }

  writePoints(patch, shell, first) {
    const at = evaluateLattice(patch, patch.lattice[0], patch.lattice[1], 2);
    const position = at(0, 0), du = at(1, 0), dv = at(0, 1), duu = at(2, 0), duv = at(1, 1), dvv = at(0, 2);
    shell.positions.set(position, 3 * first);
    const normal = [0, 0, 0];
    for (let i = 0, to = first; i < position.length; i += 3, ++to) {
      cross(du, dv, i, normal);
      const length = Math.hypot(...normal);
      if (!(length > 0)) continue; // where a patch is degenerate the normal stays 0
      for (let k = 0; k < 3; ++k) normal[k] /= length;
      shell.normals.set(normal, 3 * to);
      const E = dot(du, i, du, i), F = dot(du, i, dv, i), G = dot(dv, i, dv, i);
      const L = dot(duu, i, normal, 0), M = dot(duv, i, normal, 0), N = dot(dvv, i, normal, 0);
      const area = E * G - F * F;
      // A sphere whose normals point outwards is convex, which counts as positive.
      shell.mean[to] = -(E * N - 2 * F * M + G * L) / (2 * area);
      shell.gauss[to] = (L * N - M * M) / area;
    }
  }

  // Every control net as one line that runs along every row and comes back along every column.
  net() {
    const points = [], starts = [0];
    let first = 0;
    for (const { count: [columns, rows] } of this.all) {
      for (let j = 0; j < rows; ++j)
        for (let i = 0; i < columns; ++i) points.push(first + j * columns + (j % 2 ? columns - 1 - i : i));
      const right = rows % 2 === 1;
      for (let i = 0; i < columns; ++i)
        for (let j = 0; j < rows; ++j) points.push(first + (i % 2 ? j : rows - 1 - j) * columns + (right ? columns - 1 - i : i));
      starts.push(points.length);
      first += columns * rows;
    }
    return { positions: this.controlPoints, points: Uint32Array.from(points), starts: Uint32Array.from(starts) };
  }

  // The lines inside of patches at which their polynomials meet.
  knotLines() {
    const positions = [], points = [], starts = [0], ofPatch = [], ofKnot = [];
    this.all.forEach((patch, number) => {
      for (const d of [0, 1])
        for (const knot of innerKnots(patch.knots[d], patch.degree[d])) {
          const along = patch.lattice[1 - d];
          const line = d === 0 ? evaluateLattice(patch, [knot], along, 0)(0, 0) : evaluateLattice(patch, along, [knot], 0)(0, 0);
          for (let k = 0; k < line.length; k += 3) points.push(positions.length / 3 + k / 3);
          for (const coordinate of line) positions.push(coordinate);
          starts.push(points.length);
          ofPatch.push(number);
          ofKnot.push(knot);
        }
    });
    return { positions: Float32Array.from(positions), points: Uint32Array.from(points), starts: Uint32Array.from(starts),
      columns: [{ name: 'of patch', values: ofPatch }, { name: 'at the parameter', values: ofKnot }] };
  }
}
