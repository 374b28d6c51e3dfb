// Time plays by the clock, and not as fast as a server can draw: what changes ten times a second flickers.

import assert from 'node:assert/strict';
import {test} from 'node:test';
import {nextMoment} from '../../../web/view/play_time.js';

const TIMES = [0, 1, 1.5, 4];  // Steps need not be as far from each other.

function played(times, picturesPerSecond, stepsPerSecond, pictures) {
  const moments = [times[0]];
  while (moments.length <= pictures) moments.push(nextMoment(times, moments.at(-1), 1 / picturesPerSecond, stepsPerSecond));
  return moments;
}

test('however fast pictures come, a step lasts as long as one chose', () => {
  for (const rate of [10, 30, 60]) {
    const moments = played(TIMES, rate, 1, 3 * rate + 3);
    for (const [i, time] of TIMES.entries()) assert.ok(Math.abs(moments.indexOf(time) - i * rate) <= i, `${time} at ${moments.indexOf(time)} of ${rate} a second`);
  }
});

test('no step is left out by a server that draws slowly, and behind the last comes the first', () => {
  assert.deepEqual(played(TIMES, 0.2, 10, 5), [0, 1, 1.5, 4, 0, 1]);
  assert.deepEqual(played(TIMES, 20, 10, 4), [0, 0.5, 1, 1.25, 1.5]);
});

test('every picture moves, and its moment has no digits that mean nothing', () => {
  assert.ok(nextMoment(TIMES, 0, 0, 1) > 0);
  assert.equal(nextMoment([0, 0.3, 0.6], 0.3, 0.1, 1), 0.33);
});
