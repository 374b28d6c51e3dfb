// The bar under the picture for scenes with several time steps: play, pause, step, scrub. Time is shared by all
// viewers.

import {byId, numberText} from './dom.js';
import {setIcon} from './icons.js';
import {nextMoment} from '../view/play_time.js';
import {timeOf} from '../view/surface_spec.js';

const HOLD = 'time';
const STUCK_MS = 4000;  // A picture that does not come for so long is not waited for.

export class Times {
  isPlaying = false;
  #times = [];
  #now = 0;       // The time that is shown, or was asked for last.
  #movedMs = 0;   // While playing: when the last moment was asked for.
  #watch = 0;     // While playing: the timer that sees whether it goes on.
  #model;
  #changes;
  #parts;

  constructor({model, changes, frames}) {
    this.#model = model;
    this.#changes = changes;
    this.#parts = {bar: byId('times'), play: byId('time-play'), slider: byId('time-slider'), text: byId('time-text'),
                   ticks: byId('time-ticks'), pace: byId('time-pace')};
    const {play, slider} = this.#parts;
    play.addEventListener('click', () => this.play(!this.isPlaying));
    byId('time-previous').addEventListener('click', () => this.step(-1));
    byId('time-next').addEventListener('click', () => this.step(1));
    slider.addEventListener('input', () => {
      this.play(false);
      this.#ask(Number(slider.value), true);
    });
    slider.addEventListener('keydown', (event) => {
      const by = {ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1}[event.key];
      if (!by) return;
      event.preventDefault();
      this.step(by);
    });
    model.on('scene', (message) => this.#loaded(message));
    changes.on('changed', () => this.#follow());
    frames.on('shown', () => this.#advance());
    this.#showPlaying();
  }

  get isThere() {
    return this.#times.length > 1;
  }

  play(isPlaying) {
    if (!this.isThere || isPlaying === this.isPlaying) return;
    this.isPlaying = isPlaying;
    this.#showPlaying();
    clearInterval(this.#watch);
    if (!isPlaying) return this.#changes.release(HOLD);
    this.#watch = setInterval(() => performance.now() - this.#movedMs > STUCK_MS && this.#advance(), STUCK_MS / 4);
    this.#changes.hold(HOLD);
    this.#movedMs = performance.now();
    this.#advance();
  }

  /// Goes to the next or the previous time step.
  step(by) {
    this.play(false);
    const small = 1e-9 * (this.#times.at(-1) - this.#times[0]);
    const next = by > 0 ? this.#times.find((time) => time > this.#now + small)
                        : this.#times.findLast((time) => time < this.#now - small);
    if (next !== undefined) this.#ask(next);
  }

  #ask(time, isMoving = false) {
    this.#changes.request({time}, isMoving);
  }

  // Called when the picture of the last moment is on screen: asks for the next one.
  #advance() {
    if (!this.isPlaying || this.#changes.wish('time') !== undefined) return;
    const nowMs = performance.now(), next = nextMoment(this.#times, this.#now, (nowMs - this.#movedMs) / 1000, Number(this.#parts.pace.value));
    this.#movedMs = nowMs;
    this.#ask(next, true);
  }

  #loaded(message) {
    this.#times = message.choices?.times ?? [];
    const {bar, slider, ticks} = this.#parts;
    bar.hidden = !this.isThere;
    if (!this.isThere) return this.play(false);
    const [first, last] = [this.#times[0], this.#times.at(-1)];
    slider.min = first;
    slider.max = last;
    ticks.replaceChildren(...(this.#times.length <= 64 ? this.#times : []).map((time) => {
      const tick = document.createElement('i');
      tick.style.left = `${100 * (time - first) / (last - first)}%`;
      return tick;
    }));
    this.#follow();
  }

  // Shows the moment that is wanted, or else the moment that is shown.
  #follow() {
    if (!this.isThere) return;
    const wanted = this.#changes.wish('time') ?? timeOf(this.#model.scene) ?? this.#now;
    this.#now = Math.max(this.#times[0], Math.min(this.#times.at(-1), wanted));
    this.#show();
  }

  #show() {
    const {slider, text} = this.#parts;
    const first = this.#times[0], last = this.#times.at(-1), at = this.#times.findLastIndex((time) => time <= this.#now);
    slider.value = this.#now;
    slider.style.setProperty('--part', (this.#now - first) / (last - first));
    slider.setAttribute('aria-valuetext', `time ${numberText(this.#now)}, step ${at + 1} of ${this.#times.length}`);
    text.textContent = `t = ${numberText(this.#now)}`;
    byId('time-step').textContent = `${at + 1} / ${this.#times.length}`;
  }

  #showPlaying() {
    const {play} = this.#parts;
    setIcon(play, this.isPlaying ? 'pause' : 'play');
    play.setAttribute('aria-label', this.isPlaying ? 'Pause' : 'Play');
    play.title = this.isPlaying ? 'Pause (Space)' : 'Play (Space)';
  }
}
