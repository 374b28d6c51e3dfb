// Tiles to pixels: lossless ones in workers, JPEG by the browser.

import {crc32} from '../net/crc32.js';
import {Codec} from '../net/protocol.js';

const WORKERS = Math.max(1, Math.min(4, Math.floor((navigator.hardwareConcurrency || 2) / 2)));

const waiting = new Map();  // job -> {resolve, reject}
let workers = null, lastJob = 0;

function startWorkers() {
  workers = Array.from({length: WORKERS}, () => {
    const worker = new Worker(new URL('decode_worker.js', import.meta.url), {type: 'module'});
    worker.onmessage = ({data}) => {
      const job = waiting.get(data.job);
      waiting.delete(data.job);
      if (data.error) job.reject(new Error(data.error));
      else job.resolve({rgba: data.rgba});
    };
    // If a worker cannot start, what waits for it fails. The frames then count as shown, and the person is told.
    worker.onerror = (event) => {
      for (const job of waiting.values()) job.reject(new Error(event.message || 'the decoder did not start'));
      waiting.clear();
    };
    return worker;
  });
}

function inWorker(tile) {
  if (!workers) startWorkers();
  return new Promise((resolve, reject) => {
    const job = ++lastJob;
    waiting.set(job, {resolve, reject});
    workers[job % WORKERS].postMessage({...tile, job}, [tile.encoded.buffer]);
  });
}

async function jpeg(tile) {
  if (crc32(tile.encoded) !== tile.crc) throw new RangeError('tile has another checksum');
  const bitmap = await createImageBitmap(new Blob([tile.encoded], {type: 'image/jpeg'}),
                                         {colorSpaceConversion: 'none', premultiplyAlpha: 'none'});
  if (bitmap.width !== tile.width || bitmap.height !== tile.rows) throw new RangeError('JPEG has another size than its tile');
  return {bitmap};
}

/// A promise of {rgba} or {bitmap}. The tile's bytes are given away; nothing else may use them afterwards.
export function decodeTile(tile) {
  return tile.codec === Codec.jpeg ? jpeg(tile) : inWorker(tile);
}
