// The server that the tests of page.test.js and navigation.test.js run against: the mock, or a real one.
//   AEOLIC_URL=http://…/?token=…   one that runs already
//   AEOLIC=path/to/aeolic          starts `aeolic serve` with a scene of its own

import {spawn} from 'node:child_process';
import {createInterface} from 'node:readline';
import {MockServer} from './mock/server.js';

const SCENE = ['--surface', 'torus', '--field', 'tornado'];
const STARTS_WITHIN_MS = 60000;

/// `aeolic serve` with the scene options `scene`.
export async function startAeolic(program, scene = SCENE) {
  const child = spawn(program, ['serve', ...scene, '--port', '0'], {stdio: ['ignore', 'pipe', 'inherit']});
  const url = await new Promise((resolve, reject) => {
    setTimeout(() => reject(new Error(`${program} serve printed no address`)), STARTS_WITHIN_MS).unref();
    child.once('error', reject).once('exit', (code) => reject(new Error(`${program} serve ended with ${code}`)));
    createInterface({input: child.stdout}).on('line', (line) => {
      const address = /https?:\/\/\S+/.exec(line);
      if (address) resolve(address[0]);
    });
  });
  return {url, stop: () => new Promise((resolve) => {
    child.removeAllListeners('exit').once('exit', resolve);
    child.kill('SIGTERM');
  })};
}

/// {url, stop()}; `mock` too where it is the mock.
export async function startServer() {
  if (process.env.AEOLIC_URL) return {url: process.env.AEOLIC_URL, stop: async () => {}};
  if (process.env.AEOLIC) return startAeolic(process.env.AEOLIC);
  const mock = await new MockServer().start();
  return {url: mock.url, mock, stop: () => mock.stop()};
}
