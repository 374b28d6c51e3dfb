// A short flight from one view to another, so that the eye keeps track of what turned where.

import {anglesOf, cameraFrom} from './camera.js';
import {add, scale, sub} from './vec3.js';

const FLIGHT_MS = 350;

const prefersNone = matchMedia('(prefers-reduced-motion: reduce)');
const easeInOut = (t) => t < 0.5 ? 2 * t * t : 1 - 2 * (1 - t) ** 2;
const shortestTurn = (from, to) => from + ((to - from) % 360 + 540) % 360 - 180;

let flight = 0;

/// Flies `model` to `target`. `onArrival` is called with the exact camera of the target. Another flight, or a camera
/// set by something else, ends this one.
export function glide(model, target, onArrival) {
  const number = ++flight, start = model.camera, {vertical} = model;
  if (prefersNone.matches || document.hidden) return onArrival(target);
  const from = anglesOf(start, vertical), to = anglesOf(target, vertical), startMs = performance.now();
  let expected = start;
  const step = () => {
    if (number !== flight || model.camera !== expected) return;
    const t = Math.min(1, (performance.now() - startMs) / FLIGHT_MS);
    if (t === 1) return onArrival(target);
    const part = easeInOut(t), between = (a, b) => a + (b - a) * part, betweenSizes = (a, b) => a * (b / a) ** part;
    const angles = {azimuthDeg: between(from.azimuthDeg, shortestTurn(from.azimuthDeg, to.azimuthDeg)),
                    elevationDeg: between(from.elevationDeg, to.elevationDeg),
                    rollDeg: between(from.rollDeg, shortestTurn(from.rollDeg, to.rollDeg)),
                    distance: betweenSizes(from.distance, to.distance)};
    const focal = add(start.focal, scale(sub(target.focal, start.focal), part));
    expected = cameraFrom(angles, {focal, fov: betweenSizes(start.fov, target.fov)}, vertical);
    model.setCamera(expected, true);
    requestAnimationFrame(step);
  };
  step();
}
