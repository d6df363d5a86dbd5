// Hands what a report is of to the app, another file, which the report opens.
import { make } from '../viewer/dom.js';

/** What the app says when it is open, to the page that opened it. */
export const hello = 'planish app is open';

/**
 * Adds the button to the links of a page. Only the document that answers gets the model: it sends a port of its own,
 * and where it comes from has to be where the report comes from ("null" for files, which no page of the net has).
 * @param {HTMLElement} links where it goes; `data-app` says where the app may be
 * @param {string} data of the report, as the page has it
 */
export function offerApp(links, data) {
  const place = links.dataset.app ?? '';
  const status = make('p', { role: 'status' });
  const button = make('button', { type: 'button', textContent: 'Open in the app' });
  /** @type {Window | null} */
  let app = null;
  addEventListener('message', (event) => {
    if (!app || event.source !== app || event.origin !== self.origin || event.data !== hello) return;
    const project = links.querySelector('a')?.getAttribute('href') ?? '';
    const without = links.querySelector('small')?.textContent ?? '';
    event.ports[0]?.postMessage({ data, project, without, title: document.title });
    status.textContent = 'The app has taken the model.';
  });
  button.addEventListener('click', () => {
    app = open(place);
    status.textContent =
      `The app should lie at ${place}, seen from this report. If nothing opens, write it there with "planish app", or ` +
      'open the app elsewhere and drop this report onto it.';
  });
  links.prepend(button);
  links.append(status);
}
