// How the graphics card draws a patch, its lines and their numbers.
import { rounding } from './figures.js';

// Pieces stand apart along ways of their own.
const placed = `
#ifdef PIECES
attribute vec3 way;
attribute float piece;
uniform float apart;
vec3 placed(vec3 place) { return place + apart * way; }
#else
vec3 placed(vec3 place) { return place; }
#endif
`;

export const vertexShader = `
attribute float value;
varying float shown;
varying vec3 facing;
${placed}
#ifdef PIECES
attribute vec3 tint;
uniform float chosen;
varying vec3 own;
varying float strength;
#endif
void main() {
  shown = value;
  facing = normalMatrix * normal;
#ifdef PIECES
  own = tint;
  strength = chosen < 0.0 || abs(piece - chosen) < 0.5 ? 1.0 : 0.3;
#endif
  gl_Position = projectionMatrix * modelViewMatrix * vec4(placed(position), 1.0);
}`;

// Light comes from over the shoulder and both sides of the patch are lit alike.
export const fragmentShader = `
uniform sampler2D colors;
uniform float limit;
uniform bool bothWays;
uniform bool isBounded;
uniform vec3 beyond;
uniform bool isPlain;
uniform bool hasStripes;
varying float shown;
varying vec3 facing;
#ifdef PIECES
varying vec3 own;
varying float strength;
#endif
void main() {
  float share = clamp(shown / limit, -1.0, 1.0);
  float place = bothWays ? 0.5 + 0.5 * share : abs(share);
  vec3 color = texture2D(colors, vec2(place * 0.992 + 0.004, 0.5)).rgb;
  if (isBounded && abs(shown) > limit * (1.0 + ${rounding})) color = beyond;
  vec3 normal = normalize(facing);
  normal *= sign(normal.z + 1e-6);
  float light = 0.5 + 0.5 * clamp(dot(normal, vec3(0.28, 0.38, 0.88)), 0.0, 1.0);
  if (isPlain) {
    float key = clamp(dot(normal, vec3(-0.46, 0.56, 0.69)), 0.0, 1.0);
#ifdef PIECES
    color = gl_FrontFacing ? own : mix(own, vec3(0.55), 0.5);
    light = 0.62 + 0.07 * normal.y + 0.4 * key; // colours must differ in the shade too
#else
    color = gl_FrontFacing ? vec3(0.86, 0.835, 0.79) : vec3(0.66, 0.68, 0.72);
    light = 0.43 + 0.09 * normal.y + 0.54 * key;
#endif
  }
  if (hasStripes) {
    // What a wall of straight lamps looks like in a polished surface.
    float place = 7.0 * dot(2.0 * normal.z * normal, vec3(0.34, 0.94, 0.0));
    float soft = max(fwidth(place), 1e-4);
    float stripe = smoothstep(-soft, soft, abs(fract(place) - 0.5) - 0.25);
    color = mix(vec3(0.10, 0.11, 0.13), isPlain ? vec3(0.97) : color, stripe);
    light = 0.45 + 0.55 * light;
  }
  gl_FragColor = vec4(color * light, 1.0);
#ifdef PIECES
  gl_FragColor *= strength; // the ground of the page shines through, nothing that is behind
#endif
}`;

// The design over the result that is drawn solid.
export const ghostVertexShader = `
varying vec3 facing;
${placed}
void main() {
  facing = normalMatrix * normal;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(placed(position), 1.0);
}`;

export const ghostFragmentShader = `
varying vec3 facing;
void main() {
  float edge = 1.0 - abs(normalize(facing).z);
  gl_FragColor = vec4(0.0, 0.40, 0.72, 0.26 + 0.44 * edge * edge);
}`;

export const contourFragmentShader = `
void main() {
  gl_FragColor = vec4(0.0, 0.27, 0.486, 1.0);
}`;

// A straight part of a line, as wide on the screen wherever it is: a square over it from 0 to 1 and
// from -1 to 1. It lies a little before the surface that it is drawn on.
export const lineVertexShader = `
attribute vec3 start;
attribute vec3 end;
attribute vec3 tint;
uniform vec2 port; // pixels
uniform float chosen;
varying vec4 color;
${placed}
void main() {
  mat4 all = projectionMatrix * modelViewMatrix;
  vec4 from = all * vec4(placed(start), 1.0);
  vec4 to = all * vec4(placed(end), 1.0);
  vec2 along = (to.xy - from.xy) * port;
  along = dot(along, along) > 0.0 ? normalize(along) : vec2(1.0, 0.0);
  bool isChosen = chosen < 0.0 || abs(piece - chosen) < 0.5;
  float reach = (isChosen ? 2.1 : 1.3) * (min(port.x, port.y) < 360.0 ? 0.75 : 1.0);
  color = isChosen ? vec4(tint, 1.0) : vec4(0.4 * tint, 0.4);
  gl_Position = position.x < 0.5 ? from : to;
  // Parts that can be seen through do not overlap.
  vec2 shift = vec2(-along.y, along.x) * position.y + (isChosen ? position.x - 0.5 : 0.0) * along;
  gl_Position.xy += 2.0 * reach * shift / port;
  gl_Position.z -= 0.0012;
}`;

export const lineFragmentShader = `
varying vec4 color;
void main() {
  gl_FragColor = color;
}`;

// A number: a square from -1 to 1 around a place, with a cell of a picture of all numbers.
export const numberVertexShader = `
attribute vec3 start;
attribute vec2 cell;
uniform vec2 port; // pixels
uniform float cells; // of a row or column
uniform float chosen;
varying vec2 at;
varying float strength;
${placed}
void main() {
  gl_Position = projectionMatrix * modelViewMatrix * vec4(placed(start), 1.0);
  float radius = clamp(0.022 * min(port.x, port.y), 7.0, 10.0);
  gl_Position.xy += 2.0 * radius * position.xy / port;
  gl_Position.z -= 0.004;
  at = (cell + 0.5 + 0.5 * vec2(position.x, -position.y)) / cells;
  strength = chosen < 0.0 || abs(piece - chosen) < 0.5 ? 1.0 : 0.35;
}`;

export const numberFragmentShader = `
uniform sampler2D numbers;
varying vec2 at;
varying float strength;
void main() {
  gl_FragColor = texture2D(numbers, at) * strength;
}`;
