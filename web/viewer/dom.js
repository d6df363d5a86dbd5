// Making elements of a page.

/**
 * An element with properties and children. What `dataset` holds goes to the element's.
 * @template {keyof HTMLElementTagNameMap} Name
 * @param {Name} name
 * @param {{dataset?: Record<string, string>, [property: string]: unknown}} [properties]
 * @param {(Node | string)[]} children
 * @returns {HTMLElementTagNameMap[Name]}
 */
export function make(name, properties = {}, ...children) {
  const made = document.createElement(name);
  const { dataset, ...plain } = properties;
  Object.assign(made, plain);
  Object.assign(made.dataset, dataset);
  made.append(...children);
  return made;
}

/**
 * An element of SVG with attributes.
 * @template {keyof SVGElementTagNameMap} Name
 * @param {Name} name
 * @param {Record<string, string>} attributes
 * @param {Node[]} children
 * @returns {SVGElementTagNameMap[Name]}
 */
export function makeSvg(name, attributes, ...children) {
  const made = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

/**
 * A number of things with thin spaces between thousands.
 * @param {number} count
 */
export function countText(count) {
  return count.toLocaleString('en').replaceAll(',', '\u202f');
}
