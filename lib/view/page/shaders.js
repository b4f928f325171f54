// All materials draw in colours, or, while something is picked, every element in the colour that encodes its number.

const shared = {
  picking: { value: 0 },
  resolution: { value: new THREE.Vector2(1, 1) },
  pixelRatio: { value: 1 },
  liftUnit: { value: 0.001 }, // how much nearer to the eye a lift of 1 is, as a share of the distance
  highlightColour: { value: new THREE.Color(highlightColour) },
};

const commonVertex = `
  attribute vec4 element;
  attribute float group;
  varying vec4 vElement;
  varying float vGroup;
  uniform vec2 resolution;
  uniform float pixelRatio, lift, liftUnit, picking;
  void passOn() { vElement = element; vGroup = group; }
  // Towards the eye, at the same place of the picture.
  vec4 lifted(vec3 point) { vec4 seen = modelViewMatrix * vec4(point, 1.0); seen.xyz *= 1.0 - lift * liftUnit; return seen; }
`;

const commonFragment = `
  varying vec4 vElement;
  varying float vGroup;
  uniform float picking, highlighted;
  uniform vec3 highlightColour;
  bool isHighlighted() { return abs(vGroup - highlighted) < 0.5; }
`;

const faceVertex = commonVertex + `
  attribute vec4 colour;
  attribute float value;
  varying vec3 vColour, vSeen, vNormal;
  varying float vValue;
  void main() {
    passOn();
    vColour = colour.rgb;
    vValue = value;
    vec4 seen = modelViewMatrix * vec4(position, 1.0);
    vSeen = seen.xyz;
    vNormal = normalMatrix * normal;
    gl_Position = projectionMatrix * seen;
  }
`;

const faceFragment = commonFragment + `
  varying vec3 vColour, vSeen, vNormal;
  varying float vValue;
  uniform float smoothly, mapped, scaleTop, opacity;
  uniform vec3 ramp[9];
  vec3 rampColour(float share) {
    float at = clamp(share, 0.0, 1.0) * 8.0;
    vec3 result = ramp[0];
    for (int k = 0; k < 8; ++k) result = mix(result, ramp[k + 1], clamp(at - float(k), 0.0, 1.0));
    return result;
  }
  void main() {
    if (picking > 0.5) { gl_FragColor = vec4(vElement.rgb, 1.0); return; }
    vec3 flatNormal = normalize(cross(dFdx(vSeen), dFdy(vSeen)));
    vec3 n = smoothly > 0.5 && dot(vNormal, vNormal) > 0.0 ? normalize(vNormal) : flatNormal;
    if (dot(n, vSeen) > 0.0) n = -n;
    vec3 colour = mapped > 0.5 ? rampColour(vValue / scaleTop) : vColour;
    if (isHighlighted()) colour = mix(colour, highlightColour, 0.45);
    float key = max(dot(n, normalize(vec3(-0.5, 0.75, 0.6))), 0.0);
    // A colour map is shaded little, so that its colours stay those of the scale.
    float light = mix(0.66 + 0.12 * n.z + 0.26 * key, 0.84 + 0.06 * n.z + 0.12 * key, mapped);
    if (!gl_FrontFacing) colour *= 0.85;
    gl_FragColor = vec4(colour * light, opacity);
  }
`;

// A line is a rectangle on the screen for every piece, with round ends.
const lineVertex = commonVertex + `
  attribute vec3 start, end;
  uniform float width, highlighted;
  varying vec2 vPixel;
  varying float vLength, vHalf;
  void main() {
    passOn();
    vec4 a = projectionMatrix * lifted(start);
    vec4 b = projectionMatrix * lifted(end);
    vec2 across = (b.xy / b.w - a.xy / a.w) * resolution * 0.5;
    vLength = length(across);
    vec2 along = vLength > 0.0 ? across / vLength : vec2(1.0, 0.0);
    vHalf = 0.5 * width * pixelRatio + 2.0 * picking + (abs(group - highlighted) < 0.5 ? 2.0 * pixelRatio : 0.0);
    vec4 place = position.x < 0.5 ? a : b;
    vec2 offset = along * (2.0 * position.x - 1.0) * vHalf + vec2(-along.y, along.x) * position.y * vHalf;
    vPixel = vec2((position.x < 0.5 ? 0.0 : vLength) + (2.0 * position.x - 1.0) * vHalf, position.y * vHalf);
    place.xy += offset / resolution * 2.0 * place.w;
    gl_Position = place;
  }
`;

const lineFragment = commonFragment + `
  uniform vec3 lineColour;
  varying vec2 vPixel;
  varying float vLength, vHalf;
  void main() {
    float beyond = vPixel.x - clamp(vPixel.x, 0.0, vLength);
    if (length(vec2(beyond, vPixel.y)) > vHalf) discard;
    if (picking > 0.5) { gl_FragColor = vec4(vElement.rgb, 1.0); return; }
    gl_FragColor = vec4(isHighlighted() ? highlightColour : lineColour, 1.0);
  }
`;

const pointVertex = commonVertex + `
  attribute vec4 colour;
  varying vec3 vColour;
  uniform float size, highlighted;
  void main() {
    passOn();
    vColour = colour.rgb;
    gl_Position = projectionMatrix * lifted(position);
    gl_PointSize = size * pixelRatio + 4.0 * picking + (abs(group - highlighted) < 0.5 ? 6.0 * pixelRatio : 0.0);
  }
`;

const pointFragment = commonFragment + `
  varying vec3 vColour;
  void main() {
    float r = 2.0 * length(gl_PointCoord - 0.5);
    if (r > 1.0) discard;
    if (picking > 0.5) { gl_FragColor = vec4(vElement.rgb, 1.0); return; }
    vec3 inner = isHighlighted() ? highlightColour : vColour;
    gl_FragColor = vec4(r > 0.86 ? vec3(0.1) : r > 0.66 ? vec3(1.0) : inner, 1.0);
  }
`;

function newMaterial(vertexShader, fragmentShader, uniforms) {
  return new THREE.ShaderMaterial({
    vertexShader, fragmentShader, side: THREE.DoubleSide, extensions: { derivatives: true },
    uniforms: Object.assign({ lift: { value: 0 }, highlighted: { value: -1 } }, shared, uniforms),
  });
}
