// The panel's part about the camera, and facts of the scene.

import {roll} from '../view/camera.js';
import {button, slider} from './controls.js';
import {h} from '../page/dom.js';
import {isAcceptable} from '../view/options.js';
import {inPageWords} from '../page/words.js';
import {isCut, shortName, specsOf} from '../view/surface_spec.js';

const VIEWS = ['-y', '+y', '+x', '-x', '+z', '-z'];

export function viewPart({model, actions}) {
  const views = h('div', {class: 'views', role: 'group', 'aria-label': 'Look from'},
                  ...VIEWS.map((name) => {
                    const text = name.replace('-', '−');
                    const {element} = button({label: text, onClick: () => actions.axis(name)});
                    element.setAttribute('aria-label', `Look from ${name[0] === '-' ? 'minus' : 'plus'} ${name[1]}`);
                    return element;
                  }));
  const fov = slider({label: 'Field of view', unit: '°', digits: 3,
                      accepts: (value) => isAcceptable(model.rules, 'camera', 'fov', value), onInput: (fovDeg, isMoving) => model.setLens(fovDeg, isMoving)});
  const turns = h('div', {class: 'views two'},
                  button({label: 'Roll left', onClick: () => model.setCamera(roll(model.camera, -15), false)}).element,
                  button({label: 'Roll right', onClick: () => model.setCamera(roll(model.camera, 15), false)}).element);
  const reset = button({label: 'Reset the view', iconName: 'home', className: 'wide', onClick: actions.home}).element;
  return {title: 'View', elements: [h('div', {class: 'row tall'}, h('span', {class: 'label'}, 'Look from'), views), turns, fov.element, reset],
          update() {
            if (!model.camera) return;
            fov.setRule(model.rules.camera.fov);
            fov.set(model.camera.fov);
          }};
}

const count = (number, one, many) => `${number.toLocaleString('en')} ${number === 1 ? one : many}`;

// Ranks may have different numbers of threads.
function threadsOf(ofRank) {
  const least = Math.min(...ofRank), most = Math.max(...ofRank);
  return least === most ? `${count(most, 'thread', 'threads')} each` : `${least} to ${most} threads each`;
}

export function aboutPart({model}) {
  const list = h('dl', {class: 'facts'}), warnings = h('ul', {class: 'warnings'});
  return {title: 'About the scene', elements: [list, warnings], update() {
    const {scene} = model;
    if (!scene) return;
    const facts = [
      ['Surface', specsOf(scene.scene).map((spec) => (isCut(spec) ? shortName(spec) : spec)).join(', ')], ['Field', scene.scene?.field?.spec], ['Vectors', scene.scene?.field?.vectors],
      ['Size', typeof scene.triangles === 'number' ? count(scene.triangles, 'triangle', 'triangles') : null],
      ['Drawn by', [scene.backend, scene.device].filter(Boolean).join(', ')],
      ['On', scene.ranks ? `${count(scene.ranks, 'rank', 'ranks')}, ${threadsOf(scene.threads)}` : null],
      ['Loaded in', typeof scene.loadMs === 'number' ? `${(scene.loadMs / 1000).toFixed(1)} s` : null],
    ].filter(([, value]) => value);
    list.replaceChildren(...facts.flatMap(([name, value]) => [h('dt', {}, name), h('dd', {}, String(value))]));
    const lines = [...scene.warnings ?? [], ...model.pictureWarnings];
    warnings.replaceChildren(...lines.map((text) => h('li', {}, inPageWords(text))));
    warnings.hidden = lines.length === 0;
  }};
}
