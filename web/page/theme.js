// Light or dark colours: what the system says, until a person chooses.

import {byId, recall, remember} from './dom.js';
import {setIcon} from './icons.js';

const system = matchMedia('(prefers-color-scheme: dark)');

/// onChange(stageColor) is called with the stage's colour as RRGGBB, now and whenever it changes.
export function watchTheme(onChange) {
  const button = byId('theme-button'), root = document.documentElement;
  let chosen = recall('theme');

  function apply() {
    const isDark = chosen ? chosen === 'dark' : system.matches;
    root.dataset.theme = isDark ? 'dark' : 'light';
    setIcon(button, isDark ? 'sun' : 'moon');
    button.setAttribute('aria-label', isDark ? 'Light colours' : 'Dark colours');
    button.title = isDark ? 'Light colours' : 'Dark colours';
    onChange(isDark ? getComputedStyle(root).getPropertyValue('--stage').trim().slice(1) : null);
  }
  button.addEventListener('click', () => {
    const isDark = root.dataset.theme !== 'dark';
    chosen = isDark === system.matches ? null : isDark ? 'dark' : 'light';
    remember('theme', chosen);
    apply();
  });
  system.addEventListener('change', apply);
  apply();
}
