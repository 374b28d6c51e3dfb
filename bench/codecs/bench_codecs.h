#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "aeolic/scene_description.h"
#include "common/bench_progress.h"
#include "stream/codec.h"

namespace aeolic {

/// Views of one scene, encoded and decoded by every codec of this build.
struct CodecsBenchPlan {
    SceneDescription scene;  ///< Its frames are the views, its scalar bar is left out: a viewer draws its own.
    std::vector<int> qualities{50, 70, 80, 90, 95};  ///< Of jpeg, each 1 … 100.
    int bandRows = 64;  ///< Rows of a band, a multiple of 16, the rows that a JPEG block takes.
    int repeats = 5;    ///< Times each view is encoded and decoded.
};

/// What encoding and decoding all views took, in one of two ways.
struct CodecCost {
    std::int64_t encodedBytes = 0;
    double encodeMs = 0, decodeMs = 0;  ///< Sums over the views of the medians of the repeats, wall time.
};

struct CodecsBenchRow {
    stream::Codec codec;
    int quality = 0;    ///< 0: lossless, and seen to be so.
    CodecCost whole;    ///< Each view in one piece, on one thread.
    CodecCost bands;    ///< In bands of rows, spread over all threads, as a server does it.
    double psnrDb = 0;  ///< Of the bands, over all views and channels; of lossless codecs 0.
};

struct CodecsBench {
    std::string backend, device;
    int threads = 1;
    int channels = 3;                   ///< 4 on a transparent background: then without jpeg, which keeps no alpha.
    double coveredShare = 0;            ///< Of the views' pixels, what the surface covers: the rest is background.
    std::int64_t pixelBytes = 0;        ///< Of all views.
    std::vector<std::string> warnings;  ///< Of the scene, one line each.
    std::vector<CodecsBenchRow> rows;

    double mbPerS(double ms) const { return ms > 0 ? double(pixelBytes) * 1e-3 / ms : 0; }
};

/// Milliseconds from a drawn view to its decoded pixels over a line of `bitsPerS`, a view on average: encoded, then
/// sent, then decoded. A server overlaps the three, and lines have a latency: the one makes it less, the other more.
double msToViewer(const CodecCost& cost, int views, double bitsPerS);

/// Loads the scene and measures. Throws InputError for a scene that is not valid or cannot be loaded and for views
/// larger than a tile may be, std::runtime_error where a lossless codec loses something.
CodecsBench benchCodecs(const CodecsBenchPlan& plan, const BenchProgress& progress = {});

}  // namespace aeolic
