// The panel's part with the controls of the program that shows its scene: sliders, switches and buttons. They are shared
// by all viewers.

import {button, slider, toggle} from './controls.js';
import {h} from '../page/dom.js';

export function programPart({model, changes}) {
  const rows = h('div', {class: 'program'});
  let made = '', controls = [];
  const steer = (name, value) => changes.request({steer: {[name]: value}});

  function controlOf({name, kind, lo, hi, unit}) {
    if (kind === 'toggle') return toggle({label: name, onInput: (isOn) => steer(name, isOn ? 1 : 0)});
    if (kind === 'number')
      return slider({label: name, unit, min: lo, max: hi, accepts: (value) => value >= lo && value <= hi, onInput: (value) => steer(name, value)});
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
    if (changes.isBusy) return;  // What this viewer has just chosen is newer than what it hears.
    controls.forEach((control, i) => control.set(told[i].kind === 'toggle' ? told[i].value !== 0 : told[i].value));
  }
  return {title: 'Program', name: () => model.scene?.program?.title, isThere: () => controls.length > 0, update, elements: [rows]};
}
