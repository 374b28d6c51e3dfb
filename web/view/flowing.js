// Lets the streaks flow while nothing else moves. The server draws a few pictures of one cycle, and then has nothing to do:
// CyclePlayer draws those between them, at the screen's rate, also while the server is away. Whatever changes the picture
// ends that, and the next cycle is asked for when the view is at rest again.

import {CyclePlayer} from '../picture/cycle.js';
import {FLOW_PICTURES} from './model.js';

const LONGEST_STEP_S = 0.1;  // After a pause (a hidden tab) the flow goes on where it was.

export class Flowing {
  speed = 0.5;  // Turns of the cycle a second.
  isPlaying = false;  // The cycle is here.
  #page;
  #canvas;
  #makePlayer;
  #player = null;
  #pictures = [];
  #turns = 0;
  #lastMs = 0;

  /// `canvas` lies over the picture's own.
  constructor(page, canvas, makePlayer = (canvas) => new CyclePlayer(canvas)) {
    this.#page = page;
    this.#canvas = canvas;
    this.#makePlayer = makePlayer;
    const {model, frames, stage, session} = page, again = () => this.#startAgain();
    model.on('camera', again).on('options', again).on('scene', again);
    stage.on('resize', again);
    session.on('following', again).on('sent', (isMoving) => isMoving && again());
    frames.on('drawn', (frame) => !frame.lossless && again()).on('shown', (frame) => this.#take(frame));
  }

  get isRunning() {
    return this.#page.model.flows;
  }

  setSpeed(turnsPerSecond) {
    this.speed = turnsPerSecond;
  }

  run(isRunning) {
    if (isRunning !== this.isRunning) this.#page.model.setFlows(isRunning);
  }

  #startAgain() {
    this.#pictures = [];
    this.isPlaying = false;
    this.#canvas.hidden = true;
    this.#page.model.flowStep = 0;
  }

  #take(frame) {
    const {model, session} = this.#page;
    if (!this.isRunning || this.isPlaying || !frame.lossless || !frame.pixels || !session.isNewest(frame)) return;
    const first = this.#pictures[0], step = model.flowStep;
    if (step !== this.#pictures.length || first && (first.width !== frame.width || first.height !== frame.height)) return;
    this.#pictures.push(new ImageData(frame.pixels, frame.width, frame.height));
    if (this.#pictures.length === FLOW_PICTURES) return this.#play();
    model.flowStep = step + 1;
    session.pacer.settle();
  }

  #play() {
    const {model, frames} = this.#page;
    try {
      this.#player ??= this.#makePlayer(this.#canvas);
      const boxes = this.#player.setPictures(this.#pictures);
      if (model.background === 'transparent') frames.clear(boxes);  // One would see through what flows.
    } catch (error) {
      model.setFlows(false);
      return this.#page.tell(`The streaks cannot flow here: ${error.message}.`);
    }
    this.#canvas.style.cssText = frames.canvas.style.cssText;
    this.#canvas.hidden = false;
    this.isPlaying = true;
    this.#turns = (FLOW_PICTURES - 1) / FLOW_PICTURES;  // The picture that is on the screen.
    this.#lastMs = performance.now();
    this.#player.draw(this.#turns);
    requestAnimationFrame((nowMs) => this.#step(nowMs));
  }

  #step(nowMs) {
    if (!this.isPlaying) return;
    this.#turns = (this.#turns + this.speed * Math.max(0, Math.min(LONGEST_STEP_S, (nowMs - this.#lastMs) / 1000))) % 1;
    this.#lastMs = nowMs;
    this.#player.draw(this.#turns);
    requestAnimationFrame((next) => this.#step(next));
  }
}
