// The codecs of tiles, as encoders: lz4 (greedy), png (by zlib), jpeg (one colour for each 8 x 8 block).

import zlib from 'node:zlib';
import {crc32} from './messages.js';

/// An LZ4 block. Follows the format's end rules: the last five bytes are literals.
export function lz4Encode(source) {
  const out = Buffer.alloc(source.length + Math.floor(source.length / 255) + 16), table = new Int32Array(1 << 14).fill(-1);
  const lastMatch = source.length - 12;
  let anchor = 0, at = 0, to = 0;
  const length = (rest) => {
    for (; rest >= 255; rest -= 255) out[to++] = 255;
    out[to++] = rest;
  };
  const sequence = (end, offset, match) => {
    const literals = end - anchor;
    out[to++] = (Math.min(15, literals) << 4) | (offset ? Math.min(15, match - 4) : 0);
    if (literals >= 15) length(literals - 15);
    to += source.copy(out, to, anchor, end);
    if (!offset) return;
    out[to++] = offset & 255;
    out[to++] = offset >> 8;
    if (match - 4 >= 15) length(match - 19);
  };
  while (at < lastMatch) {
    const word = source[at] | source[at + 1] << 8 | source[at + 2] << 16 | source[at + 3] << 24;
    const slot = Math.imul(word, 2654435761) >>> 18, candidate = table[slot];
    table[slot] = at;
    if (candidate < 0 || at - candidate > 65535) { ++at; continue; }
    let match = 0;
    while (at + match < source.length - 5 && source[at + match] === source[candidate + match]) ++match;
    if (match < 4) { ++at; continue; }
    sequence(at, at - candidate, match);
    at += match;
    anchor = at;
  }
  sequence(source.length, 0, 0);
  return out.subarray(0, to);
}

export function filterRows(pixels, width, rows, bpp) {
  const filtered = Buffer.alloc(pixels.length);
  for (let row = 0, to = 0; row < rows; ++row)
    for (let k = 0; k < bpp; ++k)  // Green, red and blue beside green, clearness.
      for (let x = 0, at = row * width * bpp, before = 0; x < width; ++x, at += bpp) {
        const green = pixels[at + 1], value = k === 0 ? green : k === 3 ? pixels[at + 3] : pixels[at + (k === 1 ? 0 : 2)] - green;
        filtered[to++] = value - before;
        before = value;
      }
  return filtered;
}

function chunk(name, content) {
  const body = Buffer.concat([Buffer.from(name), content]), bytes = Buffer.alloc(body.length + 8);
  bytes.writeUInt32BE(content.length, 0);
  body.copy(bytes, 4);
  bytes.writeUInt32BE(crc32(body), body.length + 4);
  return bytes;
}

/// `filterOf(row)`: 0 none, 1 sub, 2 up, 3 average, 4 Paeth.
export function pngEncode(pixels, width, rows, bpp, filterOf = () => 2) {
  const rowBytes = width * bpp, raw = Buffer.alloc(rows * (rowBytes + 1));
  for (let y = 0; y < rows; ++y) {
    const filter = filterOf(y), start = y * (rowBytes + 1);
    raw[start] = filter;
    for (let x = 0; x < rowBytes; ++x) {
      const at = y * rowBytes + x, a = x >= bpp ? pixels[at - bpp] : 0, b = y ? pixels[at - rowBytes] : 0;
      const c = x >= bpp && y ? pixels[at - rowBytes - bpp] : 0, p = a + b - c;
      const [pa, pb, pc] = [Math.abs(p - a), Math.abs(p - b), Math.abs(p - c)];
      const paeth = pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
      raw[start + 1 + x] = pixels[at] - [0, a, b, (a + b) >> 1, paeth][filter];
    }
  }
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(rows, 4);
  header[8] = 8;
  header[9] = bpp === 4 ? 6 : 2;
  return Buffer.concat([Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]), chunk('IHDR', header),
                        chunk('IDAT', zlib.deflateSync(raw, {level: 1})), chunk('IEND', Buffer.alloc(0))]);
}

// A baseline JPEG of DC coefficients alone. Category s has the four-bit code s, so one table serves all components.
export function jpegEncode(pixels, width, rows) {
  const segment = (marker, ...bytes) => [0xff, marker, (bytes.length + 2) >> 8, (bytes.length + 2) & 255, ...bytes];
  const counts = [0, 0, 0, 12, ...new Array(12).fill(0)];
  const header = Buffer.from([0xff, 0xd8, ...segment(0xdb, 0, ...new Array(64).fill(8)),
    ...segment(0xc0, 8, rows >> 8, rows & 255, width >> 8, width & 255, 3, 1, 0x11, 0, 2, 0x11, 0, 3, 0x11, 0),
    ...segment(0xc4, 0, ...counts, ...Array.from({length: 12}, (_, i) => i)),
    ...segment(0xc4, 0x10, 1, ...new Array(15).fill(0), 0),
    ...segment(0xda, 3, 1, 0, 2, 0, 3, 0, 0, 63, 0)]);
  const out = [], last = [0, 0, 0];
  let bits = 0, count = 0;
  const put = (value, length) => {
    bits = (bits << length) | value;
    for (count += length; count >= 8; count -= 8) {
      const byte = (bits >> (count - 8)) & 255;
      out.push(byte);
      if (byte === 255) out.push(0);
    }
    bits &= (1 << count) - 1;
  };
  for (let y = 0; y < rows; y += 8)
    for (let x = 0; x < width; x += 8) {
      const at = 3 * (Math.min(y + 4, rows - 1) * width + Math.min(x + 4, width - 1));
      const [r, g, b] = [pixels[at], pixels[at + 1], pixels[at + 2]];
      const ycc = [0.299 * r + 0.587 * g + 0.114 * b - 128, -0.1687 * r - 0.3313 * g + 0.5 * b, 0.5 * r - 0.4187 * g - 0.0813 * b];
      ycc.forEach((value, i) => {
        const dc = Math.round(value), difference = dc - last[i], size = 32 - Math.clz32(Math.abs(difference));
        last[i] = dc;
        put(size, 4);
        if (size > 0) put(difference > 0 ? difference : difference + (1 << size) - 1, size);
        put(0, 1);  // End of block.
      });
    }
  if (count > 0) put((1 << (8 - count)) - 1, 8 - count);
  return Buffer.concat([header, Buffer.from(out), Buffer.from([0xff, 0xd9])]);
}
