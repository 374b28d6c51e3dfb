// Lets the streaks flow: the Hann kernel's phase moves on with every picture that is on the screen, so the animation
// goes as fast as the server draws and never runs ahead of it.

const LONGEST_STEP_S = 0.1;  // After a pause (a hidden tab, a lost connection) the flow goes on where it was.
const HOLD = 'phase';

export class Phase {
  isRunning = false;
  speed = 0.5;  // Turns of the phase a second.
  #model;
  #session;
  #lastMs = 0;

  constructor({model, session, frames}) {
    this.#model = model;
    this.#session = session;
    frames.on('shown', () => this.#advance());
  }

  setSpeed(turnsPerSecond) {
    this.speed = turnsPerSecond;
  }

  run(isRunning) {
    if (isRunning === this.isRunning) return;
    this.isRunning = isRunning;
    if (!isRunning) {
      this.#session.pacer.release(HOLD);
      this.#model.emit('options', false);
      return;
    }
    this.#lastMs = performance.now();
    this.#session.pacer.hold(HOLD);
    this.#model.setOption('lic', 'kernel', 'hann', true);  // A box has no phase.
  }

  #advance() {
    if (!this.isRunning) return;
    const {kernel, method, style} = this.#model.options.lic;
    if (kernel !== 'hann' || method === 'none' || style !== 'dense') return this.run(false);
    const nowMs = performance.now(), seconds = Math.min(LONGEST_STEP_S, (nowMs - this.#lastMs) / 1000);
    this.#lastMs = nowMs;
    const turn = 2 * Math.PI, phase = this.#model.options.lic.phase + turn * this.speed * seconds;
    this.#model.setOption('lic', 'phase', Number((phase % turn).toFixed(4)), true);
  }
}
