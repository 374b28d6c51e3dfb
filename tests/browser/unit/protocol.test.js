// Messages and their known bytes, both ways (docs/protocol.md).

import assert from 'node:assert/strict';
import {test} from 'node:test';
import {crc32} from '../../../web/net/crc32.js';
import {ProtocolError, Type, jsonMessage, numberMessage, parseMessage} from '../../../web/net/protocol.js';

const buffer = (...bytes) => new Uint8Array(bytes.flat()).buffer;
const u32 = (value) => [value & 255, (value >>> 8) & 255, (value >>> 16) & 255, value >>> 24];
const text = (string) => [...new TextEncoder().encode(string)];
const message = (type, payload) => buffer(0xae, 1, type, 0, u32(payload.length), payload);
const frame = (change = {}) => {
  const f = {frame: 17, viewer: 3, view: 0xffffffff, width: 400, height: 300, asked: 800, flags: 1, ...change};
  return message(0x44, [f.frame, f.viewer, f.view, f.width, f.height, f.asked, f.flags].flatMap(u32));
};
const tile = (change = {}) => {
  const t = {frame: 17, firstRow: 2, rows: 3, width: 4, rank: 258, codec: 3, bpp: 3, crc: 0xcafebabe, encoded: [1, 2, 3], ...change};
  return message(0x45, [...u32(t.frame), ...u32(t.firstRow), ...u32(t.rows), ...u32(t.width), t.rank & 255, t.rank >> 8, t.codec, t.bpp, ...u32(t.crc), ...t.encoded]);
};

test('a View is magic, version, type, zero, length and JSON', () => {
  const json = '{"view":7}';
  assert.deepEqual([...jsonMessage(Type.view, {view: 7})], [0xae, 1, 0x02, 0, 10, 0, 0, 0, ...text(json)]);
});

test('lengths count bytes of UTF-8, not characters', () => {
  assert.equal(jsonMessage(Type.change, {colorBy: 'ρ'})[4], text('{"colorBy":"ρ"}').length);
});

test('Shown and Follow hold one number, up to 2³²−1', () => {
  assert.deepEqual([...numberMessage(Type.shown, 0xfffffffe)], [0xae, 1, 0x03, 0, 4, 0, 0, 0, 0xfe, 0xff, 0xff, 0xff]);
  assert.deepEqual([...numberMessage(Type.follow, 3)], [0xae, 1, 0x05, 0, 4, 0, 0, 0, 3, 0, 0, 0]);
});

test('a Frame comes out with every field', () => {
  assert.deepEqual(parseMessage(frame()), {type: Type.frame, frame: 17, viewer: 3, view: 0xffffffff, width: 400, height: 300, askedWidth: 800, lossless: true});
});

test('a Tile comes out with every field', () => {
  const {encoded, ...fields} = parseMessage(tile());
  assert.deepEqual(fields, {type: Type.tile, frame: 17, firstRow: 2, rows: 3, width: 4, rank: 258, codec: 3, bytesPerPixel: 3, crc: 0xcafebabe});
  assert.deepEqual([...encoded], [1, 2, 3]);
});

test('a FrameEnd has its frame before the JSON', () => {
  const {frame: number, json} = parseMessage(message(0x46, [...u32(9), ...text('{"totalMs":21.5}')]));
  assert.equal(number, 9);
  assert.deepEqual(json, {totalMs: 21.5});
});

test('a Notice is its JSON', () => {
  assert.deepEqual(parseMessage(message(0x47, text('{"level":"error"}'))).json, {level: 'error'});
});

test('a Pick is a View with a pixel, a Picked its JSON', () => {
  assert.deepEqual([...jsonMessage(Type.pick, {x: 1})], [0xae, 1, 0x07, 0, 7, 0, 0, 0, ...text('{"x":1}')]);
  assert.deepEqual(parseMessage(message(0x4a, text('{"view":9,"place":null}'))).json, {view: 9, place: null});
});

const bad = {
  'not binary': 'text',
  'no header': buffer(0xae, 1, 0x42),
  'another magic': buffer(0xaf, 1, 0x42, 0, u32(2), text('{}')),
  'another version': buffer(0xae, 2, 0x42, 0, u32(2), text('{}')),
  'a reserved byte': buffer(0xae, 1, 0x42, 1, u32(2), text('{}')),
  'a type nobody knows': message(0x7f, text('{}')),
  'a type that only viewers send': message(0x02, text('{}')),
  'a type between gateway and ranks': message(0x83, text('{}')),
  'a length longer than the payload': buffer(0xae, 1, 0x42, 0, u32(3), text('{}')),
  'a length shorter than the payload': buffer(0xae, 1, 0x42, 0, u32(1), text('{}')),
  'a State over its limit': message(0x42, text(`{"what":"${'x'.repeat(65536)}"}`)),
  'a Frame of 27 bytes': message(0x44, new Array(27).fill(1)),
  'a Frame with an unknown flag': frame({flags: 3}),
  'a Frame without width': frame({width: 0}),
  'a Frame of absurd size': frame({width: 32768, height: 32768}),
  'a Tile without a header': message(0x45, new Array(23).fill(1)),
  'a Tile without rows': tile({rows: 0}),
  'a Tile whose rows overflow': tile({firstRow: 0xffffffff, rows: 2}),
  'a Tile of an unknown codec': tile({codec: 5}),
  'a Tile of two bytes per pixel': tile({bpp: 2}),
  'a JPEG with alpha': tile({codec: 1, bpp: 4}),
  'JSON that is none': message(0x42, text('{"a":')),
  'JSON that is a list': message(0x42, text('[]')),
  'text that is not UTF-8': message(0x42, [0x7b, 0xff, 0x7d]),
};
for (const [name, bytes] of Object.entries(bad)) test(`refuses ${name}`, () => assert.throws(() => parseMessage(bytes), ProtocolError));

test('CRC-32 of "123456789" is the one in every table', () => {
  assert.equal(crc32(new Uint8Array(text('123456789'))), 0xcbf43926);
  assert.equal(crc32(new Uint8Array(0)), 0);
  assert.equal(crc32(new Uint8Array(text('6789')), crc32(new Uint8Array(text('12345')))), 0xcbf43926);
});
