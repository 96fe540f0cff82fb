// Elements made in code. Text only ever becomes text nodes, whatever it holds.

const SVG = "http://www.w3.org/2000/svg";

/** An element; `on…` properties listen, `class`, `aria-…` and the like are attributes. */
export function h(tag, props = {}, ...children) {
  return fill(document.createElement(tag), props, children);
}

/** An element of a drawing. */
export function svg(tag, props = {}, ...children) {
  return fill(document.createElementNS(SVG, tag), props, children);
}

function fill(element, props, children) {
  for (const [name, value] of Object.entries(props)) {
    if (value === null || value === undefined || value === false) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children.filter((child) => child !== null && child !== undefined));
  return element;
}

/** A button with a picture: an SVG path in a box of 24 by 24, and a name. */
export function iconButton(name, path, onclick, props = {}) {
  const icon = svg("svg", { viewBox: "0 0 24 24", "aria-hidden": "true" }, svg("path", { d: path }));
  return h("button", { type: "button", class: "icon", "aria-label": name, title: name, onclick, ...props }, icon);
}

/** A new picture for a button. */
export function setIcon(button, name, path) {
  button.setAttribute("aria-label", name);
  button.title = name;
  button.querySelector("path").setAttribute("d", path);
}

/** Text that is only written when it changes. */
export function setText(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

export const KMH = 3.6;

/** A number with so many decimals and a real minus; a dash where there is none. */
export function number(value, digits = 1) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  const text = value.toFixed(digits);
  return Number(text) === 0 ? text.replace("-", "") : text.replace("-", "−");
}
