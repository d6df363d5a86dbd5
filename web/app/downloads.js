// What can be taken home.
import { make } from '../viewer/dom.js';
import { button, part } from './controls.js';
import { flattenWords, shellText } from './project.js';
import { zipOf } from './zip.js';

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

/** @type {Record<string, string>} */
const kinds = { svg: 'image/svg+xml', dxf: 'image/vnd.dxf', pdf: 'application/pdf' };

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
    const patterns = Object.entries(kinds).map(([ending, type]) => {
      const some = files.filter(([path]) => path.endsWith(`pattern.${ending}`));
      const take = () => {
        if (some.length === 1) download(`${stem}.${ending}`, new Blob([some[0][1]], { type }));
        else download(`${stem}-${ending}.zip`, zipOf(some));
      };
      return button(ending.toUpperCase(), take, { dataset: { download: ending }, disabled: some.length === 0 });
    });
    const all = button('All, as zip', () => download(`${stem}-pattern.zip`, zipOf(files)), {
      dataset: { download: 'zip' },
    });
    this.row.replaceChildren(...patterns, all);
    this.command.textContent = shellText(flattenWords(project, folder));
  }
}
