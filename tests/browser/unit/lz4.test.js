import assert from 'node:assert/strict';
import {test} from 'node:test';
import {lz4Decode, pixelsToRgba, unfilterRows} from '../../../web/picture/lz4.js';
import {pngDecode, pngEncode} from '../../../web/picture/png.js';
import * as codecs from '../mock/codecs.js';

const bytes = (...list) => Uint8Array.from(list);
const decode = (block, size) => [...lz4Decode(bytes(...block), new Uint8Array(size))];

// A generator with a known sequence, so that a failure repeats.
function randomBytes(count, seed, values = 256) {
  let state = seed;
  return Buffer.from({length: count}, () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return (state >>> 16) % values;
  });
}

test('literals alone', () => assert.deepEqual(decode([0x30, 7, 8, 9], 3), [7, 8, 9]));

test('a match that overlaps itself repeats one byte', () => {
  // One literal, a match of 4 + 3 at offset 1, then two literals.
  assert.deepEqual(decode([0x13, 5, 1, 0, 0x20, 6, 7], 10), [5, 5, 5, 5, 5, 5, 5, 5, 6, 7]);
});

test('a match that overlaps itself repeats a pattern', () => {
  assert.deepEqual(decode([0x31, 1, 2, 3, 3, 0, 0x10, 9], 9), [1, 2, 3, 1, 2, 3, 1, 2, 9]);
});

test('lengths of 15 and more take further bytes', () => {
  const literals = Array.from({length: 15 + 255 + 4}, (_, i) => i & 255);
  assert.deepEqual(decode([0xf0, 255, 4, ...literals], literals.length), literals);
  assert.deepEqual(decode([0x1f, 5, 1, 0, 255, 1, 0x10, 6], 1 + 4 + 15 + 256 + 1), [...new Array(276).fill(5), 6]);
});

test('an empty block is an empty tile', () => assert.deepEqual(decode([0x00], 0), []));

for (const [name, block, size] of [
  ['ends within literals', [0x30, 7, 8], 3], ['ends within a length', [0xf0, 255], 300], ['ends within an offset', [0x10, 5, 1], 9],
  ['has offset zero', [0x10, 5, 0, 0, 0x10, 1], 6], ['refers to bytes before its start', [0x10, 5, 2, 0, 0x10, 1], 6],
  ['is longer than its tile by literals', [0x30, 7, 8, 9], 2], ['is longer than its tile by a match', [0x1f, 5, 1, 0, 200, 0x10, 1], 9],
  ['is shorter than its tile', [0x30, 7, 8, 9], 4], ['is nothing at all', [], 4],
]) test(`refuses a block that ${name}`, () => assert.throws(() => decode(block, size), RangeError));

test('junk never gets out of bounds', () => {
  for (let seed = 1; seed <= 2000; ++seed) {
    const target = new Uint8Array(64);
    try {
      lz4Decode(randomBytes(1 + seed % 40, seed), target);
    } catch (error) {
      assert.ok(error instanceof RangeError, String(error));
    }
  }
});

test('what an encoder packs comes out the same', () => {
  for (const [size, values] of [[13, 2], [1000, 2], [100000, 3], [70000, 256], [200000, 1]]) {
    const source = randomBytes(size, size, values);
    assert.ok(Buffer.from(lz4Decode(codecs.lz4Encode(source), new Uint8Array(size))).equals(source), `${size} bytes of ${values} values`);
  }
});

test('the row filter starts anew in each row', () => {
  // A row holds the greens, then the reds less the greens, then the blues less the greens; each byte less the one
  // before.
  const filtered = bytes(1, 3, 249, 6, 1, 254, 5, 255, 251, 0, 2, 1);
  assert.deepEqual([...unfilterRows(filtered, 2, 2, 3)], [250, 1, 2, 255, 3, 4, 3, 255, 0, 5, 7, 255, 255, 4, 7, 255]);
});

test('alpha is filtered like the colours', () => {
  assert.deepEqual([...unfilterRows(bytes(10, 1, 0, 0, 0, 0, 200, 100), 2, 1, 4)], [10, 10, 10, 200, 11, 11, 11, 44]);
});

test('plain rows stay as they are, opaque without alpha', () => {
  assert.deepEqual([...pixelsToRgba(bytes(1, 2, 3, 4, 5, 6), 2, 1, 3)], [1, 2, 3, 255, 4, 5, 6, 255]);
  assert.throws(() => pixelsToRgba(bytes(1, 2, 3), 2, 1, 3), RangeError);
});

for (const bpp of [3, 4])
  test(`a PNG with every filter and ${bpp} bytes per pixel comes out exactly`, async () => {
    const pixels = randomBytes(37 * 23 * bpp, bpp, 256);
    const png = await pngDecode(codecs.pngEncode(pixels, 37, 23, bpp, (row) => row % 5));
    assert.deepEqual([png.width, png.height, png.bytesPerPixel], [37, 23, bpp]);
    assert.ok(Buffer.from(png.pixels).equals(pixels));
  });

test('a saved PNG reads back exactly: opaque as RGB, else with colours under clear pixels', async () => {
  for (const opaque of [true, false]) {
    const rgba = new Uint8ClampedArray(randomBytes(31 * 17 * 4, 5));
    if (opaque) for (let i = 3; i < rgba.length; i += 4) rgba[i] = 255;
    const file = new Uint8Array(await (await pngEncode(rgba, 31, 17)).arrayBuffer()), png = await pngDecode(file);
    assert.equal(png.bytesPerPixel, opaque ? 3 : 4);
    assert.deepEqual([...pixelsToRgba(png.pixels, 31, 17, png.bytesPerPixel)], [...rgba]);
  }
});

test('refuses a PNG of another kind, and one that is cut off', async () => {
  const file = codecs.pngEncode(randomBytes(300, 1), 10, 10, 3), palette = Buffer.from(file);
  palette[25] = 3;
  await assert.rejects(pngDecode(palette), RangeError);
  await assert.rejects(pngDecode(file.subarray(0, file.length - 30)));
});
