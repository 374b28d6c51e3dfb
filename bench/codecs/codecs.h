#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "aeolic/scene_description.h"
#include "common/measuring.h"
#include "stream/codec/codec.h"

namespace aeolic {

/// Views of one scene, encoded and decoded by every codec of this build.
struct CodecsBenchPlan {
    SceneDescription scene;  ///< Its frames are the views. The scalar bar is left out: a viewer draws its own.
    std::vector<int> qualities{50, 70, 80, 90, 95};  ///< For jpeg, each 1 to 100.
    int bandRows = 64;  ///< Rows of a band, a multiple of 16, the rows that a JPEG block takes.
    int repeats = 5;    ///< Times each view is encoded and decoded.
};

/// What it took to encode and decode all views, in one of two ways.
struct CodecCost {
    std::int64_t encodedBytes = 0;
    double encodeMs = 0, decodeMs = 0;  ///< Sums over the views of the medians of the repeats, wall time.
};

struct CodecsBenchRow {
    stream::Codec codec;
    int quality = 0;                      ///< 0: lossless, and seen to be so.
    CodecCost bands = {};                 ///< Each view in bands of rows, spread over all threads, as a server does it.
    double psnrDb = 0;                    ///< What the bands lost, over all views and channels; 0 for lossless codecs.
    std::optional<CodecCost> whole = {};  ///< Each view in one piece, on one thread. None before it is measured.
};

struct CodecsBench {
    std::string backend, device;
    int threads = 1;
    int channels = 3;                   ///< 4 on a transparent background; jpeg is then left out, as it keeps no alpha.
    double coveredShare = 0;            ///< How much of the views the surface covers; the rest is background.
    std::int64_t pixelBytes = 0;        ///< All views together.
    std::vector<std::string> warnings;  ///< About the scene, one line each.
    std::vector<CodecsBenchRow> rows;   ///< Every codec is measured in bands before the first one is in one piece.

    double mbPerS(double ms) const { return ms > 0 ? double(pixelBytes) * 1e-3 / ms : 0; }
};

/// Milliseconds from a drawn view to its decoded pixels over a line of `bitsPerS`, a view on average: encoded, then
/// sent, then decoded. Real times are shorter because a server overlaps the three, and longer by the line's latency.
double msToViewer(const CodecCost& cost, int views, double bitsPerS);

/// Loads the scene, draws all views, and measures. Throws InputError for a scene that is not valid or cannot be loaded,
/// for a view larger than a tile may be and for views that do not fit the memory, std::runtime_error where a lossless
/// codec loses something.
CodecsBench benchCodecs(const CodecsBenchPlan& plan, const Watch<CodecsBench>& watch = {});

}  // namespace aeolic
