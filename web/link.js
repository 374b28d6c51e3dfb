// The whole view as a URL's fragment, readable: #position=…&focal=…&up=…&fov=…&lic.steps=…&shading.blend=…&surface=…

import {DEFAULTS, isAcceptable} from './options.js';
import {specOf, timeOf} from './surface_spec.js';

const COORDINATES = ['position', 'focal', 'up'];
const SHARED = ['surface', 'vectors', 'colorBy', 'time'];

/// The fragment for what `model` shows. `home`: the camera is left out where it is the scene's own.
export function fragmentOf(model) {
  const parts = new URLSearchParams(), {camera, scene} = model;
  if (camera && !model.isHome) {
    for (const key of COORDINATES) parts.set(key, camera[key].join(','));
    parts.set('fov', camera.fovDeg);
  }
  for (const group of ['lic', 'shading'])
    for (const [key, value] of Object.entries(model.changed[group])) parts.set(`${group}.${key}`, Array.isArray(value) ? value.join(',') : value);
  if (scene) {
    const shared = sharedOf(scene);
    for (const key of SHARED) if (shared[key] !== undefined && shared[key] !== '') parts.set(key, shared[key]);
  }
  return parts.toString().replaceAll('%2C', ',').replaceAll('%3A', ':');
}

/// What all viewers share of a Scene, as Change names it.
export function sharedOf(scene) {
  const isSeries = (scene.choices?.times ?? []).length > 1;
  return {surface: specOf(scene), vectors: scene.scene?.field?.vectors ?? '', colorBy: scene.scene?.shading?.colorBy ?? '',
          time: isSeries ? timeOf(scene) : undefined};
}

function valueOf(text, like) {
  if (typeof like === 'number') return text.trim() === '' ? NaN : Number(text);
  if (typeof like === 'boolean') return text === 'true' ? true : text === 'false' ? false : null;
  return like === null ? text.split(',').map(Number) : text;
}

/// {camera or null, changed, shared} of a fragment. What the server would not take is left out: a link is somebody
/// else's text.
export function parseFragment(fragment) {
  const parts = new URLSearchParams(fragment.replace(/^#/, '')), changed = {lic: {}, shading: {}}, shared = {};
  const vectors = COORDINATES.map((key) => (parts.get(key) ?? '').split(',').map(Number)), fovDeg = Number(parts.get('fov'));
  const isSound = vectors.every((v) => v.length === 3 && v.every((x) => Number.isFinite(x) && Math.abs(x) <= 1e30)) &&
                  COORDINATES.every((key) => parts.has(key)) && fovDeg >= 1 && fovDeg <= 170;
  const [position, focal, up] = vectors;
  const isView = isSound && position.some((x, i) => x !== focal[i]) && up.some((x) => x !== 0);
  for (const group of ['lic', 'shading'])
    for (const key of Object.keys(DEFAULTS[group])) {
      const text = parts.get(`${group}.${key}`);
      if (text === null) continue;
      const value = valueOf(text, DEFAULTS[group][key]);
      if (isAcceptable(group, key, value)) changed[group][key] = value;
    }
  for (const key of SHARED) if (parts.has(key)) shared[key] = key === 'time' ? Number(parts.get(key)) : parts.get(key);
  if (!Number.isFinite(shared.time)) delete shared.time;
  return {camera: isView ? {position, focal, up, fovDeg} : null, changed, shared};
}

/// What of `shared` (of a link) the scene does not show yet, or null.
export function differenceTo(scene, shared) {
  const now = sharedOf(scene), change = Object.fromEntries(Object.entries(shared).filter(([key, value]) => now[key] !== value));
  return Object.keys(change).length > 0 ? change : null;
}
