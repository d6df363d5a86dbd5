// Turns the still pictures of a report into a view that can be turned, where the browser can do it.
import { make } from '../viewer/dom.js';
import { spaceCanvas } from '../viewer/patch_view.js';
import { unpack } from './data.js';
import { Page } from './page.js';

const block = document.getElementById('report-data');
const stage = document.getElementById('stage');
if (block && stage) {
  const space = spaceCanvas();
  if (space) {
    document.documentElement.classList.add('live');
    new Page(stage, unpack(JSON.parse(block.textContent ?? '')), space);
  } else {
    const textContent = 'This browser cannot draw in space (no WebGL); here are still pictures.';
    stage.append(make('p', { className: 'hint', textContent }));
  }
}
