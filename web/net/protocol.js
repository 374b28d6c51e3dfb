// The stream protocol, version 1 (docs/protocol.md): bytes to messages and back. Every check stands here, so the
// rest of the page only sees messages that are whole.

export const MAGIC = 0xae, VERSION = 1, HEADER_BYTES = 8;

export const Type = Object.freeze({
  hello: 0x01, view: 0x02, shown: 0x03, change: 0x04, follow: 0x05, start: 0x06, pick: 0x07,
  welcome: 0x41, state: 0x42, scene: 0x43, frame: 0x44, tile: 0x45, frameEnd: 0x46, notice: 0x47, offer: 0x48, changed: 0x49,
  picked: 0x4a,
});

export const Codec = Object.freeze({raw: 0, jpeg: 1, png: 2, lz4: 3, lzo: 4});
export const CODEC_NAMES = ['raw', 'jpeg', 'png', 'lz4', 'lzo'];

const KIB = 1024, MIB = 1024 * KIB;
const FRAME_BYTES = 28, TILE_BYTES = 24, FRAME_END_BYTES = 4;
const LARGEST_SIDE_PX = 32768;  // The largest picture of the protocol. What a server allows is in its Welcome.
const LARGEST_PICTURE_PX = 1 << 28;

// What a viewer may be sent: [shortest, longest] payload in bytes.
const PAYLOAD_BYTES = {
  [Type.welcome]: [2, MIB], [Type.state]: [2, 64 * KIB], [Type.scene]: [2, 4 * MIB], [Type.frame]: [FRAME_BYTES, FRAME_BYTES],
  [Type.tile]: [TILE_BYTES, 64 * MIB], [Type.frameEnd]: [FRAME_END_BYTES + 2, MIB], [Type.notice]: [2, 64 * KIB],
  [Type.offer]: [2, MIB], [Type.changed]: [4, 4], [Type.picked]: [2, 64 * KIB],
};

export class ProtocolError extends Error {}

function check(isFine, what) {
  if (!isFine) throw new ProtocolError(what);
}

function withHeader(type, payload) {
  const message = new Uint8Array(HEADER_BYTES + payload.length);
  message[0] = MAGIC;
  message[1] = VERSION;
  message[2] = type;
  new DataView(message.buffer).setUint32(4, payload.length, true);
  message.set(payload, HEADER_BYTES);
  return message;
}

/// A message with one JSON object: Hello, View, Change, Pick.
export function jsonMessage(type, object) {
  return withHeader(type, new TextEncoder().encode(JSON.stringify(object)));
}

/// A message with one number: Shown, Follow.
export function numberMessage(type, number) {
  const payload = new Uint8Array(4);
  new DataView(payload.buffer).setUint32(0, number, true);
  return withHeader(type, payload);
}

/// A message without a payload: Start.
export function emptyMessage(type) {
  return withHeader(type, new Uint8Array(0));
}

const decoder = new TextDecoder('utf-8', {fatal: true, ignoreBOM: true});

function parseJson(bytes, what) {
  let value;
  try {
    value = JSON.parse(decoder.decode(bytes));
  } catch (error) {
    throw new ProtocolError(`${what} is not JSON: ${error.message}`);
  }
  check(value !== null && typeof value === 'object' && !Array.isArray(value), `${what} is not a JSON object`);
  return value;
}

function parseFrame(data) {
  const u32 = (offset) => data.getUint32(HEADER_BYTES + offset, true);
  const flags = u32(24);
  const frame = {frame: u32(0), viewer: u32(4), view: u32(8), width: u32(12), height: u32(16), askedWidth: u32(20),
                 lossless: (flags & 1) !== 0};
  check((flags & ~1) === 0, `Frame has unknown flags ${flags}`);
  for (const side of [frame.width, frame.height, frame.askedWidth])
    check(side >= 1 && side <= LARGEST_SIDE_PX, `Frame has a side of ${side} pixels`);
  check(frame.width * frame.height <= LARGEST_PICTURE_PX, `Frame has ${frame.width} x ${frame.height} pixels`);
  return frame;
}

function parseTile(data, bytes) {
  const u32 = (offset) => data.getUint32(HEADER_BYTES + offset, true);
  const tile = {frame: u32(0), firstRow: u32(4), rows: u32(8), width: u32(12), rank: data.getUint16(HEADER_BYTES + 16, true),
                codec: bytes[HEADER_BYTES + 18], bytesPerPixel: bytes[HEADER_BYTES + 19], crc: u32(20),
                encoded: bytes.subarray(HEADER_BYTES + TILE_BYTES)};
  check(tile.width >= 1 && tile.width <= LARGEST_SIDE_PX, `Tile has a width of ${tile.width}`);
  check(tile.rows >= 1 && tile.firstRow + tile.rows <= LARGEST_SIDE_PX, `Tile has rows ${tile.firstRow} + ${tile.rows}`);
  check(tile.codec < CODEC_NAMES.length, `Tile has codec ${tile.codec}`);
  check(tile.bytesPerPixel === 3 || tile.bytesPerPixel === 4, `Tile has ${tile.bytesPerPixel} bytes per pixel`);
  check(tile.codec !== Codec.jpeg || tile.bytesPerPixel === 3, 'Tile is a JPEG with alpha');
  return tile;
}

/// One WebSocket message (an ArrayBuffer) as {type, …}: Frame and Tile with their fields, the others with `json`,
/// FrameEnd with `frame` too, Changed with `change`. Throws ProtocolError at whatever docs/protocol.md does not allow.
export function parseMessage(buffer) {
  check(buffer instanceof ArrayBuffer, 'message is not binary');
  check(buffer.byteLength >= HEADER_BYTES, `message of ${buffer.byteLength} bytes has no header`);
  const data = new DataView(buffer), bytes = new Uint8Array(buffer);
  check(bytes[0] === MAGIC, `magic is ${bytes[0]}`);
  check(bytes[1] === VERSION, `version is ${bytes[1]}, this page knows ${VERSION}`);
  check(bytes[3] === 0, `reserved byte is ${bytes[3]}`);
  const type = bytes[2], length = data.getUint32(4, true), limits = PAYLOAD_BYTES[type];
  check(limits !== undefined, `type 0x${type.toString(16)} is not for a viewer`);
  check(length === buffer.byteLength - HEADER_BYTES, `length is ${length}, the payload ${buffer.byteLength - HEADER_BYTES}`);
  check(length >= limits[0] && length <= limits[1], `type 0x${type.toString(16)} has a payload of ${length} bytes`);
  switch (type) {
    case Type.frame: return {type, ...parseFrame(data)};
    case Type.tile: return {type, ...parseTile(data, bytes)};
    case Type.frameEnd: {
      const frame = data.getUint32(HEADER_BYTES, true);
      return {type, frame, json: parseJson(bytes.subarray(HEADER_BYTES + FRAME_END_BYTES), 'FrameEnd')};
    }
    case Type.changed: return {type, change: data.getUint32(HEADER_BYTES, true)};
    default: return {type, json: parseJson(bytes.subarray(HEADER_BYTES), 'message')};
  }
}
