// A zoom stays outside the body: it comes closer as far as a sphere around it, then it narrows the field of view. The
// arithmetic is makeCamera's (src/description/camera.cpp), so that the page and `aeolic render` show the same.

import {distanceOf} from './camera.js';
import {add, dot, length, normalize, scale, sub} from './vec3.js';

const RAD = Math.PI / 180;
const NEAREST_RADII = 1.5, BESIDE_RADII = 2, MARGIN = 1.04;
const ROUNDING = 1e-6;
const SMALLEST_PART = 0.002;  // Of half the picture's height: about a pixel.

const tanHalf = (fovDeg) => Math.tan(fovDeg / 2 * RAD);

/// {center, radius} of what a Scene message shows.
export const bodyOf = ({bounds: [lo, hi], radius}) => ({center: scale(add(lo, hi), 0.5), radius});

// How far from the focal point the eye stays: makeCamera's nearestZoomDistance.
function nearestDistance({position, focal}, {center, radius}, lensDeg, aspect) {
  const nearest = NEAREST_RADII * radius, beside = BESIDE_RADII * radius, from = sub(focal, center);
  const outward = scale(sub(position, focal), 1 / distanceOf({position, focal}));
  const along = dot(from, outward), aside = length(sub(from, scale(outward, along)));
  const whole = MARGIN * radius / Math.sin(Math.atan(tanHalf(lensDeg) * Math.min(1, aspect)));
  const farEnd = aside < nearest ? Math.sqrt(nearest * nearest - aside * aside) - along
    : -along * Math.max(0, (beside - aside) / (beside - nearest));
  return Math.min(whole, Math.max(0, farEnd));
}

/// `camera`, which a move made of `before`, with the same scale at the focal point but from outside the body. Its lens
/// is `lensDeg` wide where the eye need not come so near. A view from within the body is left as it is.
export function keptOutside(camera, before, body, lensDeg, aspect) {
  if (distanceOf(before) < nearestDistance(before, body, lensDeg, aspect) * (1 - ROUNDING)) return camera;
  const nearest = nearestDistance(camera, body, lensDeg, aspect), distance = distanceOf(camera);
  const asked = distance * tanHalf(camera.fov) / tanHalf(lensDeg);
  if (camera.fov === lensDeg && asked >= nearest) return camera;
  const position = add(camera.focal, scale(sub(camera.position, camera.focal), Math.max(asked, nearest) / distance));
  return {...camera, position, fov: asked < nearest ? 2 * Math.atan(tanHalf(lensDeg) * asked / nearest) / RAD : lensDeg};
}

/// The lens that a given view has when it is not zoomed: `usualDeg` or its own, the wider, if it may be zoomed.
export function lensOf(camera, body, usualDeg, aspect) {
  const isNearest = distanceOf(camera) <= nearestDistance(camera, body, usualDeg, aspect) * (1 + ROUNDING);
  return isNearest ? Math.max(usualDeg, camera.fov) : camera.fov;
}

/// Whether some of a sphere lies within the corners of the picture, and is larger there than a dot.
export function isInSight({position, focal, fov}, center, radius, aspect) {
  const to = sub(center, position), distance = length(to);
  if (distance <= radius) return true;
  const corner = Math.atan(tanHalf(fov) * Math.hypot(1, aspect)), sphere = Math.asin(radius / distance);
  const aside = Math.acos(Math.max(-1, Math.min(1, dot(normalize(to), normalize(sub(focal, position))))));
  return aside - sphere < corner && radius / distance > SMALLEST_PART * tanHalf(fov);
}
