// The server's side of docs/protocol.md, written from that page and not from web/protocol.js, so that one checks the other.

import zlib from 'node:zlib';

function message(type, payload) {
  const header = Buffer.from([0xae, 1, type, 0, 0, 0, 0, 0]);
  header.writeUInt32LE(payload.length, 4);
  return Buffer.concat([header, payload]);
}

const json = (object) => Buffer.from(JSON.stringify(object));

export const welcome = (object) => message(0x41, json(object));
export const state = (object) => message(0x42, json(object));
export const scene = (object) => message(0x43, json(object));
export function changed(change) {
  const number = Buffer.alloc(4);
  number.writeUInt32LE(change);
  return message(0x49, number);
}

export const picked = (object) => message(0x4a, json(object));
export const notice = (object) => message(0x47, json(object));

export function frame({frame, viewer, view, width, height, askedWidth, lossless}) {
  const payload = Buffer.alloc(28);
  [frame, viewer, view, width, height, askedWidth, lossless ? 1 : 0].forEach((value, i) => payload.writeUInt32LE(value, 4 * i));
  return message(0x44, payload);
}

export function tile({frame, firstRow, rows, width, rank, codec, bytesPerPixel, encoded, crc = crc32(encoded)}) {
  const header = Buffer.alloc(24);
  [frame, firstRow, rows, width].forEach((value, i) => header.writeUInt32LE(value, 4 * i));
  header.writeUInt16LE(rank, 16);
  header[18] = codec;
  header[19] = bytesPerPixel;
  header.writeUInt32LE(crc, 20);
  return message(0x45, Buffer.concat([header, encoded]));
}

export function frameEnd(frame, stats) {
  const number = Buffer.alloc(4);
  number.writeUInt32LE(frame);
  return message(0x46, Buffer.concat([number, json(stats)]));
}

/// {type, json or number, if any} of a viewer's message; throws where it breaks the protocol.
export function parseFromViewer(bytes) {
  const [magic, version, type, reserved] = bytes, payload = bytes.subarray(8);
  if (magic !== 0xae || version !== 1 || reserved !== 0) throw new Error('bad header');
  if (bytes.readUInt32LE(4) !== payload.length) throw new Error('bad length');
  const limit = {1: 4096, 2: 16384, 3: 4, 4: 16384, 5: 4, 6: 0, 7: 16384}[type];
  if (limit === undefined || payload.length > limit) throw new Error(`bad type ${type} or payload of ${payload.length}`);
  if (type === 3 || type === 5) return {type, number: payload.readUInt32LE(0)};
  if (type === 6) return {type};
  return {type, json: JSON.parse(payload.toString())};
}

// zlib.crc32 came after Node 20; a PNG chunk's way to it would be longer than the loop.
const table = Uint32Array.from({length: 256}, (_, i) => {
  for (let bit = 0; bit < 8; ++bit) i = i & 1 ? 0xedb88320 ^ (i >>> 1) : i >>> 1;
  return i;
});
export function crc32(bytes) {
  if (zlib.crc32) return zlib.crc32(bytes);
  let crc = 0xffffffff;
  for (const byte of bytes) crc = table[(crc ^ byte) & 255] ^ (crc >>> 8);
  return (crc ^ 0xffffffff) >>> 0;
}
