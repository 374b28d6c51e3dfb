// Drags the slice and scrubs time on the page, in Chromium, against the real program: how often a new picture comes, how long
// the longest gap is, whether the last picture is the last wish, and what others who look around have left.
//   AEOLIC=build/release/aeolic node bench/page/changes.js [SECONDS [ROUNDS]]
// Needs what tests/browser/run needs. Times are those of a busy machine, too: its load is told. What others keep is measured in
// rounds, each between two looks at what they have without changes, and the middle one is told.

import {spawn} from 'node:child_process';
import {mkdtemp, rm, writeFile} from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import {createInterface} from 'node:readline';
import {fileURLToPath} from 'node:url';
import {closeBrowser, openPage, recordSent, waitForRest, waitForState} from '../../tests/browser/harness.js';
import {startAeolic} from '../../tests/browser/servers.js';

const ROUNDS = Number(process.argv[3] ?? 3), seconds = Number(process.argv[2] ?? 30) / ROUNDS, program = path.resolve(process.env.AEOLIC), STEPS = 21, SIDE = 24;
const LOOK_AROUND = fileURLToPath(new URL('look_around', import.meta.url));
const folder = await mkdtemp(path.join(os.tmpdir(), 'aeolic-changes-'));
const SETTLES_WITHIN_MS = 20000;
const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

/// A flow that turns, in so many steps of time.
async function series() {
  const ends = `0 ${SIDE - 1} 0 ${SIDE - 1} 0 ${SIDE - 1}`, steps = [];
  for (let step = 0; step < STEPS; ++step) {
    const values = [], turn = step / 4;
    for (let i = 0; i < SIDE ** 3; ++i) {
      const [x, y, z] = [i % SIDE, Math.floor(i / SIDE) % SIDE, Math.floor(i / SIDE ** 2)].map((at) => at / SIDE - 0.5);
      values.push([Math.cos(turn) - y, Math.sin(turn) + x, 0.3 * z].map((v) => v.toFixed(4)).join(' '));
    }
    await writeFile(path.join(folder, `flow${step}.vti`), `<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian"><ImageData WholeExtent="${ends}" Origin="0 0 0" Spacing="1 1 1"><Piece Extent="${ends}"><PointData Vectors="U"><DataArray type="Float32" Name="U" NumberOfComponents="3" format="ascii">${values.join(' ')}</DataArray></PointData></Piece></ImageData></VTKFile>`);
    steps.push(`<DataSet timestep="${step}" file="flow${step}.vti"/>`);
  }
  const file = path.join(folder, 'flow.pvd');
  await writeFile(file, `<VTKFile type="Collection" version="1.0"><Collection>${steps.join('')}</Collection></VTKFile>`);
  return file;
}

class Others {
  constructor(address, count) {
    this.all = Array.from({length: count}, () => {
      const child = spawn('python3', [LOOK_AROUND, address], {stdio: ['pipe', 'pipe', 'inherit']});
      return {child, lines: createInterface({input: child.stdout})[Symbol.asyncIterator]()};
    });
  }
  async pictures() {
    let sum = 0;
    for (const {child, lines} of this.all) {
      child.stdin.write('\n');
      sum += Number((await lines.next()).value);
    }
    return sum;
  }
  end() {
    for (const {child} of this.all) child.kill();
  }
}

const sorted = (list) => [...list].sort((a, b) => a - b);
const middle = (list) => sorted(list)[Math.floor(list.length / 2)] ?? NaN;

/// Drags one slider to and fro. Returns what came of it.
async function drag(page, sent, scenes, slider, rateWhile) {
  await page.evaluate(() => {
    window.shownMs = [];
    window.watcher?.disconnect();
    window.watcher = new MutationObserver(() => window.shownMs.push(performance.now()));
    window.watcher.observe(document.documentElement, {attributeFilter: ['data-frame']});
  });
  const {x, y, width, height} = await slider.boundingBox(), at = (part) => page.mouse.move(x + width * (0.1 + 0.8 * part), y + height / 2);
  await at(0.5);
  await page.mouse.down();
  const before = sent.changes().length, rate = await rateWhile(async () => {
    for (const startMs = performance.now(); performance.now() - startMs < 1000 * seconds;) {
      await at(0.5 + 0.5 * Math.sin((performance.now() - startMs) / 1500));
      await pause(16);
    }
  });
  await at(0.8);
  const shownMs = await page.evaluate(() => window.shownMs);  // Before the pictures at rest.
  await page.mouse.up();
  const wishesSent = () => sent.changes().map(({change, moving, ...wish}) => wish).filter((wish) => Object.keys(wish).length > 0);
  const isLast = async () => {
    const last = wishesSent().at(-1), scene = scenes.at(-1);
    return (last.cuts?.[0] ?? scene.scene.surface.spec) === scene.scene.surface.spec && (last.time ?? scene.time) === scene.time &&
           await page.evaluate(() => document.documentElement.dataset.lossless) === 'true';
  };
  const restMs = performance.now();
  await pause(300);  // The scene rests a moment after the last wish.
  while (!await isLast() && performance.now() - restMs < SETTLES_WITHIN_MS) await pause(50);
  const settledMs = performance.now() - restMs, wishes = wishesSent();
  return {pictures: shownMs.length, wishes: wishes.length - before, gaps: shownMs.slice(1).map((ms, i) => ms - shownMs[i]),
          settledMs, isLast: await isLast(), rate};
}

async function measure(name, scene, find) {
  const server = await startAeolic(program, scene);
  try {
    for (const count of [0, 2]) {
      const others = new Others(server.url, count), page = await openPage(null), scenes = [], sent = recordSent(page);
      page.on('websocket', (socket) => socket.on('framereceived', ({payload}) => payload[2] === 0x43 && scenes.push(JSON.parse(payload.subarray(8).toString()))));
      await page.goto(server.url);
      await waitForState(page, 'ready');
      await waitForRest(page);
      const slider = await find(page);
      await pause(2000);
      const rateWhile = async (action) => {
        const had = await others.pictures(), startMs = performance.now();
        await action();
        return 1000 * ((await others.pictures()) - had) / (performance.now() - startMs);
      };
      const rounds = [], without = [], kept = [];
      const rest = async () => count > 0 && without.push(await rateWhile(() => pause(500 * seconds)));
      await rest();
      for (let round = 0; round < ROUNDS; ++round) {
        rounds.push(await drag(page, sent, scenes, slider, rateWhile));
        await rest();
        kept.push(2 * rounds.at(-1).rate / (without.at(-1) + without.at(-2)));
      }
      const sum = (key) => rounds.reduce((all, one) => all + one[key], 0), gaps = sorted(rounds.flatMap((one) => one.gaps));
      console.log(`${name}, ${count === 0 ? 'alone' : 'beside two'}: ${sum('wishes')} changes sent, ${sum('pictures')} pictures, one each ${middle(gaps).toFixed(0)} ms, worst gap ${(gaps.at(-1) ?? NaN).toFixed(0)} ms, ` +
                  `the last is ${rounds.every((one) => one.isLast) ? '' : 'NOT '}the last wish, exact after ${middle(rounds.map((one) => one.settledMs)).toFixed(0)} ms${count ? `, others keep ${(100 * middle(kept)).toFixed(0)} % of ${middle(without).toFixed(1)} pictures a second` : ''}; load ${os.loadavg()[0].toFixed(1)} on ${os.cpus().length} cores`);
      others.end();
      await page.context().close();
    }
  } finally {
    await server.stop();
  }
}

try {
  const file = await series();
  await measure('slice', ['--surface', 'slice:12,12,12:1,0,0', '--field', file, '--color-by', 'U:mag'], async (page) => {
    await page.locator('summary', {hasText: /^Surface$/}).click();
    const slider = page.getByRole('slider', {name: 'Position'});
    await slider.scrollIntoViewIfNeeded();
    return slider;
  });
  await measure('time', ['--surface', 'boundary', '--field', file], async (page) => page.locator('#time-slider'));
} finally {
  await closeBrowser();
  await rm(folder, {recursive: true});
}
