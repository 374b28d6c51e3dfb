// A few pictures of the cycle of streaks that flow, and what lies between them. A pixel's value goes through its cycle as a
// constant, a cosine and a sine do, and light and colours bend that a little. So between the pictures goes the
// trigonometric polynomial through them, and the last one leads on to the first.

const TILE_PX = 16;
const SAME = 2;  // Of 255. Nobody sees a smaller difference, and packed pictures have such where nothing flows.

/// What each of `count` pictures, evenly spread over the cycle, counts at a phase in turns. They add up to 1.
export function cycleWeights(turns, count) {
  const half = count / 2, weights = [];
  for (let i = 0; i < count; ++i) {
    const angle = 2 * Math.PI * (turns - i / count);
    let sum = 1;
    for (let wave = 1; wave < half; ++wave) sum += 2 * Math.cos(wave * angle);
    if (Number.isInteger(half)) sum += Math.cos(half * angle);
    weights.push(sum / count);
  }
  return weights;
}

/// The tiles in which the pictures differ, as boxes [x0, y0, x1, y1] of pixels; neighbours in a row are one box. Pictures:
/// ImageData of one size.
export function flowingBoxes(pictures) {
  const {width, height} = pictures[0], columns = Math.ceil(width / TILE_PX), boxes = [];
  const words = pictures.map(({data}) => new Uint32Array(data.buffer, data.byteOffset, data.byteLength / 4));
  const differs = (at) => {
    const first = words[0][at];
    for (let i = 1; i < words.length; ++i) {
      const other = words[i][at];
      if (other === first) continue;
      for (let shift = 0; shift < 32; shift += 8) if (Math.abs((other >>> shift & 255) - (first >>> shift & 255)) > SAME) return true;
    }
    return false;
  };
  for (let y0 = 0; y0 < height; y0 += TILE_PX) {
    const y1 = Math.min(y0 + TILE_PX, height);
    let open = null;
    for (let column = 0; column < columns; ++column) {
      const x0 = column * TILE_PX, x1 = Math.min(x0 + TILE_PX, width);
      let flows = false;
      for (let y = y0; y < y1 && !flows; ++y) for (let x = x0; x < x1 && !flows; ++x) flows = differs(y * width + x);
      if (flows && open) open[2] = x1;
      else if (flows) boxes.push(open = [x0, y0, x1, y1]);
      else open = null;
    }
  }
  return boxes;
}

/// What holds all boxes.
export const around = (boxes) => boxes.length === 0 ? [0, 0, 1, 1] : [0, 1, 2, 3].map((i) => (i < 2 ? Math.min : Math.max)(...boxes.map((box) => box[i])));
