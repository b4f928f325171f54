// What the page holds: JSON with arrays of little-endian numbers in base64.

function bytesOf(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let k = 0; k < binary.length; ++k) bytes[k] = binary.charCodeAt(k);
  return bytes;
}

// Zigzag differences, seven bits a byte.
function fromDifferences(bytes, Numbers) {
  let count = 0;
  for (const byte of bytes) if (byte < 128) ++count;
  const numbers = new Numbers(count);
  let at = 0, number = 0;
  for (let k = 0; k < count; ++k) {
    let rest = 0, place = 1;
    while (bytes[at] > 127) {
      rest += (bytes[at++] & 127) * place;
      place *= 128;
    }
    rest += bytes[at++] * place;
    number += rest % 2 ? -(rest + 1) / 2 : rest / 2;
    numbers[k] = number;
  }
  return numbers;
}

// Arrays become typed arrays wherever they stand.
function revive(value) {
  if (value === null || typeof value !== 'object') return value;
  if (typeof value.float32 === 'string') return new Float32Array(bytesOf(value.float32).buffer);
  if (typeof value.uint32 === 'string') return fromDifferences(bytesOf(value.uint32), Uint32Array);
  if (typeof value.int32 === 'string') return fromDifferences(bytesOf(value.int32), Int32Array);
  if (typeof value.uint16 === 'string') return Float32Array.from(new Uint16Array(bytesOf(value.uint16).buffer), (number) => (number === 65535 ? NaN : number * value.unit));
  for (const key of Object.keys(value)) value[key] = revive(value[key]);
  return value;
}

function readPage() {
  const element = document.getElementById('scene');
  const page = revive(JSON.parse(element.textContent));
  element.remove();
  return page;
}

const noItem = 0xffffffff;
const onMesh = 0, onSurfaces = 1, onNet = 2, onKnots = 3;
