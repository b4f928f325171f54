// All materials draw in colours, or, while something is picked, every element in the colour that encodes its number.

const shared = {
  picking: { value: 0 },
  resolution: { value: new THREE.Vector2(1, 1) },
  pixelRatio: { value: 1 },
  section: { value: new THREE.Vector4(0, 0, 0, 1) }, // what has a positive scalar product with (x, y, z, -1) is cut away
  liftUnit: { value: 0.001 }, // how much nearer to the eye a lift of 1 is, as a share of the distance
  highlightColour: { value: new THREE.Color(highlightColour) },
};

const commonVertex = `
  attribute vec4 element;
  attribute float group;
  varying vec4 vElement;
  varying float vGroup, vBeyond;
  uniform vec2 resolution;
  uniform vec4 section;
  uniform float pixelRatio, lift, liftUnit, picking;
  void passOn(vec3 point) { vElement = element; vGroup = group; vBeyond = dot(section.xyz, point) - section.w; }
  // Towards the eye, at the same place of the picture.
  vec4 lifted(vec3 point) { vec4 seen = modelViewMatrix * vec4(point, 1.0); seen.xyz *= 1.0 - lift * liftUnit; return seen; }
`;

const commonFragment = `
  varying vec4 vElement;
  varying float vGroup, vBeyond;
  uniform float picking, highlighted;
  uniform vec3 highlightColour;
  bool isHighlighted() { return abs(vGroup - highlighted) < 0.5; }
`;

// Scales: 0 rising, 1 centred, 2 verdict.
const rampFragment = `
  uniform float scaleTop, scaleKind;
  uniform vec3 ramp[9];
  uniform vec3 beyond, unknown;
  vec3 rampColour(float value) {
    if (value > 1e29) return unknown;
    float share = value / scaleTop;
    if (scaleKind < 1.5 && abs(share) > 1.0005) return beyond;
    if (scaleKind > 1.5) return share * 1.25 > 1.0 ? beyond : share * 1.25 > 0.5 ? ramp[4] : ramp[0];
    float at = clamp(scaleKind > 0.5 ? 0.5 + 0.5 * share : share, 0.0, 1.0) * 8.0;
    vec3 result = ramp[0];
    for (int k = 0; k < 8; ++k) result = mix(result, ramp[k + 1], clamp(at - float(k), 0.0, 1.0));
    return result;
  }
`;

const faceVertex = commonVertex + `
  attribute vec4 colour;
  attribute float value;
  varying vec3 vColour, vSeen, vNormal;
  varying float vValue;
  void main() {
    passOn(position);
    vColour = colour.rgb;
    vValue = value;
    vec4 seen = modelViewMatrix * vec4(position, 1.0);
    vSeen = seen.xyz;
    vNormal = normalMatrix * normal;
    gl_Position = projectionMatrix * seen;
  }
`;

// Paints: 0 the colour of the item, 1 mapped, 2 stripes.
const faceFragment = commonFragment + rampFragment + `
  varying vec3 vColour, vSeen, vNormal;
  varying float vValue;
  uniform float smoothly, paint, opacity, pixelRatio;
  uniform vec3 backColour;
  // Light and dark rings about the vertical, mirrored by the surface.
  float stripes(vec3 n) {
    float turn = acos(clamp(reflect(normalize(vSeen), n).y, -1.0, 1.0)) * 24.0 / 3.14159265;
    float wave = sin(turn * 3.14159265), soft = clamp(fwidth(turn) * 3.2, 0.02, 1.0);
    return smoothstep(-soft, soft, wave);
  }
  void main() {
    if (vBeyond > 0.0) discard;
    if (picking > 0.5) { gl_FragColor = vec4(vElement.rgb, 1.0); return; }
    vec3 flatNormal = normalize(cross(dFdx(vSeen), dFdy(vSeen)));
    vec3 n = smoothly > 0.5 && dot(vNormal, vNormal) > 0.0 ? normalize(vNormal) : flatNormal;
    if (dot(n, vSeen) > 0.0) n = -n;
    bool mapped = paint > 0.5 && paint < 1.5, striped = paint > 1.5;
    vec3 colour = mapped ? rampColour(vValue) : striped ? mix(vec3(0.31, 0.38, 0.46), vec3(0.97), stripes(n)) : vColour;
    if (isHighlighted()) colour = mix(colour, highlightColour, 0.45);
    float key = max(dot(n, normalize(vec3(-0.5, 0.75, 0.6))), 0.0);
    // A colour map is shaded little, so that its colours stay those of the scale.
    float light = mapped ? 0.84 + 0.06 * n.z + 0.12 * key : striped ? 0.8 + 0.2 * n.z : 0.55 + 0.18 * n.z + 0.33 * key;
    // The back is tinted, and hatched on the screen.
    if (!gl_FrontFacing) {
      float hatch = step(0.72, fract((gl_FragCoord.x + gl_FragCoord.y) / (8.0 * pixelRatio)));
      colour = mix(colour, backColour, mapped ? 0.12 + 0.6 * hatch : 0.5 + 0.3 * hatch);
    }
    gl_FragColor = vec4(colour * light, opacity);
  }
`;

// A line is a rectangle on the screen for every piece, with round ends.
const lineVertex = commonVertex + `
  attribute vec3 start, end;
  attribute float value;
  uniform float width, highlighted;
  varying vec2 vPixel;
  varying float vLength, vHalf, vValue;
  void main() {
    passOn(position.x < 0.5 ? start : end);
    vValue = value;
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

const lineFragment = commonFragment + rampFragment + `
  uniform vec3 lineColour;
  uniform float paint;
  varying vec2 vPixel;
  varying float vLength, vHalf, vValue;
  void main() {
    if (vBeyond > 0.0) discard;
    float beyond = vPixel.x - clamp(vPixel.x, 0.0, vLength);
    if (length(vec2(beyond, vPixel.y)) > vHalf) discard;
    if (picking > 0.5) { gl_FragColor = vec4(vElement.rgb, 1.0); return; }
    gl_FragColor = vec4(isHighlighted() ? highlightColour : paint > 0.5 ? rampColour(vValue) : lineColour, 1.0);
  }
`;

const pointVertex = commonVertex + `
  attribute vec4 colour;
  varying vec3 vColour;
  uniform float size, highlighted;
  void main() {
    passOn(position);
    vColour = colour.rgb;
    gl_Position = projectionMatrix * lifted(position);
    gl_PointSize = size * pixelRatio + 4.0 * picking + (abs(group - highlighted) < 0.5 ? 6.0 * pixelRatio : 0.0);
  }
`;

const pointFragment = commonFragment + `
  varying vec3 vColour;
  void main() {
    float r = 2.0 * length(gl_PointCoord - 0.5);
    if (r > 1.0 || vBeyond > 0.0) discard;
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

// What shaders need of a scale; of none where there is nothing to map.
function scaleUniforms(mapped) {
  const scale = mapped ? mapped.scale : 'rising';
  return {
    scaleTop: { value: 1 }, scaleKind: { value: mapped ? scaleKind(mapped) : 0 },
    ramp: { value: ramps[scale].map((text) => new THREE.Color(text)) }, beyond: colourUniform(beyondColours[scale]), unknown: colourUniform(unknownColour),
  };
}
