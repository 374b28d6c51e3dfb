// Decides when Views are sent. While something moves, at most one is sent per animation frame, and at most one waits
// beyond the one being drawn: a slow server or line never works off a queue of old views. The final view, at rest, is
// sent at once.

const REST_AFTER_MS = 150;
const MOST_UNANSWERED = 2;
const GIVE_UP_MS = 5000;  // A view that no frame answered for so long is forgotten, or nothing would move any more.

export class Pacer {
  #send;
  #wanted = null;  // null | 'moving' | 'rest'
  #unanswered = [];  // {view, sentMs}
  #holds = new Set();
  #restTimer = 0;
  #isScheduled = false;
  #lastSentMs = -Infinity;
  shortestPauseMs = 0;

  /// send(isMoving) sends the newest view and returns its number, or null where nothing can be sent.
  constructor(send) {
    this.#send = send;
  }

  /// The view changed, and more may follow.
  touch() {
    this.#wanted = 'moving';
    clearTimeout(this.#restTimer);
    if (this.#holds.size === 0) this.#restTimer = setTimeout(() => this.settle(), REST_AFTER_MS);
    this.#schedule();
  }

  /// The view stays as it is now and may be drawn at full size, lossless. While hold() holds, it is one more change.
  settle() {
    if (this.#holds.size > 0) return this.touch();
    clearTimeout(this.#restTimer);
    this.#wanted = 'rest';
    this.#schedule();
  }

  /// An animation goes on by itself: there is no rest until release().
  hold(name) {
    this.#holds.add(name);
    clearTimeout(this.#restTimer);
  }

  release(name) {
    if (this.#holds.delete(name) && this.#holds.size === 0) this.settle();
  }

  /// The frame of `view` is complete: this view and those before it wait no more. Returns when it was sent, or null.
  answered(view) {
    const sentMs = this.#unanswered.find((one) => one.view === view)?.sentMs ?? null;
    this.#unanswered = this.#unanswered.filter((one) => one.view > view);
    if (this.#wanted) this.#schedule();
    return sentMs;
  }

  /// Nothing that was sent will be answered.
  forget() {
    this.#unanswered = [];
    if (this.#wanted) this.#schedule();
  }

  #schedule() {
    if (this.#isScheduled) return;
    this.#isScheduled = true;
    requestAnimationFrame((nowMs) => {
      this.#isScheduled = false;
      this.#sendIfDue(nowMs);
    });
  }

  #sendIfDue() {
    if (!this.#wanted) return;
    const nowMs = performance.now();
    this.#unanswered = this.#unanswered.filter((one) => nowMs - one.sentMs < GIVE_UP_MS);
    const isMoving = this.#wanted === 'moving';
    if (isMoving && this.#unanswered.length >= MOST_UNANSWERED) return;  // answered() comes back here.
    if (nowMs - this.#lastSentMs < this.shortestPauseMs) return this.#schedule();
    const view = this.#send(isMoving);
    if (view === null) return;
    this.#wanted = null;
    this.#lastSentMs = nowMs;
    this.#unanswered.push({view, sentMs: nowMs});
  }
}
