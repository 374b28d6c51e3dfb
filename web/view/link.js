// The whole view as a URL's fragment, readable: #position=…&focal=…&up=…&fov=…&lic.steps=…&shading.blend=…&surface=…

import {isAcceptable, valueFromText} from './options.js';
import {specOf, timeOf} from './surface_spec.js';

const COORDINATES = ['position', 'focal', 'up'];
const SHARED = ['surface', 'vectors', 'colorBy', 'time'];

/// The fragment for what `model` shows. The camera is left out where it is the scene's own.
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

/// The parts of a Scene that all viewers share, under the names of Change.
export function sharedOf(scene) {
  const isSeries = (scene.choices?.times ?? []).length > 1;
  return {surface: specOf(scene), vectors: scene.scene?.field?.vectors ?? '', colorBy: scene.scene?.shading?.colorBy ?? '',
          time: isSeries ? timeOf(scene) : undefined};
}

/// {camera or null, changed, shared} of a fragment. What the server would not take, by the scene's `options`, is left
/// out: a link is somebody else's text.
export function parseFragment(fragment, options) {
  const parts = new URLSearchParams(fragment.replace(/^#/, '')), changed = {lic: {}, shading: {}}, shared = {};
  const read = (group, key, text) => {
    const value = text === null ? null : valueFromText(options[group][key], text);
    return isAcceptable(options, group, key, value) ? value : null;
  };
  const [position, focal, up] = COORDINATES.map((key) => read('camera', key, parts.get(key))), fovDeg = read('camera', 'fovDeg', parts.get('fov'));
  const isView = position && focal && up && fovDeg !== null && position.some((x, i) => x !== focal[i]) && up.some((x) => x !== 0);
  for (const group of ['lic', 'shading'])
    for (const key of Object.keys(options[group])) {
      const value = read(group, key, parts.get(`${group}.${key}`));
      if (value !== null) changed[group][key] = value;
    }
  for (const key of SHARED) if (parts.has(key)) shared[key] = key === 'time' ? Number(parts.get(key)) : parts.get(key);
  if (!Number.isFinite(shared.time)) delete shared.time;
  return {camera: isView ? {position, focal, up, fovDeg} : null, changed, shared};
}

/// Those parts of a link's `shared` that the scene does not show yet, or null.
export function differenceTo(scene, shared) {
  const now = sharedOf(scene), change = Object.fromEntries(Object.entries(shared).filter(([key, value]) => now[key] !== value));
  return Object.keys(change).length > 0 ? change : null;
}
