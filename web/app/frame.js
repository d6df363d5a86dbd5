// The parts of the page, in their places.
import { make } from '../viewer/dom.js';
import { FilePart, KeepingPart, PatternPart, PiecePart, SeamPart, UnitPart, button } from './controls.js';
import { DownloadPart } from './downloads.js';
import { Sheet } from './sheet.js';

/** @typedef {import('./app.js').App} App */

/** @param {(by: 'stretch' | 'pieces') => void} chosen */
function colorChoice(chosen) {
  const choices = /** @type {const} */ ([
    ['stretch', 'Stretch'],
    ['pieces', 'Pieces'],
  ]);
  return make(
    'fieldset',
    { className: 'choice' },
    make('legend', { className: 'unseen', textContent: 'Colour by' }),
    ...choices.map(([value, text], i) => {
      const radio = make('input', { type: 'radio', name: 'color', value, checked: i === 0 });
      radio.addEventListener('change', () => chosen(value));
      return make('label', {}, radio, make('span', { textContent: text }));
    }),
  );
}

export class Frame {
  /**
   * @param {HTMLElement} root
   * @param {App} app
   */
  constructor(root, app) {
    this.undoButton = button('Undo', () => app.undo(), { disabled: true, title: 'Ctrl+Z' });
    this.redoButton = button('Redo', () => app.redo(), { disabled: true, title: 'Ctrl+Shift+Z' });
    this.saveButton = button('Save project', () => app.save(), { disabled: true });
    this.title = make('span', { className: 'model' });
    this.status = make('p', { className: 'status', role: 'status' });
    this.bar = make('progress', { max: 1, value: 0, ariaLabel: 'Progress' });
    this.busy = make('div', { className: 'busy', hidden: true }, this.bar, button('Cancel', () => app.cancel()));
    this.alert = make('div', { className: 'alert', role: 'alert', hidden: true });
    this.place = make('div', { className: 'place' }, make('p', { className: 'empty', textContent: 'No model yet' }));
    this.filePart = new FilePart(
      (file) => void app.take(file),
      (sample) => void app.openSample(sample),
    );
    this.keepingPart = new KeepingPart((isOn) => void app.keeping.want(isOn));
    this.filePart.root.append(this.keepingPart.root);
    this.unitPart = new UnitPart((unit) => app.change({ unit }));
    this.seamPart = new SeamPart(app.seams.listener());
    this.patternPart = new PatternPart((change) => app.change(change));
    this.piecePart = new PiecePart((change) => app.changePiece(change));
    this.sheet = new Sheet((vertex) => app.picture.mark(vertex));
    this.scale = make('div', { className: 'scale', hidden: true });
    this.verdict = make('p', { className: 'verdict' });
    this.downloads = new DownloadPart();
    this.seamPart.root.hidden = true;
    this.patternPart.root.hidden = true;
    this.fill(root, app);
  }

  /**
   * @param {HTMLElement} root
   * @param {App} app
   */
  fill(root, app) {
    const actions = make('div', { className: 'actions' }, this.undoButton, this.redoButton, this.saveButton);
    const local = make('span', { className: 'local', textContent: 'Runs on this computer; nothing is uploaded' });
    const sides = [this.filePart, this.unitPart, this.seamPart, this.patternPart, this.piecePart];
    const under = make('div', { className: 'under' }, colorChoice((by) => app.picture.colorBy(by)), this.scale);
    root.append(
      make('header', {}, make('h1', { textContent: 'Planish' }), this.title, actions, local),
      make('aside', {}, ...sides.map((side) => side.root)),
      make('section', { className: 'space', ariaLabel: 'Model' }, this.place, under),
      make('section', { className: 'flat', ariaLabel: 'Pattern' }, this.sheet.canvas, this.verdict, this.downloads.root),
      make('footer', {}, this.alert, this.status, this.busy),
    );
  }
}
