// Mouse, pen and touch on the picture. A click asks what is there. One finger or the left button turns, two fingers pinch and pan, the right or
// middle button (or shift) pans, control turns the picture, the wheel comes closer.

import {dolly, orbit, pan, roll} from './camera.js';

const TURN_PER_STAGE_DEG = 180;  // A drag over the shorter side of the stage is half a turn.
const WHEEL_FACTOR_PER_PX = 1.0015;
const SLOP_PX = {mouse: 3, pen: 6, touch: 10};  // A hand is not steadier than this when it clicks.
const LINE_PX = 33, PAGE_PX = 800;  // The pixels that browsers mean by a wheel's lines and pages.

/// `onEnd` is called when the last pointer left after a drag, `onClick({x, y})` where it did not move.
export function watchPointers(element, model, {onEnd, onClick}) {
  const pointers = new Map();  // id -> {x, y}
  let mode = 'turn', click = null;  // click: where a pointer went down that has not moved since then.

  const move = (camera) => model.moveCamera(camera);
  const height = () => element.clientHeight;
  const fromMiddle = ({x, y}) => {
    const box = element.getBoundingClientRect();
    return [x - box.left - box.width / 2, y - box.top - box.height / 2];
  };

  function drag(dx, dy) {
    const {camera, vertical} = model;
    const degreesPerPx = TURN_PER_STAGE_DEG / Math.min(element.clientWidth, element.clientHeight);
    if (mode === 'pan') move(pan(camera, dx, dy, height()));
    else if (mode === 'roll') move(roll(camera, dx * degreesPerPx));
    else move(orbit(camera, -dx * degreesPerPx, dy * degreesPerPx, vertical));
  }

  function pinch(before, after) {
    const middle = ([a, b]) => ({x: (a.x + b.x) / 2, y: (a.y + b.y) / 2});
    const spread = ([a, b]) => Math.max(8, Math.hypot(a.x - b.x, a.y - b.y));
    const from = middle(before), to = middle(after);
    const moved = pan(model.camera, to.x - from.x, to.y - from.y, height());
    move(dolly(moved, spread(after) / spread(before), ...fromMiddle(to), height()));
  }

  element.addEventListener('pointerdown', (event) => {
    if (!model.camera || event.target.closest('button, a, input')) return;
    element.focus({preventScroll: true});
    element.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
    const isPlain = event.button === 0 && !event.shiftKey && !event.ctrlKey && !event.metaKey;
    click = isPlain && pointers.size === 1 ? {x: event.clientX, y: event.clientY} : null;
    mode = event.button === 1 || event.button === 2 || event.shiftKey ? 'pan' : event.ctrlKey || event.metaKey ? 'roll' : 'turn';
    element.classList.add('dragging');
    if (event.button === 1) event.preventDefault();  // No scrolling by the middle button.
  });
  element.addEventListener('pointermove', (event) => {
    const last = pointers.get(event.pointerId);
    if (!last) return;
    const now = {x: event.clientX, y: event.clientY};
    if (now.x === last.x && now.y === last.y) return;
    if (click && Math.hypot(now.x - click.x, now.y - click.y) <= (SLOP_PX[event.pointerType] ?? SLOP_PX.mouse)) return;
    click = null;
    const before = [...pointers.values()];
    pointers.set(event.pointerId, now);
    if (pointers.size === 1) drag(now.x - last.x, now.y - last.y);
    else if (pointers.size === 2) pinch(before, [...pointers.values()]);
  });
  const end = (event) => {
    if (!pointers.delete(event.pointerId) || pointers.size > 0) return;
    element.classList.remove('dragging');
    if (click && event.type === 'pointerup') onClick(click);
    else if (!click) onEnd();
    click = null;
  };
  for (const name of ['pointerup', 'pointercancel', 'lostpointercapture']) element.addEventListener(name, end);
  element.addEventListener('contextmenu', (event) => event.preventDefault());
  element.addEventListener('wheel', (event) => {
    event.preventDefault();
    if (!model.camera) return;
    const px = event.deltaY * [1, LINE_PX, PAGE_PX][event.deltaMode] * (event.ctrlKey ? 4 : 1);  // A touchpad's pinch comes as a wheel with control.
    move(dolly(model.camera, WHEEL_FACTOR_PER_PX ** -Math.max(-400, Math.min(400, px)),
               ...fromMiddle({x: event.clientX, y: event.clientY}), height()));
  }, {passive: false});
}
