// The small cross of axes in the corner: shows how the view is turned, and each end is a button that looks from there.

import {axesOf} from './camera.js';
import {h} from '../page/dom.js';
import {dot} from './vec3.js';

const RADIUS_PX = 30, ROOM_PX = 48;  // From the middle to the ends, and to all that one can press.
const SVG = 'http://www.w3.org/2000/svg';

/// `isOwnView()`: whether the picture shows where the model looks.
export function makeAxes(host, model, onAxis, isOwnView) {
  const lines = document.createElementNS(SVG, 'svg');
  lines.setAttribute('viewBox', '-44 -44 88 88');
  lines.setAttribute('aria-hidden', 'true');
  host.append(lines);
  const ends = ['x', 'y', 'z'].flatMap((letter, axis) => [1, -1].map((sign) => {
    const name = (sign > 0 ? '+' : '-') + letter, spoken = `${sign > 0 ? 'plus' : 'minus'} ${letter}`;
    const button = h('button', {type: 'button', class: `axis ${letter}${sign < 0 ? ' minus' : ''}`,
                                'aria-label': `Look from ${spoken}`, title: `Look from ${sign > 0 ? '+' : '−'}${letter}`},
                     sign > 0 ? letter : '');
    button.addEventListener('click', () => onAxis(name));
    host.append(button);
    let line = null;
    if (sign > 0) {
      line = document.createElementNS(SVG, 'line');
      line.setAttribute('class', letter);
      lines.append(line);
    }
    const direction = [0, 0, 0];
    direction[axis] = sign;
    return {button, line, direction};
  }));

  /// The legend of the picture may stand in the axes' corner. Then they stand beside it. `legend`: its edges on the stage, or null.
  function keepClearOf(legend) {
    host.style.left = '';  // The style sheet's own.
    if (host.hidden || !legend) return;
    const middle = host.getBoundingClientRect(), stage = host.offsetParent.getBoundingClientRect();
    const [x, y] = [middle.left - stage.left, middle.top - stage.top];
    if (legend.left < x + ROOM_PX && legend.bottom > y - ROOM_PX && legend.right > x - ROOM_PX)
      host.style.left = `${Math.max(ROOM_PX, Math.min(legend.right + ROOM_PX, stage.width - ROOM_PX)).toFixed(1)}px`;
  }

  function update() {
    if (!model.camera) return;
    host.hidden = !isOwnView() || model.options.shading.axes === true;  // The picture has its own there.
    const {right, up, forward} = axesOf(model.camera);
    for (const {button, line, direction} of ends) {
      const x = RADIUS_PX * dot(direction, right), y = -RADIUS_PX * dot(direction, up), depth = dot(direction, forward);
      button.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
      button.style.zIndex = String(Math.round(50 - 40 * depth));
      button.classList.toggle('behind', depth > 0.3);
      line?.setAttribute('x2', x.toFixed(1));
      line?.setAttribute('y2', y.toFixed(1));
    }
  }

  return {update, keepClearOf};
}
