// Turning, shifting and zooming the patch by mouse, fingers and keys.
import { Quaternion, Vector3 } from 'three';

const perPixel = 0.008; // radians
const perKey = 0.12; // radians
const mostZoom = 60;

export class Turning {
  // changed: called after every change; clicked(event): a press without a drag
  constructor(canvas, scene, changed, clicked) {
    Object.assign(this, { canvas, scene, changed, clicked });
    this.fingers = new Map();
    this.travelled = 0;
    canvas.addEventListener('pointerdown', (event) => this.press(event));
    canvas.addEventListener('pointermove', (event) => this.move(event));
    for (const end of ['pointerup', 'pointercancel']) {
      canvas.addEventListener(end, (event) => this.release(event));
    }
    canvas.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
    canvas.addEventListener('keydown', (event) => this.key(event));
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
  }

  get isDragging() {
    return this.fingers.size > 0 && this.travelled > 4;
  }

  turn(right, down) {
    const { camera } = this.scene;
    const about = (x, y, angle) => new Quaternion().setFromAxisAngle(new Vector3(x, y, 0), angle);
    camera.quaternion.multiply(about(0, 1, -right)).multiply(about(1, 0, -down)).normalize();
    this.changed();
  }

  shift(right, down) {
    const { scene } = this;
    const size = scene.pixel();
    scene.target.add(
      new Vector3(-right * size, down * size, 0).applyQuaternion(scene.camera.quaternion),
    );
    this.changed();
  }

  zoom(factor) {
    this.scene.zoom = Math.min(mostZoom, Math.max(0.5, this.scene.zoom * factor));
    this.changed();
  }

  reset() {
    this.scene.reset();
    this.changed();
  }

  press(event) {
    if (this.fingers.size === 0) this.travelled = 0;
    this.canvas.setPointerCapture(event.pointerId);
    this.fingers.set(event.pointerId, event);
  }

  move(event) {
    const last = this.fingers.get(event.pointerId);
    if (!last) return;
    const right = event.clientX - last.clientX;
    const down = event.clientY - last.clientY;
    this.travelled += Math.hypot(right, down);
    if (this.fingers.size === 2) this.pinch(event, last);
    else if (event.shiftKey || event.buttons & 6) this.shift(right, down);
    else if (this.travelled > 4) this.turn(perPixel * right, perPixel * down);
    this.fingers.set(event.pointerId, event);
  }

  pinch(event, last) {
    const other = [...this.fingers.values()].find((one) => one.pointerId !== event.pointerId);
    const apart = (one) => Math.hypot(one.clientX - other.clientX, one.clientY - other.clientY);
    this.shift(0.5 * (event.clientX - last.clientX), 0.5 * (event.clientY - last.clientY));
    this.zoom(apart(event) / Math.max(1, apart(last)));
  }

  release(event) {
    const was = this.fingers.delete(event.pointerId);
    if (was && event.type === 'pointerup' && this.travelled <= 4) this.clicked(event);
  }

  // A page must scroll on where the mouse only passes.
  wheel(event) {
    if (!event.ctrlKey && document.activeElement !== this.canvas) return;
    event.preventDefault();
    this.zoom(Math.exp(-0.0016 * event.deltaY * (event.deltaMode === 1 ? 20 : 1)));
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const actions = {
      ArrowLeft: () => this.turn(-perKey, 0),
      ArrowRight: () => this.turn(perKey, 0),
      ArrowUp: () => this.turn(0, -perKey),
      ArrowDown: () => this.turn(0, perKey),
      '+': () => this.zoom(1.25),
      '=': () => this.zoom(1.25),
      '-': () => this.zoom(0.8),
      0: () => this.reset(),
    };
    if (!(event.key in actions)) return;
    event.preventDefault();
    actions[event.key]();
  }
}
