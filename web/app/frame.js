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

/** What the page says before there is a model. */
function guide() {
  const steps = [
    ['Drop a model on this page.', 'Or try a sample. Files stay on this computer.'],
    ['Say how large it is.', 'Files seldom tell; the likely size is chosen.'],
    ['Look where it stretches, and draw seams there.', 'Red is longer in the pattern than on the model, blue is shorter.'],
    ['Take the pattern with you.', 'SVG, DXF, PDF or PLT, in true size.'],
  ];
  return make(
    'div',
    { className: 'empty guide' },
    make('h2', { textContent: 'From a model to its pattern' }),
    make('ol', {}, ...steps.map(([what, more]) => make('li', {}, make('b', { textContent: what }), ` ${more}`))),
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
    this.note = make('p', { className: 'note', role: 'status', hidden: true });
    this.place = make('div', { className: 'place' }, guide());
    this.filePart = new FilePart(
      (files) => void app.opening.take(files),
      (sample) => void app.opening.sample(sample),
    );
    this.keepingPart = new KeepingPart((isOn) => void app.keeping.want(isOn));
    this.filePart.root.append(this.keepingPart.root);
    this.unitPart = new UnitPart((unit) => app.change({ unit }));
    this.seamPart = new SeamPart(app.seams.listener());
    this.patternPart = new PatternPart((change) => app.change(change));
    this.piecePart = new PiecePart(
      (change) => app.changePiece(change),
      (piece) => app.seams.proposeDarts(this.seamPart.limit.value, [app.picture.pieces[piece]]),
    );
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
      make('footer', {}, this.alert, this.note, this.status, this.busy),
    );
  }
}
