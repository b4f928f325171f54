// From figures to colours: how far a scale goes, and how the figures are spread over it.

function sortedSizes(values) {
  // Some thousands say as much as all.
  const step = Math.max(1, Math.floor(values.length / 20000)), sizes = [];
  for (let k = 0; k < values.length; k += step) if (Number.isFinite(values[k])) sizes.push(Math.abs(values[k]));
  return Float64Array.from(sizes).sort();
}

function largestSize(values) {
  let largest = 0;
  for (const value of values) if (Math.abs(value) > largest && Number.isFinite(value)) largest = Math.abs(value);
  return largest;
}

// 1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6 or 8 times a power of ten, not below the value.
function roundUp(value) {
  if (!(value > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  return power * ([1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8].find((digit) => digit * power >= value * (1 - 1e-9)) || 10);
}

// All but the largest of the sizes are below.
function quantile(sizes, share) { return sizes.length ? sizes[Math.floor(share * (sizes.length - 1))] : 0; }

// Ends of the scale that can be chosen. One outlier moves only the last.
// \param radius  of the model
function scaleTops(mapped, radius) {
  const { scale, values, limit } = mapped;
  if (scale === 'verdict') return { limit: 1.25 * limit };
  const sizes = sortedSizes(values), largest = largestSize(values);
  if (scale === 'centred') return { usual: usualCurvature(mapped, sizes, radius), maximum: largest || 1 };
  const usual = quantile(sizes, 0.99);
  const tops = { usual: roundUp(usual > 1e-3 * largest ? usual : largest), maximum: largest || 1 };
  if (limit > 0) {
    tops.limit = limit;
    // The limit is what figures are to be seen against, unless they are far beyond or far below it; rounding
    // errors are not made to look like figures.
    if (largest < 1e-3 * limit || usual <= limit && limit < 20 * usual) tops.usual = limit;
  }
  return tops;
}

// Planes take no part in what is usual, or a few bends among many would be off the scale.
function usualCurvature({ source }, sizes, radius) {
  const plane = 1e-3 / radius ** (source === 'Gauss curvature' ? 2 : 1);
  return roundUp(Math.max(plane, quantile(sizes.filter((size) => size > plane), 0.95)));
}

const bins = 48;

// How many figures lie in each part of the scale; the last counts those beyond it.
function histogram(mapped, top) {
  const counts = new Array(bins).fill(0);
  let beyond = 0, all = 0;
  const low = mapped.scale === 'centred' ? -top : 0;
  for (const value of mapped.values) {
    if (!Number.isFinite(value)) continue;
    ++all;
    const size = mapped.scale === 'centred' ? Math.abs(value) : value;
    if (size > top) ++beyond;
    else ++counts[Math.min(bins - 1, Math.floor((value - low) / (top - low) * bins))];
  }
  return { counts, beyond, all };
}

function scaleKind(mapped) { return ['rising', 'centred', 'verdict'].indexOf(mapped.scale); }
