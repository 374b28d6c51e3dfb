// PNG, 8 bits a channel, RGB or RGBA. Pictures at rest have to be exactly the server's bytes. A browser's own decoder
// may go through premultiplied alpha or a colour profile, and a canvas does, so this file both reads and writes them.

import {crc32} from '../net/crc32.js';

const SIGNATURE = [137, 80, 78, 71, 13, 10, 26, 10];
const SUB = 1;

async function through(bytes, stream) {
  return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
}

function paeth(left, up, corner) {
  const toLeft = Math.abs(up - corner), toUp = Math.abs(left - corner), toCorner = Math.abs(left + up - 2 * corner);
  return toLeft <= toUp && toLeft <= toCorner ? left : toUp <= toCorner ? up : corner;
}

function unfilter(rows, height, rowBytes, bpp) {
  const pixels = new Uint8Array(height * rowBytes);
  for (let y = 0, from = 0; y < height; ++y) {
    const filter = rows[from++], row = y * rowBytes;
    if (filter > 4) throw new RangeError(`PNG has filter ${filter}`);
    for (let x = 0; x < rowBytes; ++x, ++from) {
      const left = x >= bpp ? pixels[row + x - bpp] : 0;
      const up = y > 0 ? pixels[row + x - rowBytes] : 0;
      let guess = 0;
      if (filter === 1) guess = left;
      else if (filter === 2) guess = up;
      else if (filter === 3) guess = (left + up) >> 1;
      else if (filter === 4) guess = paeth(left, up, x >= bpp && y > 0 ? pixels[row + x - rowBytes - bpp] : 0);
      pixels[row + x] = rows[from] + guess;
    }
  }
  return pixels;
}

/// {width, height, bytesPerPixel, pixels}. Throws RangeError at anything but 8-bit RGB or RGBA without interlacing.
export async function pngDecode(bytes) {
  const data = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < 33 || SIGNATURE.some((byte, i) => bytes[i] !== byte)) throw new RangeError('not a PNG');
  const width = data.getUint32(16), height = data.getUint32(20);
  const depth = bytes[24], color = bytes[25], interlace = bytes[28];
  if (depth !== 8 || (color !== 2 && color !== 6) || interlace !== 0)
    throw new RangeError(`PNG of depth ${depth}, colour type ${color}, interlace ${interlace}`);
  const bytesPerPixel = color === 6 ? 4 : 3, parts = [];
  for (let at = 8; at + 12 <= bytes.length;) {
    const length = data.getUint32(at), name = String.fromCharCode(...bytes.subarray(at + 4, at + 8));
    if (at + 12 + length > bytes.length) throw new RangeError('PNG ends within a chunk');
    if (name === 'IDAT') parts.push(bytes.subarray(at + 8, at + 8 + length));
    at += 12 + length;
  }
  const rows = await through(new Blob(parts), new DecompressionStream('deflate'));
  const rowBytes = width * bytesPerPixel;
  if (rows.length !== height * (rowBytes + 1)) throw new RangeError('PNG has another size than it says');
  return {width, height, bytesPerPixel, pixels: unfilter(rows, height, rowBytes, bytesPerPixel)};
}

function chunk(name, content) {
  const bytes = new Uint8Array(12 + content.length), data = new DataView(bytes.buffer);
  data.setUint32(0, content.length);
  for (let i = 0; i < 4; ++i) bytes[4 + i] = name.charCodeAt(i);
  bytes.set(content, 8);
  data.setUint32(8 + content.length, crc32(bytes.subarray(4, 8 + content.length)));
  return bytes;
}

/// A PNG file (Blob) of RGBA pixels. It is RGB if every pixel is opaque.
export async function pngEncode(rgba, width, height) {
  let isOpaque = true;
  for (let i = 3; i < rgba.length && isOpaque; i += 4) isOpaque = rgba[i] === 255;
  const bpp = isOpaque ? 3 : 4, rowBytes = width * bpp, rows = new Uint8Array(height * (rowBytes + 1));
  for (let y = 0, from = 0, to = 0; y < height; ++y) {
    rows[to++] = SUB;
    for (let x = 0; x < width; ++x, from += 4)
      for (let c = 0; c < bpp; ++c) rows[to++] = rgba[from + c] - (x > 0 ? rgba[from + c - 4] : 0);
  }
  const header = new Uint8Array(13), data = new DataView(header.buffer);
  data.setUint32(0, width);
  data.setUint32(4, height);
  header[8] = 8;
  header[9] = isOpaque ? 2 : 6;
  const packed = await through(rows, new CompressionStream('deflate'));
  return new Blob([new Uint8Array(SIGNATURE), chunk('IHDR', header), chunk('IDAT', packed), chunk('IEND', new Uint8Array(0))],
                  {type: 'image/png'});
}
