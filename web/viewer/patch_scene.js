// The patch in two forms, drawn with one camera: one form left of the split, the other right.
import {
  BufferAttribute,
  BufferGeometry,
  DataTexture,
  DoubleSide,
  LinearFilter,
  Matrix4,
  Mesh,
  OrthographicCamera,
  Scene,
  ShaderMaterial,
  Vector3,
  WebGLRenderer,
} from 'three';

import { rounding } from './figures.js';

const vertexShader = `
attribute float value;
varying float shown;
varying vec3 facing;
void main() {
  shown = value;
  facing = normalMatrix * normal;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

// Light comes from over the shoulder and both sides of the patch are lit alike.
const fragmentShader = `
uniform sampler2D colors;
uniform float limit;
uniform bool bothWays;
uniform bool isBounded;
uniform vec3 beyond;
varying float shown;
varying vec3 facing;
void main() {
  float share = clamp(shown / limit, -1.0, 1.0);
  float place = bothWays ? 0.5 + 0.5 * share : abs(share);
  vec3 color = texture2D(colors, vec2(place * 0.992 + 0.004, 0.5)).rgb;
  if (isBounded && abs(shown) > limit * (1.0 + ${rounding})) color = beyond;
  vec3 normal = normalize(facing);
  normal *= sign(normal.z + 1e-6);
  float light = 0.5 + 0.5 * clamp(dot(normal, vec3(0.28, 0.38, 0.88)), 0.0, 1.0);
  gl_FragColor = vec4(color * light, 1.0);
}`;

const margin = 1.12; // of the picture over the patch

function textureOf(map) {
  const pixels = new Uint8Array((map.length / 3) * 4).fill(255);
  for (let i = 0; i < map.length / 3; ++i) pixels.set(map.subarray(3 * i, 3 * i + 3), 4 * i);
  const texture = new DataTexture(pixels, map.length / 3, 1);
  texture.minFilter = LinearFilter;
  texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

function vectorOf([x, y, z]) {
  return new Vector3(x, y, z);
}

// Looking at a number of states, with a middle and half sizes along right and up.
function framing(data, right, up) {
  const low = new Vector3(Infinity, Infinity, Infinity);
  const high = low.clone().negate();
  const point = new Vector3();
  for (const positions of data.positions) {
    for (let i = 0; i < positions.length; i += 3) {
      point.fromArray(positions, i);
      low.min(point);
      high.max(point);
    }
  }
  const middle = low.clone().add(high).multiplyScalar(0.5);
  let width = 0;
  let height = 0;
  for (const positions of data.positions) {
    for (let i = 0; i < positions.length; i += 3) {
      point.fromArray(positions, i).sub(middle);
      width = Math.max(width, Math.abs(point.dot(right)));
      height = Math.max(height, Math.abs(point.dot(up)));
    }
  }
  return { middle, width, height, radius: 0.5 * low.distanceTo(high) };
}

export class PatchScene {
  constructor(canvas, context, data) {
    this.data = data;
    this.renderer = new WebGLRenderer({ canvas, context, alpha: true });
    this.renderer.setClearColor(0x000000, 0);
    this.renderer.autoClear = false;
    this.camera = new OrthographicCamera();
    this.home = new Matrix4().makeBasis(
      vectorOf(data.view.right),
      vectorOf(data.view.up),
      vectorOf(data.view.towards),
    );
    this.frame = framing(data, vectorOf(data.view.right), vectorOf(data.view.up));
    this.textures = new Map([...data.maps].map(([name, map]) => [name, textureOf(map)]));
    this.split = 0.5;
    this.shown = [0, data.shown];
    this.material = new ShaderMaterial({
      vertexShader,
      fragmentShader,
      side: DoubleSide,
      uniforms: {
        colors: { value: null },
        limit: { value: 1 },
        bothWays: { value: true },
        isBounded: { value: false },
        beyond: { value: new Vector3() },
      },
    });
    const index = new BufferAttribute(data.triangles, 1);
    this.scenes = data.positions.map((positions) => {
      const geometry = new BufferGeometry();
      geometry.setIndex(index);
      geometry.setAttribute('position', new BufferAttribute(positions, 3));
      geometry.setAttribute('value', new BufferAttribute(new Float32Array(data.count), 1));
      geometry.computeVertexNormals();
      const mesh = new Mesh(geometry, this.material);
      mesh.frustumCulled = false;
      const scene = new Scene();
      scene.add(mesh);
      return scene;
    });
    this.reset();
  }

  reset() {
    this.camera.quaternion.setFromRotationMatrix(this.home);
    this.target = this.frame.middle.clone();
    this.zoom = 1;
  }

  // Values of every state, and how they are coloured: what is beyond the limit by a colour of its
  // own, where there is one.
  color(values, map, limit, bothWays, beyond) {
    this.scenes.forEach((scene, state) => {
      const attribute = scene.children[0].geometry.getAttribute('value');
      if (values[state]) attribute.array.set(values[state]);
      else attribute.array.fill(NaN);
      attribute.needsUpdate = true;
    });
    this.material.uniforms.colors.value = this.textures.get(map);
    this.material.uniforms.bothWays.value = bothWays;
    this.material.uniforms.isBounded.value = beyond !== undefined;
    if (beyond) this.material.uniforms.beyond.value.fromArray(beyond).divideScalar(255);
    this.scale(limit);
  }

  scale(limit) {
    this.material.uniforms.limit.value = limit;
  }

  resize(width, height, ratio) {
    this.width = width;
    this.height = height;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
  }

  // Model units per pixel.
  pixel() {
    const { width, height } = this.frame;
    const fit = Math.max((2 * width) / this.width, (2 * height) / this.height) || 1;
    return (margin * fit) / this.zoom;
  }

  place() {
    const { camera, frame } = this;
    const half = 0.5 * this.pixel();
    camera.left = -half * this.width;
    camera.right = half * this.width;
    camera.top = half * this.height;
    camera.bottom = -half * this.height;
    const distance = 4 * frame.radius + frame.middle.distanceTo(this.target);
    camera.near = 0;
    camera.far = 2 * distance;
    camera.position.set(0, 0, distance).applyQuaternion(camera.quaternion).add(this.target);
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
  }

  draw() {
    this.place();
    const { renderer, width, height } = this;
    const at = Math.round(this.split * width);
    renderer.setScissorTest(false);
    renderer.clear();
    renderer.setScissorTest(true);
    for (const [state, left, size] of [
      [this.shown[0], 0, at],
      [this.shown[1], at, width - at],
    ]) {
      if (size <= 0) continue;
      renderer.setScissor(left, 0, size, height);
      renderer.render(this.scenes[state], this.camera);
    }
  }

  // Where the vertices of a state are in the picture: pixels from the upper left, depth towards the
  // eye.
  projected(state) {
    const matrix = new Matrix4().multiplyMatrices(
      this.camera.projectionMatrix,
      this.camera.matrixWorldInverse,
    );
    const positions = this.data.positions[state];
    const places = new Float32Array(positions.length);
    const point = new Vector3();
    for (let i = 0; i < positions.length; i += 3) {
      point.fromArray(positions, i).applyMatrix4(matrix);
      places[i] = 0.5 * (1 + point.x) * this.width;
      places[i + 1] = 0.5 * (1 - point.y) * this.height;
      places[i + 2] = -point.z;
    }
    return places;
  }
}
