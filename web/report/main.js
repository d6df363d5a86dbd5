// Turns the still pictures of a report into a view that can be turned, where the browser can do it.
import { make } from '../viewer/dom.js';
import { spaceCanvas } from '../viewer/patch_view.js';
import { unpack } from './data.js';
import { offerApp } from './hand_over.js';
import { Page } from './page.js';
import { unpackProduct } from './product_data.js';
import { ProductPage } from './product_page.js';

const block = document.getElementById('report-data');
const stage = document.getElementById('stage');
const links = /** @type {HTMLElement | null} */ (document.querySelector('.app'));
if (block && links) offerApp(links, block.textContent ?? '');
if (block && stage) {
  const space = spaceCanvas();
  if (space) {
    document.documentElement.classList.add('live');
    const packed = JSON.parse(block.textContent ?? '');
    if (packed.pieces) new ProductPage(stage, unpackProduct(packed), space);
    else new Page(stage, unpack(packed), space);
  } else {
    const textContent = 'This browser cannot draw in space (no WebGL); here are still pictures.';
    stage.append(make('p', { className: 'hint', textContent }));
  }
}
