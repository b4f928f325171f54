// What is said about an element: its number in the document, where it stands there, and its figures.

function numberText(value) {
  if (Number.isInteger(value)) return String(value);
  const size = Math.abs(value);
  return size >= 1e-3 && size < 1e6 ? String(Number(value.toPrecision(5))) : value.toExponential(3);
}

function withUnit(text, unit) { return unit === '°' ? text + unit : `${text} ${unit}`; }

function figureOf(items, name, item) { return items.columns.find((column) => column.name === name).values[item]; }

// Figures of the item stand in braces, or else its number at the end.
function pointerOf(items, item) {
  if (!items.pointer) return '';
  return isNumbered(items) ? items.pointer + item : items.pointer.replace(/{(.*?)}/g, (_, name) => figureOf(items, name, item));
}

// Items that users know by their number.
function isNumbered(items) { return Boolean(items.pointer) && !items.pointer.includes('{'); }

function vertexText(model, vertex) {
  return model.subMeshOfVertex.length ? `${vertex}, in sub-mesh ${model.subMeshOfVertex[vertex]}` : String(vertex);
}

function itemRows(layer, item) {
  return layer.items.columns.filter((column) => !Number.isNaN(column.values[item]))
    .map((column) => [column.name, /^(crosses|on the|transversal|source|sink)/.test(column.name) ? 'yes' : numberText(column.values[item])]);
}

// \param nearest  of a quad's corners, 0 to 3, the one nearest to the pointer, and the second; may be missing
function describe(model, layer, element, nearest) {
  const item = model.itemOf(layer, element);
  const points = model.pointsOf(layer, element);
  const named = Boolean(layer.items.noun) && item !== noItem;
  const rows = named ? itemRows(layer, item) : [];
  // Only numbers that stand in the document are told.
  let title = !named ? '' : isNumbered(layer.items) ? `${layer.items.noun} ${item}` : layer.items.noun;
  if (layer.type === 'faces') {
    const face = model.faceOf(layer, element);
    title = title || `face ${face}`;
    rows.push(['face', String(face)]);
    if (layer.mapped) {
      const mean = points.reduce((sum, point) => sum + layer.mapped.values[point], 0) / 4;
      rows.unshift([`${layer.mapped.quantity} here`, Number.isNaN(mean) ? 'not known' : withUnit(numberText(mean), layer.mapped.unit)]);
    }
    if (layer.base === onMesh && nearest) {
      rows.push(['nearest vertex', vertexText(model, points[nearest[0]])]);
      rows.push(['nearest edge', `${points[nearest[0]]} – ${points[nearest[1]]}`]);
    }
  } else if (layer.base === onMesh) {
    if (layer.type === 'lines') rows.push(['here, edge', `${points[0]} – ${points[1]}`]);
    else rows.push(['vertex', vertexText(model, points[0])]);
  }
  const seen = new Set();
  return { title, pointer: named ? pointerOf(layer.items, item) : '', rows: rows.reverse().filter(([name]) => !seen.has(name) && seen.add(name)).reverse() };
}

function show(box, { title, pointer, rows }) {
  box.textContent = '';
  box.append(element('h2', { textContent: title }));
  if (pointer) box.append(element('code', { textContent: pointer }));
  box.append(element('dl', {}, ...rows.flatMap(([name, value]) => [element('dt', { textContent: name }), element('dd', { textContent: value })])));
}
