// The panel's part about colours and light.

import {segments, select, slider, toggle} from './controls.js';
import {gradientOf} from './colormaps.js';
import {h, newId} from './dom.js';
import {isAcceptable} from './options.js';

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
  const rules = (key) => ({
    onInput: (value, isMoving) => model.setOption('shading', key, value, isMoving),
    onReset: () => model.resetOption('shading', key),
    accepts: (value) => isAcceptable('shading', key, value),
  });
  const colorBy = select({label: 'Colour by', onInput: (value) => changes.request({colorBy: value})});
  const colorMap = segments({label: 'Colour map', className: 'maps', paint: swatch, ...rules('colorMap')});
  const ends = ['Lowest', 'Highest'].map((label, end) => slider({
    label, min: 0, max: 1, digits: 4,
    accepts: (value) => isAcceptable('shading', 'colorRange', end === 0 ? [value, range()[1]] : [range()[0], value]),
    onInput: (value, isMoving) => {
      const next = [...range()];
      next[end] = value;
      if (isAcceptable('shading', 'colorRange', next)) model.setOption('shading', 'colorRange', next, isMoving);
      else update();
    },
    onReset: () => model.resetOption('shading', 'colorRange'),
  }));
  const rows = {
    scalarBar: toggle({label: 'Scalar bar', ...rules('scalarBar')}),
    contrast: slider({label: 'Contrast of streaks', min: 0, max: 4, digits: 2, ...rules('contrast')}),
    blend: slider({label: 'Strength of streaks', min: 0, max: 1, digits: 2, ...rules('blend')}),
    lighting: toggle({label: 'Light', ...rules('lighting')}),
  };
  const background = backgroundRow({model, ...rules('background')});
  let choices = null;

  const range = () => model.changed.shading.colorRange ?? model.scene?.colorRange ?? [0, 1];

  function updateChoices() {
    if (!model.scene || choices === model.scene.choices) return;
    choices = model.scene.choices ?? {};
    colorBy.setChoices([['', 'Nothing'], ...(choices.colorBy ?? []).map((name) => [name, name.replace(/^(.*):mag$/, '|$1|')])]);
    colorMap.setChoices((choices.colorMaps ?? []).map((name) => [name, name]));
  }

  function update() {
    updateChoices();
    const {shading} = model.options, by = model.scene?.scene?.shading?.colorBy ?? '', isColored = by !== '';
    colorBy.set(by);
    colorMap.set(shading.colorMap, 'colorMap' in model.changed.shading);
    const whole = model.scene?.colorRange ?? [0, 1];
    ends.forEach((row, end) => {
      row.setRange(...whole);
      row.set(range()[end], 'colorRange' in model.changed.shading);
      row.show(isColored && whole[0] < whole[1]);
    });
    for (const [key, row] of Object.entries(rows)) row.set(shading[key], key in model.changed.shading);
    colorMap.show(isColored);
    rows.scalarBar.show(isColored);
    background.update();
  }
  const {scalarBar, contrast, blend, lighting} = rows;
  return {title: 'Colour and light', update,
          elements: [colorBy, colorMap, ...ends, scalarBar, blend, contrast, lighting, background].map((row) => row.element)};
}
