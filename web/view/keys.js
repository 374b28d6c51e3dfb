// The keyboard: what every key does stands here once, for the keys and for the page's help.

import {dolly, orbit, pan, roll} from './camera.js';

const TURN_DEG = 5, PAN_PART = 0.05, ROLL_DEG = 5, DOLLY = 1.15;
const ARROWS = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};

/// [keys, what they do]
export const HELP = [
  [['←', '→', '↑', '↓'], 'Turn'], [['Shift', '← → ↑ ↓'], 'Move sideways'], [['+', '−'], 'Closer, farther'], [['[', ']'], 'Roll'],
  [['0'], 'Reset the view'], [['1', '2'], 'From −y, from +y'], [['3', '4'], 'From +x, from −x'], [['5', '6'], 'From +z, from −z'],
  [['Space'], 'Play, pause'], [['Enter'], 'Values in the middle'], [['Esc'], 'Values and line away'], [['S'], 'Statistics'], [['P'], 'Panel'], [['F'], 'Full screen'], [['C'], 'Copy link'], [['?'], 'This help'],
];
/// [gesture, what it does]
export const POINTER_HELP = [
  ['Click, tap', 'Values at this place'], ['Drag, one finger', 'Turn'], ['Right drag, Shift + drag', 'Move sideways'], ['Ctrl + drag', 'Roll'], ['Wheel', 'Closer, farther'],
  ['Two fingers', 'Pinch and move'],
];

const AXIS_KEYS = {1: '-y', 2: '+y', 3: '+x', 4: '-x', 5: '+z', 6: '-z'};

/// `actions`: {home, axis(name), play, stats, panel, fullscreen, copyLink, help, tell}
export function watchKeys(stage, model, actions) {
  const byKey = {0: actions.home, Home: actions.home, ' ': actions.play, s: actions.stats, p: actions.panel,
                 f: actions.fullscreen, c: actions.copyLink, '?': actions.help, Enter: actions.tell};

  function moved(camera, {key, shiftKey}) {
    if (key in ARROWS) {
      const [x, y] = ARROWS[key], {clientHeight} = stage;
      return shiftKey ? pan(camera, x * PAN_PART * clientHeight, y * PAN_PART * clientHeight, clientHeight)
                      : orbit(camera, -x * TURN_DEG, y * TURN_DEG, model.vertical);
    }
    if (key === '+' || key === '=') return dolly(camera, DOLLY);
    if (key === '-' || key === '_') return dolly(camera, 1 / DOLLY);
    if (key === '[') return roll(camera, -ROLL_DEG);
    if (key === ']') return roll(camera, ROLL_DEG);
    return null;
  }

  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
    // A key that a focused control takes for itself is not for the picture.
    const focused = document.activeElement;
    if (focused?.closest('dialog, [popover]')) return;
    if (focused?.matches('input:not([type=checkbox]), select, textarea')) return;
    if (focused?.matches('button, summary, input, a') && [' ', 'Enter'].includes(event.key)) return;
    if (focused?.matches('input') && event.key in ARROWS) return;
    const action = byKey[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (action) action();
    else if (event.key in AXIS_KEYS) actions.axis(AXIS_KEYS[event.key]);
    else {
      const camera = model.camera && moved(model.camera, event);
      if (!camera) return;
      model.moveCamera(camera);
    }
    event.preventDefault();
  });
}
