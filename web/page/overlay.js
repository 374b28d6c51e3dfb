// Statistics over the picture: how fast, where the time goes, and which rank drew which rows with how much work.

import {bytesText, byId, h, recall, remember} from './dom.js';

const WINDOW_MS = 2000;      // Frames a second and bytes a second are means over this time.
const CURVE_FRAMES = 60;
const STAGE_NAMES = {project: 'Project', composite: 'Composite', convolve: 'Convolve', shade: 'Shade', gather: 'Gather'};

const ms = (value) => value >= 100 ? value.toFixed(0) : value.toFixed(1);

export class Overlay {
  isOn = recall('statistics') === 'on';
  #shown = [];  // {atMs, bytes}
  #latencies = [];
  #last = null;

  constructor(frames) {
    byId('stats-button').addEventListener('click', () => this.toggle());
    frames.on('shown', (frame) => this.#add(frame));
    setInterval(() => this.#show(), 1000);  // The number of frames a second falls when no frame comes.
    this.#show();
  }

  toggle() {
    this.isOn = !this.isOn;
    remember('statistics', this.isOn ? 'on' : null);
    this.#show();
  }

  #add(frame) {
    const nowMs = performance.now();
    this.#last = {...frame, pixels: null};
    this.#shown.push({atMs: nowMs, bytes: frame.bytes});
    if (frame.latencyMs !== null && frame.latencyMs !== undefined) this.#latencies.push(frame.latencyMs);
    this.#latencies = this.#latencies.slice(-CURVE_FRAMES);
    this.#show();
  }

  #show() {
    byId('stats-button').setAttribute('aria-pressed', String(this.isOn));
    byId('stats').hidden = byId('stripes').hidden = !this.isOn || !this.#last;
    if (!this.isOn || !this.#last) return;
    const nowMs = performance.now(), frame = this.#last;
    this.#shown = this.#shown.filter(({atMs}) => nowMs - atMs < WINDOW_MS);
    const perSecond = 1000 / WINDOW_MS, sum = this.#shown.reduce((bytes, one) => bytes + one.bytes, 0);
    const lines = [
      ['Pictures', `${(this.#shown.length * perSecond).toFixed(1)} fps`],
      ['Latency', this.#latencies.length ? `${ms(this.#latencies.at(-1))} ms` : '–'],
      ['Size', `${frame.width} × ${frame.height}${frame.lossless ? ', exact' : ''}`],
      ['Sent as', `${[...frame.codecs].join(', ')}, ${frame.tiles} ${frame.tiles === 1 ? 'tile' : 'tiles'}`],
      ['Bytes', bytesText(frame.bytes)],
      ['Stream', `${bytesText(Math.round(sum * perSecond))}/s`],
    ];
    byId('stats-lines').replaceChildren(...lines.flatMap(([name, value]) => [h('dt', {}, name), h('dd', {}, value)]));
    this.#showCurve();
    this.#showStages(frame.stats);
    this.#showStripes(frame);
  }

  #showCurve() {
    const highest = Math.max(100, ...this.#latencies);
    byId('stats-curve').replaceChildren(...this.#latencies.map((value) => {
      const bar = h('i');
      bar.style.height = `${Math.max(4, 100 * value / highest)}%`;
      return bar;
    }));
  }

  #showStages(stats) {
    const stages = {...stats.stagesMs};
    if (typeof stats.encodeMs === 'number') stages.encode = stats.encodeMs;
    const total = Math.max(1e-9, ...Object.values(stages).filter(Number.isFinite));
    byId('stats-total').textContent = typeof stats.totalMs === 'number' ? `${ms(stats.totalMs)} ms` : '';
    byId('stats-stages').replaceChildren(...Object.entries(stages).filter(([, value]) => Number.isFinite(value)).map(([name, value]) => {
      const bar = h('span', {class: 'bar'}, h('i'));
      bar.firstChild.style.width = `${100 * value / total}%`;
      return h('div', {class: 'stage'}, h('span', {}, STAGE_NAMES[name] ?? name[0].toUpperCase() + name.slice(1)), bar,
               h('span', {class: 'amount'}, ms(value)));
    }));
  }

  // A rank's load is its busy time as a part of the busiest rank's.
  #showStripes(frame) {
    const ranks = Array.isArray(frame.stats.ranks) ? frame.stats.ranks : [];
    const busiest = Math.max(1e-9, ...ranks.map((rank) => rank.busyMs ?? 0)), {style} = byId('picture'), stripes = byId('stripes');
    for (const side of ['left', 'top', 'width', 'height']) stripes.style[side] = style[side];
    stripes.replaceChildren(...ranks.filter((rank) => rank.rows > 0).map((rank) => {
      const load = (rank.busyMs ?? 0) / busiest, label = h('span', {}, `Rank ${rank.rank}`, h('b', {}, `${ms(rank.busyMs ?? 0)} ms`), h('i'));
      const stripe = h('div', {class: 'stripe'}, label);
      stripe.style.top = `${100 * rank.firstRow / frame.height}%`;
      stripe.style.height = `${100 * rank.rows / frame.height}%`;
      stripe.style.setProperty('--load', load);
      return stripe;
    }));
  }
}
