// The scene that the page holds: JSON with arrays of little-endian numbers in base64.

function bytesOf(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let k = 0; k < binary.length; ++k) bytes[k] = binary.charCodeAt(k);
  return bytes.buffer;
}

// Arrays become typed arrays wherever they stand.
function revive(value) {
  if (value === null || typeof value !== 'object') return value;
  if (typeof value.float32 === 'string') return new Float32Array(bytesOf(value.float32));
  if (typeof value.uint32 === 'string') return new Uint32Array(bytesOf(value.uint32));
  if (typeof value.int32 === 'string') return new Int32Array(bytesOf(value.int32));
  for (const key of Object.keys(value)) value[key] = revive(value[key]);
  return value;
}

function readScene() {
  const element = document.getElementById('scene');
  const scene = revive(JSON.parse(element.textContent));
  element.remove();
  return scene;
}

const noItem = 0xffffffff;
