// Notches on seams: a click on a seam sets one, on both sides of it.

/** @typedef {import('../app.js').App} App */
/** @typedef {import('../project.js').Point} Point */

export class Notches {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    /** Whether clicks set notches. */
    this.isOn = false;
  }

  toggle() {
    this.isOn = !this.isOn;
    if (this.isOn) this.app.grain.isOn = false;
    if (this.isOn) this.app.seams.choose(-1);
    else this.app.seams.show();
  }

  /**
   * @param {Point | null} place on the surface
   * @param {number} line that is there, or -1
   */
  click(place, line) {
    if (!place || line < 0) return;
    const { notches } = this.app.project;
    if (!notches.some((one) => String(one) === String(place))) this.app.change({ notches: [...notches, place] });
  }

  /** @param {number} index */
  remove(index) {
    this.app.change({ notches: this.app.project.notches.filter((_, i) => i !== index) });
  }

  show() {
    const { notches } = this.app.project;
    this.app.stage?.showNotches(notches);
    this.app.frame.sheet.showNotches(notches);
    const { notch, hint } = this.app.frame.seamPart;
    notch.setAttribute('aria-pressed', String(this.isOn));
    notch.textContent = this.isOn ? 'Done with notches' : 'Set notches';
    if (this.isOn) hint.textContent = 'Click on a seam to set a notch on both sides of it, and on a notch to take it away.';
  }
}
