// The panel. It folds away, and is a sheet at the bottom of a phone's screen.

import {button, section} from './controls.js';
import {byId, h, recall, remember} from '../page/dom.js';
import {aboutPart, viewPart} from './view.js';
import {colorPart} from './color.js';
import {figurePart} from './figure.js';
import {linesPart} from './lines.js';
import {programPart} from './program.js';
import {streaksPart} from './streaks.js';
import {surfacePart} from './surface.js';

const OPEN_AT_FIRST = ['Program', 'Streaks', 'Colour and light', 'Lines', 'Figure'];
const isPhone = matchMedia('(max-width: 719px)'), isInFrame = window.top !== window;

export function makePanel(page) {
  const {model} = page, content = byId('panel-content'), toggleButton = byId('panel-button');
  const view = viewPart(page);
  const about = aboutPart(page);
  const parts = [programPart(page), streaksPart(page), colorPart(page), linesPart(page), figurePart(page), surfacePart(page), view, about];
  const remembered = recall('sections')?.split('|') ?? OPEN_AT_FIRST;
  const open = new Set(remembered);
  for (const part of parts) {
    const {title, elements} = part;
    part.section = section(title, open.has(title), (isOpen) => {
      if (isOpen) open.add(title);
      else open.delete(title);
      remember('sections', [...open].join('|'));
    }, ...elements);
    content.append(part.section);
  }
  const reset = button({label: 'Reset all options', iconName: 'undo', className: 'wide', onClick: () => model.resetOptions()});
  content.append(h('div', {class: 'section last'}, reset.element));

  function update() {
    document.body.classList.toggle('empty', !model.scene);
    for (const part of parts) {
      part.update();
      if (part.isThere) part.section.hidden = !part.isThere();
      if (part.name?.()) part.section.querySelector('summary').textContent = part.name();
    }
    reset.show(Object.keys(model.changed.lic).length + Object.keys(model.changed.shading).length > 0);
  }

  function setOpen(isOpen, isRemembered = true) {
    document.body.classList.toggle('panel-open', isOpen);
    byId('panel').inert = !isOpen;
    toggleButton.setAttribute('aria-expanded', String(isOpen));
    if (isRemembered && !isPhone.matches) remember('panel', isOpen ? 'open' : 'closed');
  }
  // In a frame, such as a notebook's cell, the picture has the room, unless there is something to steer.
  const atFirst = () => setOpen(!isPhone.matches && recall('panel') !== 'closed' && (!isInFrame || Boolean(model.scene?.program?.controls.length)), false);
  isPhone.addEventListener('change', atFirst);
  toggleButton.addEventListener('click', () => setOpen(!document.body.classList.contains('panel-open')));
  byId('panel-close').addEventListener('click', () => {
    setOpen(false);
    toggleButton.focus();
  });
  atFirst();
  update();
  let wasLoaded = false;
  model.on('scene', () => {
    if (isInFrame && !wasLoaded) atFirst();
    wasLoaded = true;
  });
  page.changes.on('changed', update);
  model.on('scene', update).on('options', update).on('camera', () => view.update()).on('warnings', () => about.update());
  return {update, toggle: () => setOpen(!document.body.classList.contains('panel-open'))};
}
