// The panel. It folds away, and is a sheet at the bottom of a phone's screen.

import {button, section} from './controls.js';
import {byId, h, recall, remember} from '../page/dom.js';
import {aboutPart, viewPart} from './view.js';
import {colorPart} from './color.js';
import {figurePart} from './figure.js';
import {streaksPart} from './streaks.js';
import {surfacePart} from './surface.js';

const OPEN_AT_FIRST = ['Streaks', 'Colour and light', 'Figure'];
const isPhone = matchMedia('(max-width: 719px)');

export function makePanel(page) {
  const {model} = page, content = byId('panel-content'), toggleButton = byId('panel-button');
  const view = viewPart(page);
  const parts = [streaksPart(page), colorPart(page), figurePart(page), surfacePart(page), view, aboutPart(page)];
  const remembered = recall('sections')?.split('|') ?? OPEN_AT_FIRST;
  const open = new Set(remembered);
  for (const {title, elements} of parts)
    content.append(section(title, open.has(title), (isOpen) => {
      if (isOpen) open.add(title);
      else open.delete(title);
      remember('sections', [...open].join('|'));
    }, ...elements));
  const reset = button({label: 'Reset all options', iconName: 'undo', className: 'wide', onClick: () => model.resetOptions()});
  content.append(h('div', {class: 'section last'}, reset.element));

  function update() {
    document.body.classList.toggle('empty', !model.scene);
    for (const part of parts) part.update();
    reset.show(Object.keys(model.changed.lic).length + Object.keys(model.changed.shading).length > 0);
  }

  function setOpen(isOpen, isRemembered = true) {
    document.body.classList.toggle('panel-open', isOpen);
    byId('panel').inert = !isOpen;
    toggleButton.setAttribute('aria-expanded', String(isOpen));
    if (isRemembered && !isPhone.matches) remember('panel', isOpen ? 'open' : 'closed');
  }
  const atFirst = () => setOpen(!isPhone.matches && recall('panel') !== 'closed', false);
  isPhone.addEventListener('change', atFirst);
  toggleButton.addEventListener('click', () => setOpen(!document.body.classList.contains('panel-open')));
  byId('panel-close').addEventListener('click', () => {
    setOpen(false);
    toggleButton.focus();
  });
  atFirst();
  update();
  model.on('scene', update).on('options', update).on('camera', () => view.update());
  return {update, toggle: () => setOpen(!document.body.classList.contains('panel-open'))};
}
