// Which surface is shown, as text: original | boundary | slice:OX,OY,OZ:NX,NY,NZ | isosurface:ARRAY=VALUE.

const numbers = (text) => text.split(',').map(Number);
const isVector = (list) => list.length === 3 && list.every(Number.isFinite);

/// Takes a spec apart: {kind, …}. What is not cut out of the field is `original`.
export function parseSpec(spec) {
  const text = String(spec ?? '');
  if (text === 'boundary') return {kind: 'boundary'};
  if (text.startsWith('slice:')) {
    const [origin, normal] = text.slice(6).split(':').map(numbers);
    if (normal && isVector(origin) && isVector(normal)) return {kind: 'slice', origin, normal};
  }
  if (text.startsWith('isosurface:')) {
    const at = text.lastIndexOf('='), value = Number(text.slice(at + 1));
    if (at > 11 && Number.isFinite(value)) return {kind: 'isosurface', array: text.slice(11, at), value};
  }
  return {kind: 'original'};
}

export function specText({kind, origin, normal, array, value}) {
  if (kind === 'slice') return `slice:${origin.join(',')}:${normal.join(',')}`;
  if (kind === 'isosurface') return `isosurface:${array}=${value}`;
  return kind;
}

/// The specs of all surfaces of a scene.
export const specsOf = (scene) => (scene?.surfaces ?? [scene?.surface]).map((one) => one?.spec).filter(Boolean);

/// "case:walls" of "/data/case:walls". What is cut out of the field keeps its whole name.
export const shortName = (spec) => (parseSpec(spec).kind === 'original' ? spec.split('/').at(-1) : spec);

/// The spec that a Scene shows, under the name that a Change gives it.
export function specOf(message) {
  return message.surface ?? specText(parseSpec(message.scene?.surface?.spec));
}

/// The time that a Scene shows, or undefined if it does not say.
export function timeOf(message) {
  const time = message.time ?? message.scene?.time?.moment;
  return typeof time === 'number' ? time : undefined;
}
