// The layers of the drawing of the pattern, which the lines of its key switch on and off.
import { make } from '../viewer/dom.js';

/**
 * Puts a box to tick in front of each line of the key.
 * @param {SVGSVGElement} svg
 * @param {Element} key its items with `data-layer` name elements of the drawing
 */
export function addLayerSwitches(svg, key) {
  for (const item of /** @type {NodeListOf<HTMLElement>} */ (key.querySelectorAll('li[data-layer]'))) {
    const layer = /** @type {SVGElement | null} */ (svg.querySelector(`#${item.dataset.layer}`));
    if (!layer) continue;
    const box = make('input', { type: 'checkbox', checked: true });
    box.addEventListener('change', () => layer.style.setProperty('display', box.checked ? '' : 'none'));
    item.append(make('label', {}, box, ...item.childNodes));
  }
}
