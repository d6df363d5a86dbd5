// What is drawn of a patch: the surface of each state, its numbered lines, and the first state as a ghost.
import { BufferAttribute, BufferGeometry, DoubleSide, LineSegments, Mesh, Scene, ShaderMaterial } from 'three';

import { NumberedLines } from './numbered_lines.js';
import { attributesOf, borderOf, geometryOf } from './patch_geometry.js';
import {
  contourFragmentShader,
  fragmentShader,
  ghostFragmentShader,
  ghostVertexShader,
  vertexShader,
} from './shaders.js';

/** @typedef {import('./patch_scene.js').Patch} Patch */
/** @typedef {import('./patch_scene.js').PatchScene['uniforms']} Uniforms */

export class PatchBody {
  /**
   * @param {Patch} patch
   * @param {Uniforms} uniforms
   * @param {PatchBody | null} [before] that it replaces: gives its material, which takes long to compile, and is disposed
   */
  constructor(patch, uniforms, before = null) {
    this.uniforms = uniforms;
    /** @type {Scene | null} made when it is first needed */
    this.ghost = null;
    this.triangles = patch.triangles;
    const { pieces } = patch;
    this.pieces = pieces;
    /** @type {Record<string, string>} */
    this.defines = pieces ? { PIECES: '' } : {};
    const given = before && Boolean(before.pieces) === Boolean(pieces) ? before.material : null;
    this.material =
      given ?? new ShaderMaterial({ vertexShader, fragmentShader, side: DoubleSide, uniforms, defines: this.defines });
    before?.dispose(given !== null);
    const index = new BufferAttribute(patch.triangles, 1);
    const shared = pieces ? attributesOf(pieces) : [];
    this.geometries = patch.positions.map((positions) => geometryOf(positions, index, shared));
    const { apart, chosen } = uniforms;
    this.lines = pieces?.lines.length ? new NumberedLines(pieces, patch.positions, { apart, chosen }) : null;
    this.scenes = this.geometries.map((geometry, state) => {
      const mesh = new Mesh(geometry, this.material);
      mesh.frustumCulled = false;
      return new Scene().add(mesh, ...(this.lines?.parts[state] ?? []));
    });
  }

  // The first state, seen through, with its contour.
  ghostScene() {
    if (this.ghost) return this.ghost;
    const skin = new ShaderMaterial({
      vertexShader: ghostVertexShader,
      fragmentShader: ghostFragmentShader,
      uniforms: { apart: this.uniforms.apart },
      defines: this.defines,
      side: DoubleSide,
      transparent: true,
      depthWrite: false,
      polygonOffset: true, // where both are the same the result is seen
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 4,
    });
    const contour = new BufferGeometry();
    contour.attributes = { ...this.geometries[0].attributes };
    contour.setIndex(borderOf(this.triangles));
    const line = new ShaderMaterial({
      vertexShader: ghostVertexShader,
      fragmentShader: contourFragmentShader,
      uniforms: { apart: this.uniforms.apart },
      defines: this.defines,
      depthTest: false,
    });
    const parts = [new Mesh(this.geometries[0], skin), new LineSegments(contour, line)];
    for (const part of parts) part.frustumCulled = false;
    this.ghost = new Scene().add(...parts);
    return this.ghost;
  }

  /** Frees its GPU memory. @param {boolean} keepsMaterial that another one uses */
  dispose(keepsMaterial = false) {
    for (const geometry of this.geometries) geometry.dispose();
    this.lines?.dispose();
    this.ghost?.traverse((part) => {
      if (!(part instanceof Mesh || part instanceof LineSegments)) return;
      part.geometry.dispose();
      part.material.dispose();
    });
    if (!keepsMaterial) this.material.dispose();
  }
}
