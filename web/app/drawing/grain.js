// The grain: two clicks on the model say which way it runs, on all pieces.

/** @typedef {import('../app.js').App} App */
/** @typedef {import('../project.js').Point} Point */

export class Grain {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    /** Whether clicks set it. */
    this.isOn = false;
    /** Where it begins; null until that is clicked. @type {Point | null} */
    this.from = null;
  }

  /** Begins, ends, or where there is a grain takes it away. */
  toggle() {
    if (!this.isOn && this.app.project.grain) {
      this.app.change({ grain: '' });
      return;
    }
    this.isOn = !this.isOn;
    this.from = null;
    if (this.isOn) this.app.notches.isOn = false;
    if (this.isOn) this.app.seams.choose(-1);
    else this.app.seams.show();
  }

  /** @param {Point | null} place on the surface */
  click(place) {
    const { from } = this;
    if (!place) return;
    this.from = place;
    if (from) {
      const way = place.map((x, k) => x - from[k]);
      const length = Math.hypot(...way);
      if (length === 0) return;
      this.isOn = false;
      this.app.change({ grain: way.map((x) => Number((x / length).toPrecision(6))).join(',') });
    }
    this.show();
  }

  show() {
    const { grain } = this.app.project;
    const { grain: button, hint } = this.app.frame.seamPart;
    this.app.frame.sheet.showGrain(grain ? grain.split(',').map(Number) : null);
    button.setAttribute('aria-pressed', String(this.isOn));
    button.textContent = this.isOn ? 'Cancel the grain' : grain ? 'Remove the grain' : 'Set the grain';
    if (!this.isOn) return;
    hint.textContent = this.from ? 'Now click where the grain leads to.' : 'Click two places on the model: the grain runs from one to the other.';
  }
}
