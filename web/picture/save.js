// Files for keeping: the picture as PNG, pixel for pixel what the server drew, and the scene for `aeolic render`.

import {h} from '../page/dom.js';
import {pngEncode} from './png.js';

const two = (number) => String(number).padStart(2, '0');

function fileName(ending) {
  const now = new Date();
  return `aeolic-${now.getFullYear()}${two(now.getMonth() + 1)}${two(now.getDate())}-` +
         `${two(now.getHours())}${two(now.getMinutes())}${two(now.getSeconds())}.${ending}`;
}

function download(blob, name) {
  const url = URL.createObjectURL(blob), link = h('a', {href: url, download: name});
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 60000);  // Some browsers read it only after the person chose where.
}

/// The scene file that draws what `model` shows at `size` pixels. A camera is absolute in it.
export function sceneFile(model, size) {
  const {scene} = model.scene, {camera, lic, shading} = model.viewGroups(false);
  if (lic.flow === 'loop') lic.phase = model.options.lic.phase;  // Where the cycle begins, not where it is.
  return {version: 1, ...scene, lic: {...scene.lic, ...lic}, shading: {...scene.shading, ...shading}, camera,
          output: {width: size.width, height: size.height}};
}

export function saveScene(model, size) {
  const text = JSON.stringify(sceneFile(model, size), null, 2) + '\n';
  download(new Blob([text], {type: 'application/json'}), fileName('json'));
}

/// `frame` must be lossless: its pixels are the server's.
export async function savePicture(frame) {
  download(await pngEncode(frame.pixels, frame.width, frame.height), fileName('png'));
}
