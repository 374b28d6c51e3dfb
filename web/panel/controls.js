// The panel's controls. Each is {element, set(value), show(isShown)}. `set` never calls back. `onInput(value, isMoving)`
// is called with isMoving true while a slider is dragged.

import {h, newId, numberText} from '../page/dom.js';
import {icon} from '../page/icons.js';

function control(element, set, parts = {}) {
  return {element, set, show: (isShown) => { element.hidden = !isShown; }, ...parts};
}

/// Shows `reset` (a function) as a small button while the row's value is the viewer's own.
function resetButton(label, onReset) {
  if (!onReset) return {button: null, mark() {}};
  const button = h('button', {type: 'button', class: 'reset', 'aria-label': `Reset ${label}`, title: 'As the scene says', hidden: true},
                   icon('undo'));
  button.addEventListener('click', onReset);
  return {button, mark: (isChanged) => { button.hidden = !isChanged; }};
}

/// A number by slider and by keyboard. `scale` 'log' spreads the small ones; `accepts(value)` judges typed ones, which
/// may lie beyond the slider. `setRange` or `setRule` (of an option) may set the slider's ends later; where they are no
/// range there is no slider. The value NaN stands for no value yet.
export function slider({label, unit = '', min = 0, max = 1, scale = 'linear', digits = 3, accepts = () => true, onInput, onReset}) {
  const id = newId();
  let isWhole = false;
  const toSlider = (value) => scale === 'log' ? Math.log(value / min) / Math.log(max / min) : (value - min) / (max - min);
  const fromSlider = (part) => {
    const value = scale === 'log' ? min * (max / min) ** part : min + (max - min) * part;
    if (isWhole) return Math.round(value);
    if (scale === 'log') return Number(value.toPrecision(digits));
    // Of a range far from 0 the digits tell places within it apart.
    const places = Math.max(0, Math.min(15, digits - Math.ceil(Math.log10(max - min))));
    return Math.max(min, Math.min(max, Number(value.toFixed(places))));
  };
  const shownDigits = () => {
    const usual = Math.max(4, digits), size = Math.max(Math.abs(min), Math.abs(max));
    return scale === 'log' || !(min < max) ? usual : Math.max(usual, Math.min(15, digits + Math.ceil(Math.log10(size / (max - min)))));
  };
  const range = h('input', {type: 'range', min: 0, max: 1, step: 0.001, 'aria-label': label});
  const number = h('input', {type: 'text', id, inputmode: 'decimal', autocomplete: 'off', spellcheck: 'false', class: 'number'});
  const {button, mark} = resetButton(label, onReset);
  let value = min;
  const show = () => {
    const part = Math.max(0, Math.min(1, toSlider(value)));
    range.value = part;
    range.style.setProperty('--part', part);
    range.setAttribute('aria-valuetext', `${numberText(value, shownDigits())} ${unit}`.trim());
    if (document.activeElement !== number) number.value = Number.isNaN(value) ? '' : numberText(value, shownDigits());
  };
  const set = (next, isChanged = false) => {
    value = next;
    show();
    mark(isChanged);
  };
  range.addEventListener('input', () => {
    value = fromSlider(Number(range.value));
    show();
    onInput(value, true);
  });
  range.addEventListener('change', () => onInput(value, false));
  number.addEventListener('change', () => {
    const typed = Number(number.value.replace(',', '.'));
    const isFine = number.value.trim() !== '' && Number.isFinite(typed) && (!isWhole || Number.isInteger(typed)) && accepts(typed);
    number.setAttribute('aria-invalid', String(!isFine));
    if (!isFine) return;
    value = typed;
    show();
    onInput(value, false);
  });
  number.addEventListener('blur', () => {
    number.removeAttribute('aria-invalid');
    show();
  });
  number.addEventListener('keydown', (event) => {
    if (event.key === 'Enter') number.select();
    if (event.key === 'Escape') number.blur();
  });
  const row = h('div', {class: 'row slider'}, h('label', {for: id}, label), button,
                h('span', {class: 'value'}, number, unit ? h('span', {class: 'unit'}, unit) : null), range);
  const setRange = (lo, hi) => {
    [min, max] = [lo, hi];
    range.hidden = !(lo < hi);
  };
  const setRule = ({kind, usual}) => {
    isWhole = kind === 'whole';
    setRange(...usual);
  };
  return control(row, set, {setRange, setRule});
}

/// A whole number that means nothing by itself, with a button for another one.
export function seedField({label, accepts, onInput, onReset}) {
  let [least, most] = [0, 0];
  const id = newId(), number = h('input', {type: 'text', id, inputmode: 'numeric', autocomplete: 'off', class: 'number'});
  const {button: reset, mark} = resetButton(label, onReset);
  const another = h('button', {type: 'button', class: 'plain small'}, 'Another');
  number.addEventListener('change', () => {
    const isFine = /^\d+$/.test(number.value.trim()) && accepts(Number(number.value));
    number.setAttribute('aria-invalid', String(!isFine));
    if (isFine) onInput(Number(number.value), false);
  });
  another.addEventListener('click', () => onInput(least + Math.floor(Math.random() * (most - least + 1)), false));
  return control(h('div', {class: 'row'}, h('label', {for: id}, label), reset, another, number), (value, isChanged = false) => {
    if (document.activeElement !== number) number.value = value;
    mark(isChanged);
  }, {setRule: ({usual}) => { [least, most] = usual; }});
}

/// A line of text, which counts when it is complete.
export function textField({label, placeholder = '', accepts = () => true, onInput, onReset}) {
  const id = newId(), box = h('input', {type: 'text', id, autocomplete: 'off', class: 'text', placeholder});
  const {button, mark} = resetButton(label, onReset);
  box.addEventListener('change', () => {
    const isFine = accepts(box.value);
    box.setAttribute('aria-invalid', String(!isFine));
    if (isFine) onInput(box.value, false);
  });
  return control(h('div', {class: 'row tall'}, h('label', {for: id}, label), button, box), (value, isChanged = false) => {
    if (document.activeElement !== box) box.value = value;
    mark(isChanged);
  }, {setPlaceholder: (text) => { box.placeholder = text; }});
}

/// A colour of its own, or none: then it is the one that `otherwise` gives.
export function colorField({label, otherwise, onInput, onReset}) {
  const id = newId(), box = h('input', {type: 'color', id});
  const {button, mark} = resetButton(label, onReset);
  box.addEventListener('input', () => onInput(box.value.slice(1), true));
  box.addEventListener('change', () => onInput(box.value.slice(1), false));
  return control(h('div', {class: 'row own-color'}, h('label', {for: id}, label), button, box), (value, isChanged = false) => {
    box.value = `#${value || otherwise()}`;
    mark(isChanged);
  });
}

export function toggle({label, onInput, onReset}) {
  const id = newId(), box = h('input', {type: 'checkbox', role: 'switch', id});
  const {button, mark} = resetButton(label, onReset);
  box.addEventListener('change', () => onInput(box.checked, false));
  return control(h('div', {class: 'row'}, h('label', {for: id}, label), button, box), (value, isChanged = false) => {
    box.checked = value;
    mark(isChanged);
  });
}

/// `choices`: [[value, text], …], or set later by setChoices.
export function select({label, choices = [], onInput, onReset}) {
  const id = newId(), box = h('select', {id});
  const {button, mark} = resetButton(label, onReset);
  const setChoices = (list) => box.replaceChildren(...list.map(([value, text]) => h('option', {value}, text)));
  setChoices(choices);
  box.addEventListener('change', () => onInput(box.value, false));
  return control(h('div', {class: 'row'}, h('label', {for: id}, label), button, box), (value, isChanged = false) => {
    box.value = value;
    mark(isChanged);
  }, {setChoices});
}

/// One choice of a few that are all in sight. `paint(value, span)` may draw a choice instead of its text.
export function segments({label, choices = [], onInput, onReset, className = '', paint = null}) {
  const name = newId(), labelId = newId(), group = h('div', {class: `segments ${className}`.trim(), role: 'radiogroup', 'aria-labelledby': labelId});
  const {button, mark} = resetButton(label, onReset);
  const setChoices = (list) => group.replaceChildren(...list.map(([value, text]) => {
    const radio = h('input', {type: 'radio', name, value}), face = h('span', {}, text);
    paint?.(value, face);
    radio.addEventListener('change', () => onInput(value, false));
    return h('label', {}, radio, face);
  }));
  setChoices(choices);
  const row = h('div', {class: 'row tall'}, h('span', {id: labelId, class: 'label'}, label), button, group);
  return control(row, (value, isChanged = false) => {
    for (const radio of group.querySelectorAll('input')) radio.checked = radio.value === String(value);
    mark(isChanged);
  }, {setChoices});
}

export function button({label, iconName = null, onClick, className = ''}) {
  const element = h('button', {type: 'button', class: `plain ${className}`.trim()}, iconName ? icon(iconName) : null, label);
  element.addEventListener('click', onClick);
  return control(element, () => {});
}

/// A part of the panel that folds; whether it is open is remembered by the caller.
export function section(title, isOpen, onToggle, ...children) {
  const element = h('details', {class: 'section', open: isOpen}, h('summary', {}, title), h('div', {class: 'rows'}, ...children));
  element.addEventListener('toggle', () => onToggle(element.open));
  return element;
}
