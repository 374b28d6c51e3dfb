// Small helpers to make elements.

/// An element with attributes and children. An attribute that is false or null is left out; one that is true has no
/// value.
export function h(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === false || value === null || value === undefined) continue;
    element.setAttribute(name, value === true ? '' : value);
  }
  element.append(...children.filter((child) => child !== null && child !== undefined));
  return element;
}

export const byId = (id) => document.getElementById(id);

let lastId = 0;
export const newId = () => `id${++lastId}`;

/// A number as a person reads it: `digits` significant ones, without an exponent where that is short.
export function numberText(value, digits = 4) {
  if (value === 0 || !Number.isFinite(value)) return String(value);
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-4) return value.toExponential(digits - 1).replace(/\.?0+e/, 'e').replace('e+', 'e');
  return String(Number(value.toPrecision(digits)));
}

export function bytesText(bytes) {
  if (bytes < 1000) return `${bytes} B`;
  if (bytes < 1e6) return `${(bytes / 1e3).toFixed(bytes < 1e5 ? 1 : 0)} kB`;
  return `${(bytes / 1e6).toFixed(bytes < 1e8 ? 1 : 0)} MB`;
}

/// The text stored under `key`, or null; a browser may forbid both.
export function recall(key) {
  try {
    return localStorage.getItem(`aeolic.${key}`);
  } catch {
    return null;
  }
}

export function remember(key, value) {
  try {
    if (value === null) localStorage.removeItem(`aeolic.${key}`);
    else localStorage.setItem(`aeolic.${key}`, value);
  } catch {
    // A browser that stores nothing remembers nothing.
  }
}
