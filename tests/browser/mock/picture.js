// Pictures for the mock server: a unit sphere with streaks around its poles, seen by the camera that was asked for, so
// that a test can tell from the pixels which way the camera turned.

const MAPS = {
  viridis: ['440154', '3b528b', '21918c', '5cc863', 'fde725'], turbo: ['30123b', '28bceb', 'a4fc3c', 'fb8122', '7a0403'],
  coolwarm: ['3b4cc0', '8db0fe', 'dddcdc', 'f49a7b', 'b40426'], gray: ['000000', '404040', '808080', 'bfbfbf', 'ffffff'],
};
const rgb = (hex) => [0, 2, 4].map((i) => parseInt(hex.slice(i, i + 2), 16));

const sub = (a, b) => a.map((x, i) => x - b[i]);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const normalize = (a) => a.map((x) => x / Math.hypot(...a));

function hash(x, y) {
  let value = Math.imul(x, 374761393) ^ Math.imul(y, 668265263);
  value = Math.imul(value ^ (value >>> 13), 1274126177);
  return ((value ^ (value >>> 16)) >>> 0) / 4294967296;
}

// Value noise, periodic along x in `period` cells.
function noise(x, y, period) {
  const x0 = Math.floor(x), y0 = Math.floor(y), u = x - x0, v = y - y0;
  const left = ((x0 % period) + period) % period, right = (left + 1) % period;
  const top = hash(left, y0) * (1 - u) + hash(right, y0) * u;
  const bottom = hash(left, y0 + 1) * (1 - u) + hash(right, y0 + 1) * u;
  return top * (1 - v) + bottom * v;
}

/// width * height * bytesPerPixel bytes of the view. `scene`: the effective lic and shading. The loop makes no objects,
/// because the page waits for these pictures most of the time.
export function drawSphere({width, height, camera, lic, shading, time = 0, radius = 1}) {
  const isTransparent = shading.background === 'transparent', bpp = isTransparent ? 4 : 3;
  const pixels = Buffer.alloc(width * height * bpp), back = isTransparent ? [0, 0, 0] : rgb(shading.background);
  const forward = normalize(sub(camera.focal, camera.position)), right = normalize(cross(forward, camera.up)), up = cross(right, forward);
  const focalPx = 0.5 * height / Math.tan(camera.fov / 2 * Math.PI / 180);
  const map = (MAPS[shading.colormap] ?? MAPS.viridis).map(rgb), c = dot(camera.position, camera.position) - radius * radius;
  const [px, py, pz] = camera.position, ray = [0, 0, 0];
  for (let y = 0, at = 0; y < height; ++y)
    for (let x = 0; x < width; ++x, at += bpp) {
      const xs = (x + 0.5 - width / 2) / focalPx, ys = (y + 0.5 - height / 2) / focalPx;
      for (let i = 0; i < 3; ++i) ray[i] = forward[i] + xs * right[i] - ys * up[i];
      const a = dot(ray, ray), b = dot(camera.position, ray), inside = b * b - a * c;
      if (inside < 0) {
        for (let i = 0; i < 3; ++i) pixels[at + i] = back[i];
        if (isTransparent) pixels[at + 3] = 0;
        continue;
      }
      const t = (-b - Math.sqrt(inside)) / a, hitX = px + t * ray[0], hitY = py + t * ray[1], hitZ = pz + t * ray[2];
      const z = hitZ / radius, angle = Math.atan2(hitY, hitX) / (2 * Math.PI) + 1;
      const part = Math.max(0, Math.min(0.999, (z + 1) / 2 + 0.18 * Math.sin(12 * angle + 5 * z + 6 * time))) * (map.length - 1);
      const low = map[Math.floor(part)], high = map[Math.floor(part) + 1], mix = part % 1;
      const swirl = angle + 0.12 * Math.sin(7 * z) + lic.phase / 40;
      const streak = lic.method === 'none' ? 0.5
        : 0.65 * noise(swirl * 24, (z + 0.1 * Math.sin(angle * 6.2832)) * 90 * lic.noiseScale, 24) + 0.35 * noise(swirl * 60, z * 190 * lic.noiseScale, 60);
      const facing = hitX * ray[0] + hitY * ray[1] + hitZ * ray[2];
      const light = shading.lighting ? 0.35 + 0.65 * Math.max(0, -facing / Math.sqrt(a)) : 1;
      const tone = light * (1 + shading.blend * shading.contrast * (streak - 0.5) * 1.6);
      for (let i = 0; i < 3; ++i) pixels[at + i] = Math.max(0, Math.min(255, (low[i] * (1 - mix) + high[i] * mix) * tone));
      if (isTransparent) pixels[at + 3] = x % 7 === 0 ? 128 : 255;  // Some of the picture is half clear.
    }
  return {pixels, bytesPerPixel: bpp};
}
