// What layers look like. The colours are told apart whatever one's colour vision: lines after Okabe and Ito, faces
// and the colour map after Tol.

const lineStyles = {
  edges: { colour: '#7d868f', width: 1, lift: 1 },
  separatrices: { colour: '#2f8fd0', width: 1.8, lift: 2 },
  net: { colour: '#009e73', width: 1.2, lift: 2 },
  curves: { colour: '#1b1f23', width: 2.2, lift: 3 },
  borders: { colour: '#1b1f23', width: 2.4, lift: 3 },
  tracks: { colour: '#0072b2', width: 3, lift: 4 },
  graphs: { colour: '#1b1f23', width: 2.8, lift: 4 },
  cuts: { colour: '#cc79a7', width: 4, lift: 5 },
  features: { colour: '#d55e00', width: 4, lift: 6 },
};

const pointStyles = {
  extraordinary: { colour: '#d55e00', size: 10, lift: 8 },
  seeds: { colour: '#f0e442', size: 13, lift: 9 },
  terminals: { colour: '#cc79a7', size: 15, lift: 7 },
};

// An extraordinary vertex shows by its colour whether it has fewer edges than a regular one, or more.
const fewerEdges = '#0072b2';
function pointColour(layer, item) {
  if (layer.name !== 'extraordinary') return pointStyles[layer.name].colour;
  const of = (name) => layer.items.columns.find((column) => column.name === name).values[item];
  const regular = Number.isNaN(of('on the boundary')) ? 4 : 3;
  return of('edges') < regular ? fewerEdges : pointStyles.extraordinary.colour;
}

const faceColours = ['#92bbe4', '#f2e4a0', '#f2a58b', '#6fcab0', '#ffbfcc', '#b0e3ff', '#cbd860', '#cdbfe8'];
const plainFace = '#e4e7ea';
const betweenItems = '#d4d8dc';
const highlightColour = '#d6006e';

const rampColours = ['#ffffe5', '#fff7bc', '#fee391', '#fec44f', '#fb9a29', '#ec7014', '#cc4c02', '#993404', '#662506'];

function bytesOfColour(text) {
  const number = parseInt(text.slice(1), 16);
  return [number >> 16, (number >> 8) & 255, number & 255];
}
