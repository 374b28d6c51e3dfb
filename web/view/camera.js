// The camera: {position, focal, up, fov}, absolute, in world coordinates, fov vertical in degrees. All functions return a
// new one. `vertical` is the world axis that stays upright on the screen (unit vector); azimuth turns about it.
// Azimuth and elevation mean the same as on Aeolic's command line where `vertical` is z.

import {add, cross, dot, length, mix, normalize, scale, sub} from './vec3.js';

const RAD = Math.PI / 180;
const AXES = [[0, 0, 1], [0, 1, 0], [1, 0, 0], [0, 0, -1], [0, -1, 0], [-1, 0, 0]];

/// The view's right, up and forward, as orthonormal vectors of the world.
export function axesOf({position, focal, up}) {
  const forward = normalize(sub(focal, position));
  const right = normalize(cross(forward, up));
  return {right, up: cross(right, forward), forward};
}

export const distanceOf = ({position, focal}) => length(sub(position, focal));

/// The world axis that a view keeps upright, z if it keeps none.
export function verticalOf(camera) {
  const {up, forward} = axesOf(camera);
  for (const axis of AXES) {
    const across = sub(axis, scale(forward, dot(axis, forward)));
    if (length(across) > 1e-3 && dot(normalize(across), up) > 1 - 1e-6) return axis;
  }
  return [0, 0, 1];
}

// Two horizontal axes: azimuth 0 looks along `ahead`, with `side` to the right.
function horizontal(vertical) {
  const ahead = Math.abs(vertical[1]) > 0.9 ? [0, 0, -vertical[1]] : [0, 1, 0];
  return {ahead, side: cross(ahead, vertical)};
}

/// {azimuthDeg, elevationDeg, rollDeg, distance} of a view.
export function anglesOf(camera, vertical) {
  const {ahead, side} = horizontal(vertical), {right, up, forward} = axesOf(camera);
  const elevation = Math.asin(Math.max(-1, Math.min(1, -dot(forward, vertical))));
  // Straight from above or below, the picture's up tells where ahead is.
  const level = Math.abs(elevation) < (90 - 1e-4) * RAD ? forward : scale(up, Math.sign(elevation));
  const azimuth = Math.atan2(-dot(level, side), dot(level, ahead));
  const straight = cameraFrom({azimuthDeg: azimuth / RAD, elevationDeg: elevation / RAD, rollDeg: 0, distance: 1}, camera, vertical);
  const roll = Math.atan2(dot(straight.up, right), dot(straight.up, up));
  return {azimuthDeg: azimuth / RAD, elevationDeg: elevation / RAD, rollDeg: roll / RAD, distance: distanceOf(camera)};
}

/// The view with these angles about `camera`'s focal point. Its up is the derivative by the elevation, which is
/// sound over the poles too.
export function cameraFrom({azimuthDeg, elevationDeg, rollDeg, distance}, {focal, fov}, vertical) {
  const {ahead, side} = horizontal(vertical);
  const az = azimuthDeg * RAD, el = elevationDeg * RAD, roll = rollDeg * RAD;
  const outward = mix(side, Math.sin(az) * Math.cos(el), ahead, -Math.cos(az) * Math.cos(el), vertical, Math.sin(el));
  const straight = mix(side, -Math.sin(az) * Math.sin(el), ahead, Math.cos(az) * Math.sin(el), vertical, Math.cos(el));
  const right = cross(scale(outward, -1), straight);
  const up = roll === 0 ? straight : add(scale(straight, Math.cos(roll)), scale(right, -Math.sin(roll)));
  return {position: add(focal, scale(outward, distance)), focal, up, fov};
}

/// The camera turned about the focal point, to the right and up on the screen, in degrees. Elevation ends at the poles.
export function orbit(camera, rightDeg, upDeg, vertical) {
  const angles = anglesOf(camera, vertical), roll = angles.rollDeg * RAD;
  const x = rightDeg * Math.cos(roll) - upDeg * Math.sin(roll), y = rightDeg * Math.sin(roll) + upDeg * Math.cos(roll);
  return cameraFrom({...angles, azimuthDeg: angles.azimuthDeg + x,
                     elevationDeg: Math.max(-90, Math.min(90, angles.elevationDeg + y))}, camera, vertical);
}

/// The camera turned about the line of sight; the picture turns clockwise.
export function roll(camera, degrees) {
  const {right, up} = axesOf(camera), angle = degrees * RAD;
  return {...camera, up: add(scale(up, Math.cos(angle)), scale(right, -Math.sin(angle)))};
}

/// The camera moved sideways, so that the focal point follows the pointer: dx to the right, dy down, in
/// pixels of a picture `heightPx` high.
export function pan(camera, dxPx, dyPx, heightPx) {
  const {right, up} = axesOf(camera);
  const worldPerPx = 2 * distanceOf(camera) * Math.tan(camera.fov / 2 * RAD) / heightPx;
  const by = add(scale(right, -dxPx * worldPerPx), scale(up, dyPx * worldPerPx));
  return {...camera, position: add(camera.position, by), focal: add(camera.focal, by)};
}

/// The camera moved towards the focal point, where the picture grows by `factor`. What is at (xPx, yPx) from the
/// picture's middle stays there.
export function dolly(camera, factor, xPx = 0, yPx = 0, heightPx = 1) {
  const outward = sub(camera.position, camera.focal);
  const moved = {...camera, position: add(camera.focal, scale(outward, 1 / factor))};
  return pan(moved, xPx * (1 - factor), yPx * (1 - factor), heightPx);
}

/// The distance at which a surface fits the picture, if it fits a square one at `distance`: farther where the picture
/// is narrower.
export function fitDistance(distance, fovDeg, aspect) {
  const half = Math.tan(fovDeg / 2 * RAD);
  return distance * Math.sin(Math.atan(half)) / Math.sin(Math.atan(half * Math.min(1, aspect)));
}

/// A view along an axis of the world: '-x' looks from -x towards the focal point.
export function axisView(name, camera, vertical) {
  const direction = [0, 0, 0];
  direction['xyz'.indexOf(name[1])] = name[0] === '-' ? -1 : 1;
  const {ahead, side} = horizontal(vertical);
  const along = dot(direction, vertical);
  const azimuthDeg = Math.abs(along) > 0.5 ? 0 : Math.atan2(dot(direction, side), -dot(direction, ahead)) / RAD;
  return cameraFrom({azimuthDeg, elevationDeg: 90 * along, rollDeg: 0, distance: distanceOf(camera)}, camera, vertical);
}
