// Decodes lossless tiles off the page's thread, so that a large picture at rest never stalls the next drag.

import {crc32} from '../net/crc32.js';
import {lz4Decode, pixelsToRgba, unfilterRows} from './lz4.js';
import {pngDecode} from './png.js';
import {Codec} from '../net/protocol.js';

/// The tile's pixels as RGBA. Throws where the bytes are not what the tile's header says.
async function decoded({codec, width, rows, bytesPerPixel, crc, encoded}) {
  if (crc32(encoded) !== crc) throw new RangeError('tile has another checksum');
  switch (codec) {
    case Codec.raw: return pixelsToRgba(encoded, width, rows, bytesPerPixel);
    case Codec.lz4: {
      const filtered = lz4Decode(encoded, new Uint8Array(width * rows * bytesPerPixel));
      return unfilterRows(filtered, width, rows, bytesPerPixel);
    }
    case Codec.png: {
      const png = await pngDecode(encoded);
      if (png.width !== width || png.height !== rows || png.bytesPerPixel !== bytesPerPixel)
        throw new RangeError('PNG has another size than its tile');
      return pixelsToRgba(png.pixels, width, rows, bytesPerPixel);
    }
    default: throw new RangeError(`codec ${codec} is not for this page`);
  }
}

onmessage = async ({data: tile}) => {
  try {
    const rgba = await decoded(tile);
    postMessage({job: tile.job, rgba}, [rgba.buffer]);
  } catch (error) {
    postMessage({job: tile.job, error: error.message});
  }
};
