// The panel's part with the controls of the program that shows its scene: sliders, switches and buttons. They are shared
// by all viewers.

import {button, slider, toggle} from './controls.js';
import {h} from '../page/dom.js';

export function programPart({model, changes}) {
  const rows = h('div', {class: 'program'});
  let made = '', controls = [];
  const steer = (name, value, isMoving = false) => changes.request({steer: {[name]: value}}, isMoving);

  function controlOf({name, kind, lo, hi, unit}) {
    if (kind === 'toggle') return toggle({label: name, onInput: (isOn) => steer(name, isOn ? 1 : 0)});
    if (kind === 'number')
      return slider({label: name, unit, min: lo, max: hi, accepts: (value) => value >= lo && value <= hi, onInput: (value, isMoving) => steer(name, value, isMoving)});
    let pressed = 0;
    const press = button({label: name, className: 'wide', onClick: () => steer(name, ++pressed)});
    return {...press, set: (times) => { pressed = times; }};
  }

  function update() {
    const told = model.scene?.program?.controls ?? [];
    const names = JSON.stringify(told.map(({value, ...rest}) => rest));
    if (names !== made) {
      made = names;
      controls = told.map(controlOf);
      rows.replaceChildren(...controls.map((control) => control.element));
    }
    controls.forEach((control, i) => {
      const value = changes.wish(`steer:${told[i].name}`) ?? told[i].value;
      control.set(told[i].kind === 'toggle' ? value !== 0 : value);
    });
  }
  return {title: 'Program', name: () => model.scene?.program?.title, isThere: () => controls.length > 0, update, elements: [rows]};
}
