// Turning, shifting and zooming a patch by mouse, fingers and keys.
import { Quaternion, Vector3 } from 'three';

/** @typedef {import('./patch_scene.js').PatchScene} PatchScene */

const perPixel = 0.008; // radians
const perKey = 0.12; // radians
const mostZoom = 60;

export class Turning {
  /**
   * @param {HTMLCanvasElement} canvas
   * @param {PatchScene} scene whose camera moves
   * @param {() => void} changed called after every move of it
   * @param {(event: PointerEvent) => void} clicked called after a press without a drag
   */
  constructor(canvas, scene, changed, clicked) {
    this.canvas = canvas;
    this.scene = scene;
    this.changed = changed;
    this.clicked = clicked;
    /** @type {Map<number, PointerEvent>} */
    this.fingers = new Map();
    this.travelled = 0;
    this.listening = new AbortController();
    const { signal } = this.listening;
    canvas.addEventListener('pointerdown', (event) => this.press(event), { signal });
    canvas.addEventListener('pointermove', (event) => this.move(event), { signal });
    canvas.addEventListener('pointerup', (event) => this.release(event), { signal });
    canvas.addEventListener('pointercancel', (event) => this.release(event), { signal });
    canvas.addEventListener('wheel', (event) => this.wheel(event), { passive: false, signal });
    canvas.addEventListener('keydown', (event) => this.key(event), { signal });
    canvas.addEventListener('contextmenu', (event) => event.preventDefault(), { signal });
  }

  get isDragging() {
    return this.fingers.size > 0 && this.travelled > 4;
  }

  /**
   * @param {number} right radians
   * @param {number} down radians
   */
  turn(right, down) {
    const { camera } = this.scene;
    /** @type {(x: number, y: number, angle: number) => Quaternion} */
    const about = (x, y, angle) => new Quaternion().setFromAxisAngle(new Vector3(x, y, 0), angle);
    camera.quaternion.multiply(about(0, 1, -right)).multiply(about(1, 0, -down)).normalize();
    this.changed();
  }

  /**
   * @param {number} right pixels
   * @param {number} down pixels
   */
  shift(right, down) {
    const { scene } = this;
    const size = scene.pixel();
    scene.target.add(
      new Vector3(-right * size, down * size, 0).applyQuaternion(scene.camera.quaternion),
    );
    this.changed();
  }

  /** @param {number} factor above 1 nearer */
  zoom(factor) {
    this.scene.zoom = Math.min(mostZoom, Math.max(0.5, this.scene.zoom * factor));
    this.changed();
  }

  reset() {
    this.scene.reset();
    this.changed();
  }

  /** @param {PointerEvent} event */
  press(event) {
    if (this.fingers.size === 0) this.travelled = 0;
    this.canvas.setPointerCapture(event.pointerId);
    this.fingers.set(event.pointerId, event);
  }

  /** @param {PointerEvent} event */
  move(event) {
    const last = this.fingers.get(event.pointerId);
    if (!last) return;
    const right = event.clientX - last.clientX;
    const down = event.clientY - last.clientY;
    this.travelled += Math.hypot(right, down);
    const other = [...this.fingers.values()].find((one) => one.pointerId !== event.pointerId);
    if (this.fingers.size === 2 && other) this.pinch(event, last, other);
    else if (event.shiftKey || event.buttons & 6) this.shift(right, down);
    else if (this.travelled > 4) this.turn(perPixel * right, perPixel * down);
    this.fingers.set(event.pointerId, event);
  }

  /**
   * @param {PointerEvent} event of the finger that moves
   * @param {PointerEvent} last where it was before
   * @param {PointerEvent} other of the other finger
   */
  pinch(event, last, other) {
    /** @param {PointerEvent} one */
    const apart = (one) => Math.hypot(one.clientX - other.clientX, one.clientY - other.clientY);
    this.shift(0.5 * (event.clientX - last.clientX), 0.5 * (event.clientY - last.clientY));
    this.zoom(apart(event) / Math.max(1, apart(last)));
  }

  /** @param {PointerEvent} event */
  release(event) {
    const was = this.fingers.delete(event.pointerId);
    if (was && event.type === 'pointerup' && this.travelled <= 4) this.clicked(event);
  }

  /**
   * A page must scroll on where the mouse only passes.
   * @param {WheelEvent} event
   */
  wheel(event) {
    if (!event.ctrlKey && document.activeElement !== this.canvas) return;
    event.preventDefault();
    this.zoom(Math.exp(-0.0016 * event.deltaY * (event.deltaMode === 1 ? 20 : 1)));
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    /** @type {Map<string, () => void>} */
    const actions = new Map([
      ['ArrowLeft', () => this.turn(-perKey, 0)],
      ['ArrowRight', () => this.turn(perKey, 0)],
      ['ArrowUp', () => this.turn(0, -perKey)],
      ['ArrowDown', () => this.turn(0, perKey)],
      ['+', () => this.zoom(1.25)],
      ['=', () => this.zoom(1.25)],
      ['-', () => this.zoom(0.8)],
      ['0', () => this.reset()],
    ]);
    const action = actions.get(event.key);
    if (!action) return;
    event.preventDefault();
    action();
  }

  /** Listens to the canvas no more. */
  dispose() {
    this.listening.abort();
    this.fingers.clear();
  }
}
