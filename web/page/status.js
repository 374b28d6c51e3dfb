// What a person is told while there is no fresh picture: a card before the first one, a line over the dimmed last one.

import {byId} from './dom.js';
import {inPageWords} from './words.js';

/// What to tell about a session: {kind, title, text, fraction (null: not known), isDimmed, canRetry, canStart}. kind is connecting | denied | lost
/// | loading | drawing | ready | restarting | failed.
export function statusOf({link, lost, state}, hasPicture, nowMs) {
  if (link === 'denied')
    return {kind: 'denied', title: 'This address does not open it',
            text: 'The token is missing, wrong or of an earlier start. Open the whole address that aeolic serve printed last, with the token in it.', isDimmed: true};
  if (link === 'connecting') return {kind: 'connecting', title: 'Connecting', text: ''};
  if (link === 'lost') {
    const seconds = Math.max(0, Math.ceil((lost.retryAtMs - nowMs) / 1000));
    return {kind: 'lost', title: hasPicture ? 'Connection lost' : 'No connection', isDimmed: true, canRetry: true,
            text: `${lost.reason} ${seconds > 0 ? `Trying again in ${seconds} s.` : 'Trying again.'}`.trim()};
  }
  const {state: name, what, fraction, message} = state;
  if (name === 'loading') return {kind: 'loading', title: 'Loading', text: what ?? '', fraction: fraction > 0 && fraction < 1 ? fraction : null};
  if (name === 'restarting') return {kind: 'restarting', title: 'Restarting', text: message ?? '', isDimmed: true};
  if (name === 'failed') return {kind: 'failed', title: 'It stopped', text: message ?? '', isDimmed: true, canStart: true};
  return hasPicture ? {kind: 'ready', title: 'Ready', text: ''} : {kind: 'drawing', title: 'Drawing', text: ''};
}

export class Status {
  #session;
  #hasPicture = false;
  #kind = '';
  #showTimer = 0;

  constructor(session, frames) {
    this.#session = session;
    session.on('status', () => this.#show());
    frames.on('drawn', () => {
      if (this.#hasPicture) return;
      this.#hasPicture = true;
      this.#show();
    });
    byId('retry').addEventListener('click', () => session.retryNow());
    byId('start-again').addEventListener('click', () => session.askForStart());
    setInterval(() => this.#show(), 500);  // Shows the seconds being counted down.
    this.#show();
  }

  #show() {
    const status = statusOf(this.#session, this.#hasPicture, performance.now());
    const {kind, title, text, fraction, isDimmed = false, canRetry = false, canStart = false} = status, root = document.documentElement;
    root.dataset.state = kind;
    document.body.classList.toggle('dimmed', isDimmed && this.#hasPicture);
    const box = byId('status'), isQuiet = kind === 'ready';
    box.classList.toggle('card', !this.#hasPicture || kind === 'denied');
    // Loading a time step takes a moment only; a line that flashes up for it would be noise.
    if (kind !== this.#kind) {
      clearTimeout(this.#showTimer);
      box.hidden = true;
      const delayMs = kind === 'loading' && this.#hasPicture ? 400 : 0;
      if (!isQuiet) this.#showTimer = setTimeout(() => { box.hidden = false; }, delayMs);
      this.#kind = kind;
    }
    if (isQuiet) return;
    box.dataset.kind = kind;
    byId('status-title').textContent = title;
    byId('status-text').textContent = inPageWords(text);
    byId('retry').hidden = !canRetry;
    byId('start-again').hidden = !canStart;
    const bar = byId('progress');
    bar.hidden = fraction === undefined;
    // One file that is read may be followed by another, and by work that nobody counts.
    if (fraction === null) bar.removeAttribute('value');
    else if (fraction !== undefined) bar.value = fraction;
  }
}
