// What is said about an element: its number in the document, where it stands there, and its figures.

function numberText(value) {
  if (Number.isInteger(value)) return String(value);
  const size = Math.abs(value);
  return size >= 1e-3 && size < 1e6 ? String(Number(value.toPrecision(5))) : value.toExponential(3);
}

function pointerOf(items, item) {
  return items.pointers ? items.pointers[item] : items.pointer ? items.pointer + item : '';
}

function vertexText(scene, vertex) {
  return scene.subMeshOfVertex.length ? `${vertex}, in sub-mesh ${scene.subMeshOfVertex[vertex]}` : String(vertex);
}

function itemRows(layer, item) {
  return layer.items.columns.filter((column) => !Number.isNaN(column.values[item]))
    .map((column) => [column.name, /^(crosses|on the|transversal)/.test(column.name) ? 'yes' : numberText(column.values[item])]);
}

// \param nearest  of a quad's corners, 0 to 3, the one nearest to the pointer, and the second; may be missing
function describe(scene, layers, layer, element, nearest) {
  const item = layers.itemOf(layer, element);
  const shell = scene.shells[layer.base];
  const points = layers.pointsOf(layer, element);
  const named = layer.items.noun && item !== noItem;
  const rows = named ? itemRows(layer, item) : [];
  // Only numbers that stand in the document are told.
  let title = !named ? '' : layer.items.pointer ? `${layer.items.noun} ${item}` : layer.items.noun;
  if (layer.type === 'faces') {
    const face = shell.faces[element];
    title = title || `face ${face}`;
    rows.push(['face', String(face)]);
    if (layer.values) {
      const mean = points.reduce((sum, point) => sum + layer.values[point], 0) / 4;
      rows.unshift(['deviation here', numberText(mean)]);
    }
    if (layer.base === 0 && nearest) {
      rows.push(['nearest vertex', vertexText(scene, points[nearest[0]])]);
      rows.push(['nearest edge', `${points[nearest[0]]} – ${points[nearest[1]]}`]);
    }
  } else if (layer.base === 0) {
    if (layer.type === 'lines') rows.push(['here, edge', `${points[0]} – ${points[1]}`]);
    else rows.push(['vertex', vertexText(scene, points[0])]);
  }
  const seen = new Set();
  return { title, pointer: named ? pointerOf(layer.items, item) : '', rows: rows.reverse().filter(([name]) => !seen.has(name) && seen.add(name)).reverse() };
}

function show(element, description) {
  element.textContent = '';
  const heading = document.createElement('h2');
  heading.textContent = description.title;
  element.append(heading);
  if (description.pointer) {
    const code = document.createElement('code');
    code.textContent = description.pointer;
    element.append(code);
  }
  const list = document.createElement('dl');
  for (const [name, value] of description.rows) {
    const term = document.createElement('dt'), detail = document.createElement('dd');
    term.textContent = name;
    detail.textContent = value;
    list.append(term, detail);
  }
  element.append(list);
}
