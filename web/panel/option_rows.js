// The panel's rows for options of the scene: each changes one option of the viewer's own, and is told by the scene what
// the option may be.

import {isAcceptable} from '../view/options.js';

/// The choices of a rule's names as [[name, text], …]: in the order of `labels` ({name: text}), the others after them.
function choicesOf({names}, labels = {}) {
  const known = Object.keys(labels).filter((name) => names.includes(name));
  return [...known, ...names.filter((name) => !known.includes(name))].map((name) => [name, labels[name] ?? name]);
}

export class OptionRows {
  #model;
  #group;
  #rows = new Map();
  #rulesText = '';

  /// `group` 'lic' or 'shading'.
  constructor(model, group) {
    this.#model = model;
    this.#group = group;
  }

  /// A row for the option `key`: `make` is a function of controls.js, `look` what it takes beside the rules.
  add(key, make, look) {
    const model = this.#model, group = this.#group;
    const row = make({...look, onInput: (value, isMoving) => model.setOption(group, key, value, isMoving),
                      onReset: () => model.resetOption(group, key), accepts: (value) => isAcceptable(model.rules, group, key, value)});
    this.#rows.set(key, {row, labels: look.labels});
    return row;
  }

  /// Shows the values, and the ranges and choices if they are others than before.
  update() {
    const rules = this.#model.rules?.[this.#group], values = this.#model.options[this.#group];
    if (!rules) return;
    const text = JSON.stringify(rules), isNew = text !== this.#rulesText;
    this.#rulesText = text;
    for (const [key, {row, labels}] of this.#rows) {
      if (isNew && rules[key].names) row.setChoices(choicesOf(rules[key], labels));
      else if (isNew) row.setRule?.(rules[key]);
      row.set(values[key], key in this.#model.changed[this.#group]);
    }
  }
}
