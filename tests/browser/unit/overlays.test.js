import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import test from 'node:test';

import {USUAL_SPACING, overlaysText, readOverlays} from '../../../web/view/overlays.js';

test('a list of overlays is read and written again', () => {
  for (const text of ['none', 'streamlines', 'streamlines:16', 'edges,outline', 'edges,outline,streamlines:12.5,separation,topology', 'edges,through:-1:0.25:3e-7'])
    assert.equal(overlaysText(readOverlays(text)), text);
  assert.deepEqual(readOverlays('topology,streamlines'), {streamlines: 24, topology: true, separation: false, edges: false, outline: false, through: null});
  assert.deepEqual(readOverlays(undefined), {streamlines: 0, topology: false, separation: false, edges: false, outline: false, through: null});
  assert.deepEqual(readOverlays('through:1:2:-3').through, [1, 2, -3]);
});

test('what is off is not in the list', () => {
  assert.equal(overlaysText({streamlines: 0, topology: false, edges: false, outline: false}), 'none');
  assert.equal(overlaysText({...readOverlays('streamlines:9,topology'), streamlines: 0}), 'topology');
  assert.equal(overlaysText({...readOverlays('none'), streamlines: 24}), 'streamlines');
});

test('the usual spacing is the server\'s', () => {
  const server = readFileSync(new URL('../../../src/description/overlays.h', import.meta.url), 'utf8');
  assert.equal(Number(/kUsualSpacingPx = ([\d.]+)/.exec(server)[1]), USUAL_SPACING);
});
