// The panel's part about colours and light.

import {segments, select, slider, toggle} from './controls.js';
import {gradientOf} from './colormaps.js';
import {OptionRows} from './option_rows.js';
import {h, newId} from '../page/dom.js';
import {isAcceptable} from '../view/options.js';

function swatch(name, face) {
  const gradient = gradientOf(name);
  face.title = name;
  if (!gradient) return;
  face.textContent = '';
  face.append(h('span', {class: 'name'}, name));
  face.style.setProperty('--map', gradient);
  face.classList.add('painted');
}

function backgroundRow({model, onInput, onReset}) {
  const id = newId(), color = h('input', {type: 'color', id, 'aria-label': 'Background colour'});
  const row = segments({label: 'Background', choices: [['page', 'Page'], ['ffffff', 'White'], ['000000', 'Black'], ['transparent', 'None'], ['own', 'Own']],
                        onInput: (value) => value === 'page' ? onReset() : value === 'own' ? onInput(color.value.slice(1)) : onInput(value)});
  row.element.append(h('div', {class: 'own-color'}, color));
  color.addEventListener('input', () => onInput(color.value.slice(1), true));
  color.addEventListener('change', () => onInput(color.value.slice(1), false));
  const named = ['ffffff', '000000', 'transparent'];
  return {...row, update() {
    const chosen = model.changed.shading.background;
    row.set(chosen === undefined ? 'page' : named.includes(chosen) ? chosen : 'own');
    color.parentElement.hidden = chosen === undefined || named.includes(chosen);
    if (chosen && chosen !== 'transparent') color.value = `#${chosen}`;
  }};
}

export function colorPart({model, changes}) {
  const shading = new OptionRows(model, 'shading');
  const isRange = (value) => isAcceptable(model.rules, 'shading', 'colorRange', value);
  const colorBy = select({label: 'Colour by', onInput: (value) => changes.request({colorBy: value})});
  const colorMap = shading.add('colorMap', segments, {label: 'Colour map', className: 'maps', paint: swatch});
  const ends = ['Lowest', 'Highest'].map((label, end) => slider({
    label, digits: 4,
    accepts: (value) => isRange(end === 0 ? [value, range()[1]] : [range()[0], value]),
    onInput: (value, isMoving) => {
      const next = [...range()];
      next[end] = value;
      if (isRange(next)) model.setOption('shading', 'colorRange', next, isMoving);
      else update();
    },
    onReset: () => model.resetOption('shading', 'colorRange'),
  }));
  const scalarBar = shading.add('scalarBar', toggle, {label: 'Scalar bar'});
  const contrast = shading.add('contrast', slider, {label: 'Contrast of streaks', digits: 2});
  const blend = shading.add('blend', slider, {label: 'Strength of streaks', digits: 2});
  const lighting = shading.add('lighting', toggle, {label: 'Light'});
  const antialias = shading.add('antialias', toggle, {label: 'Smooth edges'});
  const background = backgroundRow({model, onInput: (value, isMoving) => model.setOption('shading', 'background', value, isMoving),
                                    onReset: () => model.resetOption('shading', 'background')});
  let choices = null;

  const range = () => model.changed.shading.colorRange ?? model.scene?.colorRange ?? [0, 1];

  function updateChoices() {
    if (!model.scene || choices === model.scene.choices) return;
    choices = model.scene.choices ?? {};
    colorBy.setChoices([['', 'Nothing'], ...(choices.colorBy ?? []).map((name) => [name, name.replace(/^(.*):mag$/, '|$1|')])]);
  }

  function update() {
    updateChoices();
    shading.update();
    const by = model.scene?.scene?.shading?.colorBy ?? '', isColored = by !== '';
    colorBy.set(by);
    const whole = model.scene?.colorRange ?? [0, 1];
    ends.forEach((row, end) => {
      row.setRange(...whole);
      row.set(range()[end], 'colorRange' in model.changed.shading);
      row.show(isColored && whole[0] < whole[1]);
    });
    colorMap.show(isColored);
    scalarBar.show(isColored);
    background.update();
  }
  return {title: 'Colour and light', update,
          elements: [colorBy, colorMap, ...ends, scalarBar, blend, contrast, lighting, antialias, background].map((row) => row.element)};
}
