// What layers look like. The colours are told apart whatever one's colour vision: lines after Okabe and Ito, faces
// and the colour map after Tol.

const ink = '#1b1f23', lightInk = '#dfe4e9';

const lineStyles = {
  edges: { colour: '#7d868f', width: 1, lift: 1 },
  separatrices: { colour: '#2f8fd0', width: 1.8, lift: 2 },
  net: { colour: '#009e73', width: 1.2, lift: 2 },
  knots: { colour: '#7a3e9d', width: 1.3, lift: 2 },
  jumps: { colour: '#cc4c02', width: 5, lift: 4 },
  curves: { colour: ink, width: 2.2, lift: 3 },
  borders: { colour: ink, width: 2.4, lift: 3 },
  tracks: { colour: '#0072b2', width: 3, lift: 4 },
  graphs: { colour: ink, width: 2.8, lift: 4 },
  cuts: { colour: '#cc79a7', width: 4, lift: 5 },
  features: { colour: '#d55e00', width: 4, lift: 6 },
};

// Many lines are thinner, or nothing else would be seen.
function widthOf(layer) { return lineStyles[layer.name].width * (layer.items.count > 2000 && layer.name !== 'edges' ? 0.55 : 1); }

const pointStyles = {
  extraordinary: { colour: '#d55e00', size: 10, lift: 8 },
  seeds: { colour: '#f0e442', size: 13, lift: 9 },
  terminals: { colour: '#cc79a7', size: 15, lift: 7 },
};

// An extraordinary vertex shows by its colour whether it has fewer edges than a regular one, or more.
const fewerEdges = '#0072b2';
function pointColour(layer, item) {
  if (layer.name !== 'extraordinary') return pointStyles[layer.name].colour;
  const regular = Number.isNaN(figureOf(layer.items, 'on the boundary', item)) ? 4 : 3;
  return figureOf(layer.items, 'edges', item) < regular ? fewerEdges : pointStyles.extraordinary.colour;
}

const faceColours = ['#92bbe4', '#f2e4a0', '#f2a58b', '#6fcab0', '#ffbfcc', '#b0e3ff', '#cbd860', '#cdbfe8'];
const plainFace = '#d9dee3';
const betweenItems = '#c3c9cf';
const unknownColour = '#8d979f';
const backColour = '#8c6d7f';
const highlightColour = '#d6006e';

// Scales: rising and centred ones after Tol; a verdict is told apart by lightness too. The last colour is beyond.
const ramps = {
  rising: ['#ffffe5', '#fff7bc', '#fee391', '#fec44f', '#fb9a29', '#ec7014', '#cc4c02', '#993404', '#662506'],
  centred: ['#2166ac', '#4393c3', '#92c5de', '#d1e5f0', '#f7f7f7', '#fddbc7', '#f4a582', '#d6604d', '#b2182b'],
  verdict: ['#c8e7d8', '#c8e7d8', '#c8e7d8', '#c8e7d8', '#5aae8a', '#5aae8a', '#5aae8a', '#d55e00', '#d55e00'],
};
const beyondColours = { rising: '#9b1fb0', centred: '#4d1a66', verdict: '#d55e00' };

function bytesOfColour(text) {
  const number = parseInt(text.slice(1), 16);
  return [number >> 16, (number >> 8) & 255, number & 255];
}

// A scale as a background of CSS.
function gradient(scale) {
  if (scale === 'verdict') return `linear-gradient(90deg, ${ramps.verdict[0]} 0 40%, ${ramps.verdict[4]} 40% 80%, ${beyondColours.verdict} 80%)`;
  return `linear-gradient(90deg, ${ramps[scale].join()})`;
}
