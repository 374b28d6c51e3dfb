// The panel's part about colours and light.

import {colorField, segments, select, slider, toggle} from './controls.js';
import {colorsOutside, gradientOf} from './colormaps.js';
import {OptionRows} from './option_rows.js';
import {h, newId} from '../page/dom.js';
import {isAcceptable} from '../view/options.js';

function swatch(name, face, ofScene) {
  const gradient = gradientOf(name, ofScene);
  face.title = name;
  if (!gradient) return;
  face.textContent = '';
  face.append(h('span', {class: 'name'}, name.split('/').pop()));
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

const BANDS = 10;  // As many as one chooses first.

/// How values are spread over the colour map, with the number of bands.
function scaleRow({model, changes}) {
  const bandsOf = (scale) => /^bands:(\d+)$/.exec(scale)?.[1];
  const set = (value) => {
    const range = model.options.shading.colorRange;
    if (value === 'log' && range && range[0] <= 0) changes.resetRange();  // It has no logarithm.
    model.setOption('shading', 'colorScale', value);
  };
  const row = segments({label: 'Scale', choices: [['linear', 'Linear'], ['log', 'Log'], ['bands', 'Bands']],
                        onInput: (value) => set(value === 'bands' ? `bands:${BANDS}` : value),
                        onReset: () => model.resetOption('shading', 'colorScale')});
  const isBands = (count) => isAcceptable(model.rules, 'shading', 'colorScale', `bands:${count}`);
  const count = h('input', {type: 'text', inputmode: 'numeric', autocomplete: 'off', class: 'number', 'aria-label': 'Number of bands'});
  const box = h('div', {class: 'own-color'}, count);
  row.element.append(box);
  count.addEventListener('change', () => {
    const isFine = isBands(count.value.trim());
    count.setAttribute('aria-invalid', String(!isFine));
    if (isFine) set(`bands:${count.value.trim()}`);
  });
  return {...row, update() {
    const scale = model.options.shading.colorScale ?? 'linear', bands = bandsOf(scale);
    row.set(bands ? 'bands' : scale, 'colorScale' in model.changed.shading);
    box.hidden = !bands;
    if (bands && document.activeElement !== count) count.value = bands;
  }};
}

export function colorPart({model, changes: asked}) {
  const shading = new OptionRows(model, 'shading');
  const isLog = () => model.options.shading.colorScale === 'log';
  const isRange = (value) => isAcceptable(model.rules, 'shading', 'colorRange', value) && (!isLog() || value[0] > 0);
  const colorBy = select({label: 'Colour by', onInput: (value) => asked.request({colorBy: value})});
  const colorMap = shading.add('colormap', segments, {
    label: 'Colour map', className: 'maps', paint: (name, face) => swatch(name, face, model.scene?.choices?.colorStops),
  });
  const scale = scaleRow({model, changes: {resetRange: () => model.resetOption('shading', 'colorRange')}});
  const outside = () => colorsOutside(model.options.shading.colormap, model.scene?.choices);
  const beyond = [['belowColor', 'Below'], ['aboveColor', 'Above'], ['nanColor', 'No number']].map(
    ([key, label]) => shading.add(key, colorField, {label, otherwise: () => outside()[key]}));
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
  const contrast = shading.add('contrast', slider, {label: 'Contrast of streaks', digits: 2});
  const blend = shading.add('blend', slider, {label: 'Strength of streaks', digits: 2});
  const lighting = shading.add('lighting', toggle, {label: 'Light'});
  const antialias = shading.add('antialias', toggle, {label: 'Smooth edges'});
  const occlusion = shading.add('occlusion', toggle, {label: 'Darker hollows'});
  const background = backgroundRow({model, onInput: (value, isMoving) => model.setOption('shading', 'background', value, isMoving),
                                    onReset: () => model.resetOption('shading', 'background')});
  let choices = null;

  // As the server draws it: a logarithmic scale begins above 0.
  const wholeRange = () => {
    const [lo, hi] = model.scene?.colorRange ?? [0, 1];
    return isLog() && lo <= 0 && hi > 0 ? [hi / 1000, hi] : [lo, hi];
  };
  const range = () => model.changed.shading.colorRange ?? wholeRange();

  function updateChoices() {
    if (!model.scene || choices === model.scene.choices) return;
    choices = model.scene.choices ?? {};
    colorBy.setChoices([['', 'Nothing'], ...(choices.colorBy ?? []).map((name) => [name, name.replace(/^(.*):mag$/, '|$1|')])]);
  }

  function update() {
    updateChoices();
    shading.update();
    const by = model.scene?.scene?.shading?.colorBy ?? '', isColored = by !== '';
    colorBy.set(asked.wish('colorBy') ?? by);
    const whole = wholeRange();
    ends.forEach((row, end) => {
      row.setRange(...whole);
      row.set(range()[end], 'colorRange' in model.changed.shading);
      row.show(isColored && whole[0] < whole[1]);
    });
    for (const row of [colorMap, scale, ...beyond]) row.show(isColored);
    scale.update();
    background.update();
  }
  return {title: 'Colour and light', update,
          elements: [colorBy, colorMap, scale, ...ends, ...beyond, blend, contrast, lighting, antialias, occlusion, background].map((row) => row.element)};
}
