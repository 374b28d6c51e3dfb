#include "codecs/bench_codecs.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "aeolic/error.h"
#include "aeolic/renderer.h"
#include "base/median.h"
#include "base/parallel.h"
#include "base/timing.h"

namespace aeolic {
namespace {

using stream::Codec;
using stream::Pixels;

/// One tile on its way; memory is kept from view to view, as in a server.
struct TileMemory {
    Pixels pixels;
    std::vector<std::uint8_t> encoded, decoded;
};

/// A codec with one quality, over all views.
class CodecBench {
public:
    CodecBench(Codec codec, int quality, const CodecsBenchPlan& plan) : plan_(plan), row_{codec, quality, {}, {}, 0} {}

    void add(const Picture& view)
    {
        cut(view, view.height);
        measure(row_.whole, [](std::size_t count, const auto& body) {
            for (std::size_t i = 0; i < count; ++i) body(i);
        });
        cut(view, plan_.bandRows);
        measure(row_.bands, [](std::size_t count, const auto& body) { parallelFor(count, body); });
        compare();
    }

    CodecsBenchRow result() const
    {
        CodecsBenchRow row = row_;
        if (squares_ > 0) row.psnrDb = 10 * std::log10(255.0 * 255.0 * double(bytes_) / squares_);
        return row;
    }

private:
    void cut(const Picture& view, int rows)
    {
        const std::size_t rowBytes = std::size_t(view.width) * std::size_t(view.channels);
        tiles_.resize(std::size_t((view.height + rows - 1) / rows));
        int y = 0;
        for (TileMemory& tile : tiles_) {
            tile.pixels = {view.pixels.data() + std::size_t(y) * rowBytes, view.width, std::min(rows, view.height - y),
                           view.channels};
            y += rows;
        }
    }

    template <class ForEach>
    void measure(CodecCost& cost, const ForEach& forEach)
    {
        std::vector<double> encodeMs, decodeMs;
        for (int i = -1; i < plan_.repeats; ++i) {  // Once before, for memory to be there.
            StopWatch watch;
            forEach(tiles_.size(), [&](std::size_t t) {
                tiles_[t].encoded.clear();
                stream::encode(row_.codec, tiles_[t].pixels, row_.quality, tiles_[t].encoded);
            });
            const double encoded = watch.lapMs();
            forEach(tiles_.size(), [&](std::size_t t) {
                const Pixels& pixels = tiles_[t].pixels;
                stream::decode(row_.codec, tiles_[t].encoded, pixels.width, pixels.rows, pixels.channels,
                               tiles_[t].decoded);
            });
            const double decoded = watch.lapMs();
            if (i < 0) continue;
            encodeMs.push_back(encoded);
            decodeMs.push_back(decoded);
        }
        cost.encodeMs += median(encodeMs);
        cost.decodeMs += median(decodeMs);
        for (const TileMemory& tile : tiles_) cost.encodedBytes += std::int64_t(tile.encoded.size());
    }

    void compare()
    {
        for (const TileMemory& tile : tiles_) {
            bytes_ += tile.decoded.size();
            for (std::size_t i = 0; i < tile.decoded.size(); ++i) {
                const int difference = int(tile.decoded[i]) - int(tile.pixels.data[i]);
                squares_ += difference * difference;
            }
        }
        if (row_.quality == 0 && squares_ > 0)
            throw std::runtime_error("codec " + std::string(codecName(row_.codec)) +
                                     ": pixels did not come back as they were");
    }

    const CodecsBenchPlan& plan_;
    CodecsBenchRow row_;
    std::vector<TileMemory> tiles_;
    std::size_t bytes_ = 0;
    double squares_ = 0;
};

std::vector<CodecBench> everyCodec(const CodecsBenchPlan& plan, int channels)
{
    std::vector<CodecBench> codecs;
    for (const Codec codec : {Codec::raw, Codec::lz4, Codec::lzo, Codec::png})
        if (available(codec)) codecs.emplace_back(codec, 0, plan);
    if (channels == 3)
        for (const int quality : plan.qualities) codecs.emplace_back(Codec::jpeg, quality, plan);
    return codecs;
}

void requireTile(const OutputOptions& output, int channels)
{
    if (std::size_t(output.width) * std::size_t(output.height) * std::size_t(channels) > stream::kLargestTileBytes)
        throw InputError("--size", "found " + std::to_string(output.width) + "x" + std::to_string(output.height),
                         "at most " + std::to_string(stream::kLargestTileBytes >> 20) + " MiB of pixels of " +
                             std::to_string(channels) + " bytes");
}

SceneDescription withoutScalarBar(SceneDescription scene)
{
    scene.shading.scalarBar = false;
    return scene;
}

}  // namespace

double msToViewer(const CodecCost& cost, int views, double bitsPerS)
{
    return (cost.encodeMs + cost.decodeMs + double(cost.encodedBytes) * 8e3 / bitsPerS) / views;
}

CodecsBench benchCodecs(const CodecsBenchPlan& plan, const BenchProgress& progress)
{
    CodecsBench result;
    result.channels = plan.scene.shading.background == "transparent" ? 4 : 3;
    requireTile(plan.scene.output, result.channels);
    Renderer renderer(withoutScalarBar(plan.scene), [&](const char* what, double) {
        if (progress) progress(what, 0);
    });
    result.backend = renderer.info().backend;
    result.device = renderer.info().device;
    result.threads = renderer.info().threads;
    result.warnings = renderer.info().warnings;
    tbb::task_arena arena(result.threads);
    std::vector<CodecBench> codecs = everyCodec(plan, result.channels);
    const int views = plan.scene.output.frames;
    double covered = 0;
    for (int view = 0; view < views; ++view) {
        const Picture picture = renderer.renderFrame(view);
        result.pixelBytes += std::int64_t(picture.pixels.size());
        covered += double(renderer.lastFrame().coveredPixels);
        for (std::size_t i = 0; i < codecs.size(); ++i) {
            if (progress)
                progress("view " + std::to_string(view + 1) + " of " + std::to_string(views),
                         (view + double(i) / double(codecs.size())) / views);
            arena.execute([&] { codecs[i].add(picture); });
        }
    }
    result.coveredShare = covered * result.channels / double(result.pixelBytes);
    for (const CodecBench& codec : codecs) result.rows.push_back(codec.result());
    return result;
}

}  // namespace aeolic
