// The parts of RFC 6455 that a test server needs: binary messages, fragments, ping, close.

import {createHash} from 'node:crypto';
import {EventEmitter} from 'node:events';

const GUID = '258EAFA5-E914-47DA-95CA-C5AB0DC85B11';

/// Events: `message` (Buffer), `close`.
export class WebSocketConnection extends EventEmitter {
  #socket;
  #bytes = Buffer.alloc(0);
  #parts = [];

  constructor(request, socket, head) {
    super();
    this.#socket = socket;
    const accept = createHash('sha1').update(request.headers['sec-websocket-key'] + GUID).digest('base64');
    socket.write(`HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Accept: ${accept}\r\n\r\n`);
    socket.setNoDelay(true);
    socket.on('data', (data) => this.#read(data));
    socket.on('close', () => this.emit('close'));
    socket.on('error', () => {});
    if (head.length > 0) this.#read(head);
  }

  #read(data) {
    this.#bytes = Buffer.concat([this.#bytes, data]);
    for (;;) {
      const bytes = this.#bytes;
      if (bytes.length < 2) return;
      let length = bytes[1] & 127, at = 2;
      if (length === 126) { length = bytes.length < 4 ? Infinity : bytes.readUInt16BE(2); at = 4; }
      else if (length === 127) { length = bytes.length < 10 ? Infinity : Number(bytes.readBigUInt64BE(2)); at = 10; }
      if (bytes.length < at + 4 + length) return;
      const mask = bytes.subarray(at, at + 4), payload = Buffer.from(bytes.subarray(at + 4, at + 4 + length));
      for (let i = 0; i < length; ++i) payload[i] ^= mask[i & 3];
      this.#bytes = bytes.subarray(at + 4 + length);
      this.#frame(bytes[0] & 15, (bytes[0] & 128) !== 0, payload);
    }
  }

  #frame(opcode, isLast, payload) {
    if (opcode === 8) return this.close(1000);
    if (opcode === 9) return this.#write(10, payload);
    if (opcode === 10) return;
    if (opcode === 1) return this.close(1002);
    this.#parts.push(payload);
    if (!isLast) return;
    const message = Buffer.concat(this.#parts);
    this.#parts = [];
    this.emit('message', message);
  }

  #write(opcode, payload) {
    if (this.#socket.destroyed) return;
    const long = payload.length > 65535, middle = payload.length > 125;
    const header = Buffer.alloc(long ? 10 : middle ? 4 : 2);
    header[0] = 128 | opcode;
    header[1] = long ? 127 : middle ? 126 : payload.length;
    if (long) header.writeBigUInt64BE(BigInt(payload.length), 2);
    else if (middle) header.writeUInt16BE(payload.length, 2);
    this.#socket.write(Buffer.concat([header, payload]));
  }

  send(message) {
    this.#write(2, message);
  }

  close(code, reason = '') {
    const number = Buffer.alloc(2);
    number.writeUInt16BE(code);
    this.#write(8, Buffer.concat([number, Buffer.from(reason)]));
    this.#socket.end();
  }

  /// Cuts the line: sends no close frame.
  cut() {
    this.#socket.destroy();
  }
}
