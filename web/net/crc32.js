// CRC-32 as zlib and PNG compute it (reflected 0xEDB88320).

const tables = (() => {
  const all = Array.from({length: 4}, () => new Uint32Array(256));
  for (let i = 0; i < 256; ++i) {
    let value = i;
    for (let bit = 0; bit < 8; ++bit) value = value & 1 ? 0xedb88320 ^ (value >>> 1) : value >>> 1;
    all[0][i] = value;
  }
  // Takes four bytes in a step: table k holds what a byte does k bytes later.
  for (let k = 1; k < 4; ++k)
    for (let i = 0; i < 256; ++i) all[k][i] = all[0][all[k - 1][i] & 255] ^ (all[k - 1][i] >>> 8);
  return all;
})();

/// The checksum of `bytes`. `before` is the checksum of the bytes before them.
export function crc32(bytes, before = 0) {
  const [t0, t1, t2, t3] = tables;
  const end = bytes.length, blocks = end - (end & 3);
  let crc = ~before, i = 0;
  for (; i < blocks; i += 4) {
    crc ^= bytes[i] | (bytes[i + 1] << 8) | (bytes[i + 2] << 16) | (bytes[i + 3] << 24);
    crc = t3[crc & 255] ^ t2[(crc >>> 8) & 255] ^ t1[(crc >>> 16) & 255] ^ t0[crc >>> 24];
  }
  for (; i < end; ++i) crc = t0[(crc ^ bytes[i]) & 255] ^ (crc >>> 8);
  return ~crc >>> 0;
}
