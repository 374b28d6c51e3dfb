// One WebSocket to the server. It is opened again whenever it ends, after pauses that grow.

import {Emitter} from '../page/emitter.js';

const FIRST_PAUSE_MS = 500, LONGEST_PAUSE_MS = 10000, SLOW_PAUSE_MS = 15000;
const WELCOME_WITHIN_MS = 10000;

/// What a person is told about a close code of docs/protocol.md, with what the server gave as its reason.
export function reasonOf(code, given = '') {
  switch (code) {
    case 1001: return 'The server stopped.';
    case 1002: return `Server and page do not speak the same protocol${given && ` (${given})`}. Reload the page.`;
    case 1008: case 1011: return `The server ended the connection${given && `: ${given}`}.`;
    case 1009: return 'The server ended the connection: a message was too large.';
    case 1013: return 'The server has as many viewers as it takes.';
    default: return '';
  }
}

/// Events: `open`; `message` (ArrayBuffer); `down` ({reason, retryAtMs}) when it ends or could not be made; `denied`
/// when the cookie is wrong, after which nothing is tried any more.
export class Connection extends Emitter {
  #socket = null;
  #failures = 0;
  #timer = 0;
  #welcomeTimer = 0;
  #reason = '';  // Why there is no connection. Attempts that fail know nothing better.

  constructor() {
    super();
    window.addEventListener('online', () => this.retryNow());
  }

  #address(name) {
    const url = new URL(name, document.baseURI);
    url.hash = '';
    url.search = '';  // The browser brings the cookie.
    return url;
  }

  connect() {
    clearTimeout(this.#timer);
    this.#timer = 0;
    const url = this.#address('stream');
    url.protocol = url.protocol === 'https:' ? 'wss:' : 'ws:';
    const socket = this.#socket = new WebSocket(url);
    let wasOpen = false;
    socket.binaryType = 'arraybuffer';
    socket.onopen = () => {
      wasOpen = true;
      this.#welcomeTimer = setTimeout(() => this.drop('The server does not answer.'), WELCOME_WITHIN_MS);
      this.emit('open');
    };
    socket.onmessage = ({data}) => this.emit('message', data);
    socket.onclose = ({code, reason}) => {
      if (socket !== this.#socket) return;
      this.#ended(reasonOf(code, reason), code === 1013 || code === 1002, !wasOpen);
    };
  }

  /// Welcome has come: the next failure starts with a short pause again.
  welcomed() {
    clearTimeout(this.#welcomeTimer);
    this.#failures = 0;
    this.#reason = '';
  }

  /// Returns false where there is no connection.
  send(message) {
    if (this.isOpen) this.#socket.send(message);
    return this.isOpen;
  }

  get isOpen() {
    return this.#socket !== null && this.#socket.readyState === WebSocket.OPEN;
  }

  /// Ends the connection because of something on this side. It is opened again.
  drop(reason) {
    const socket = this.#socket;
    this.#socket = null;
    if (socket) socket.close();
    this.#ended(reason, false, false);
  }

  retryNow() {
    if (this.#timer === 0) return;
    this.connect();
  }

  async #ended(reason, slowly, neverOpened) {
    clearTimeout(this.#welcomeTimer);
    clearTimeout(this.#timer);
    this.#socket = null;
    this.#reason = reason || this.#reason;
    // A browser does not tell why a WebSocket was refused; the same request without one does.
    if (neverOpened && await this.#isDenied()) return this.emit('denied');
    const pauseMs = slowly ? SLOW_PAUSE_MS : Math.min(LONGEST_PAUSE_MS, FIRST_PAUSE_MS * 2 ** this.#failures);
    const withJitterMs = pauseMs * (0.8 + 0.4 * Math.random());  // The viewers of a server should not all return at once.
    ++this.#failures;
    this.#timer = setTimeout(() => {
      this.#timer = 0;
      this.connect();
    }, withJitterMs);
    this.emit('down', {reason: this.#reason, retryAtMs: performance.now() + withJitterMs});
  }

  async #isDenied() {
    try {
      return (await fetch(this.#address('status'), {cache: 'no-store'})).status === 401;
    } catch {
      return false;
    }
  }
}
