// Which surfaces are shown, as text: a file or a built-in surface | boundary | slice:OX,OY,OZ:NX,NY,NZ |
// isosurface:ARRAY=VALUE. The last three are cut out of the field.

const AXES = ['x', 'y', 'z'];

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

export const isCut = (spec) => parseSpec(spec).kind !== 'original';

/// The axis (0, 1, 2) that a slice's normal lies along, or -1.
export const axisOf = (normal) => normal.findIndex((x, i) => x !== 0 && normal.every((other, k) => k === i || other === 0));

/// All surfaces of a scene: [{spec, shown, …}].
export const surfacesOf = (scene) => scene?.surfaces ?? (scene?.surface?.spec ? [scene.surface] : []);

/// The specs of all surfaces of a scene.
export const specsOf = (scene) => surfacesOf(scene).map(({spec}) => spec).filter(Boolean);

// Coordinates as one reads them, without the last digits of sums. Places far from the origin need more of them.
const coordinate = (x) => String(Number(x.toPrecision(Math.abs(x) < 1e4 ? 6 : 10)));

/// What a person calls a surface: "case:walls" of "/data/case:walls", "Slice x = 0.5" of "slice:0.5,0,0:1,0,0".
export function shortName(spec) {
  const cut = parseSpec(spec);
  if (cut.kind === 'boundary') return 'Boundary';
  if (cut.kind === 'isosurface') return `Isosurface ${cut.array} = ${coordinate(cut.value)}`;
  if (cut.kind === 'original') return spec.split('/').at(-1);
  const axis = axisOf(cut.normal);
  if (axis >= 0) return `Slice ${AXES[axis]} = ${coordinate(cut.origin[axis])}`;
  return `Slice through ${cut.origin.map(coordinate).join(', ')}`;
}

/// The names of several surfaces, each different: equal ones are counted.
export function namesOf(specs) {
  const seen = new Map();
  return specs.map(shortName).map((name) => {
    const count = (seen.get(name) ?? 0) + 1;
    seen.set(name, count);
    return count === 1 ? name : `${name} (${count})`;
  });
}

/// The time that a Scene shows, or undefined if it does not say.
export function timeOf(message) {
  const time = message.time ?? message.scene?.time?.moment;
  return typeof time === 'number' ? time : undefined;
}
