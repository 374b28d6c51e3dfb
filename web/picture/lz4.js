// LZ4 blocks (the block format, without a frame around it) and the row filter of docs/protocol.md.

/// Decodes `source` into `target`, which must come out exactly full. Throws RangeError where the block is not sound;
/// never reads or writes outside the two.
export function lz4Decode(source, target) {
  const sourceEnd = source.length, targetEnd = target.length;
  let from = 0, to = 0;

  const longer = (length) => {
    for (let byte = 255; byte === 255;) {
      if (from >= sourceEnd) throw new RangeError('LZ4 block ends within a length');
      byte = source[from++];
      length += byte;
    }
    return length;
  };

  while (from < sourceEnd) {
    const token = source[from++];
    let literals = token >>> 4;
    if (literals === 15) literals = longer(literals);
    if (from + literals > sourceEnd) throw new RangeError('LZ4 block ends within literals');
    if (to + literals > targetEnd) throw new RangeError('LZ4 block is longer than its tile');
    if (literals > 32) {
      target.set(source.subarray(from, from + literals), to);
      from += literals;
      to += literals;
    } else {
      for (const stop = from + literals; from < stop;) target[to++] = source[from++];
    }
    if (from === sourceEnd) break;  // The last sequence has no match.

    if (from + 2 > sourceEnd) throw new RangeError('LZ4 block ends within an offset');
    const offset = source[from] | (source[from + 1] << 8);
    from += 2;
    if (offset === 0 || offset > to) throw new RangeError('LZ4 block refers to bytes before its start');
    let match = token & 15;
    if (match === 15) match = longer(match);
    match += 4;
    if (to + match > targetEnd) throw new RangeError('LZ4 block is longer than its tile');
    if (offset === 1) {
      target.fill(target[to - 1], to, to + match);
      to += match;
    } else if (offset >= match && match > 32) {
      target.copyWithin(to, to - offset, to - offset + match);
      to += match;
    } else {
      for (const stop = to + match; to < stop; ++to) target[to] = target[to - offset];
    }
  }
  if (to !== targetEnd) throw new RangeError(`LZ4 block has ${to} bytes, its tile ${targetEnd}`);
  return target;
}

/// Filtered rows to RGBA, opaque if there is no alpha. A row has four planes: its greens, its reds less the greens, its
/// blues less the greens and its alphas; in a plane each byte is the difference from the byte before.
export function unfilterRows(filtered, width, rows, bytesPerPixel) {
  checkSize(filtered, width, rows, bytesPerPixel);
  const rgba = new Uint8ClampedArray(width * rows * 4), hasAlpha = bytesPerPixel === 4;
  for (let row = 0, to = 0; row < rows; ++row) {
    const green = row * width * bytesPerPixel, red = green + width, blue = red + width, alpha = blue + width;
    let r = 0, g = 0, b = 0, a = 0;
    for (let x = 0; x < width; ++x, to += 4) {
      g += filtered[green + x];
      r += filtered[red + x];
      b += filtered[blue + x];
      if (hasAlpha) a += filtered[alpha + x];
      rgba[to] = (r + g) & 255;
      rgba[to + 1] = g & 255;
      rgba[to + 2] = (b + g) & 255;
      rgba[to + 3] = hasAlpha ? a & 255 : 255;
    }
  }
  return rgba;
}

/// Plain rows of RGB or RGBA to RGBA.
export function pixelsToRgba(pixels, width, rows, bytesPerPixel) {
  checkSize(pixels, width, rows, bytesPerPixel);
  const rgba = new Uint8ClampedArray(width * rows * 4);
  if (bytesPerPixel === 4) {
    rgba.set(pixels);
    return rgba;
  }
  for (let from = 0, to = 0; to < rgba.length; from += 3, to += 4) {
    rgba[to] = pixels[from];
    rgba[to + 1] = pixels[from + 1];
    rgba[to + 2] = pixels[from + 2];
    rgba[to + 3] = 255;
  }
  return rgba;
}

function checkSize(bytes, width, rows, bytesPerPixel) {
  if (bytes.length !== width * rows * bytesPerPixel) throw new RangeError('rows have another size than their tile');
}
