// What can be taken home.
import { make } from '../viewer/dom.js';
import { button, part } from './controls.js';
import { flattenWords, shellText } from './project.js';
import { zipOf } from './packing/zip.js';

/** @typedef {import('./engine.js').Outcome} Outcome */
/** @typedef {import('./project.js').Project} Project */

/**
 * Hands a file to the browser.
 * @param {string} name
 * @param {Blob} blob
 */
export function download(name, blob) {
  const link = make('a', { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

/** What can be taken one by one: what the button says, how files of the program end, and their type. */
const kinds = /** @type {const} */ ([
  ['SVG', 'pattern.svg', 'image/svg+xml'],
  ['DXF', 'pattern.dxf', 'image/vnd.dxf'],
  ['PDF', 'pattern.pdf', 'application/pdf'],
  ['PLT', 'pattern.plt', 'application/vnd.hp-hpgl'],
  ['Textured OBJ', 'textured.obj', 'model/obj'],
]);

export class DownloadPart {
  constructor() {
    this.row = make('div', { className: 'row' });
    this.command = make('code');
    this.root = part(
      'Take it with you',
      this.row,
      make('details', {}, make('summary', { textContent: 'The same from the command line' }), this.command),
    );
    this.root.classList.add('downloads');
    this.root.hidden = true;
  }

  /** Until the pattern is that of the last change. */
  wait() {
    for (const one of this.row.querySelectorAll('button')) one.disabled = true;
  }

  /**
   * @param {Project} project
   * @param {Outcome | null} outcome
   * @param {string} folder
   */
  show(project, outcome, folder) {
    this.root.hidden = outcome === null;
    if (!outcome) return;
    const { files } = outcome;
    const stem = project.model.replace(/\.[^.]*$/, '');
    const patterns = kinds.map(([text, name, type]) => {
      const ending = name.replace(/.*\./, '');
      const some = files.filter(([path]) => path === name || path.endsWith(`/${name}`));
      const take = () => {
        const single = ending === 'obj' ? `${stem}-${name}` : `${stem}.${ending}`;
        if (some.length === 1) download(single, new Blob([some[0][1]], { type }));
        else download(`${stem}-${ending}.zip`, zipOf(some));
      };
      return button(text, take, { dataset: { download: ending }, disabled: some.length === 0 });
    });
    const all = button('All, as zip', () => download(`${stem}-pattern.zip`, zipOf(files)), {
      dataset: { download: 'zip' },
    });
    this.row.replaceChildren(...patterns, all);
    this.command.textContent = shellText(flattenWords(project, folder));
  }
}
