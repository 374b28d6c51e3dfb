// Short messages at the picture's lower edge; errors stay until they are closed.

import {byId, h} from './dom.js';
import {icon} from './icons.js';
import {inPageWords} from './words.js';

const STAYS_MS = 5000;
const MOST = 3;

/// level: info | warning | error; action: {label, run} or null.
export function toast(said, level = 'info', action = null) {
  const text = inPageWords(said);
  const list = byId('toasts');
  for (const old of list.children) if (old.dataset.text === text) old.remove();
  const close = h('button', {type: 'button', class: 'close', 'aria-label': 'Close'}, icon('close'));
  const item = h('div', {class: `toast ${level}`, role: level === 'error' ? 'alert' : null, 'data-text': text}, h('span', {}, text));
  if (action) {
    const button = h('button', {type: 'button', class: 'plain'}, action.label);
    button.addEventListener('click', () => {
      item.remove();
      action.run();
    });
    item.append(button);
  }
  item.append(close);
  close.addEventListener('click', () => item.remove());
  list.append(item);
  while (list.children.length > MOST) list.firstChild.remove();
  if (level !== 'error' && !action) setTimeout(() => item.remove(), STAYS_MS);
}
