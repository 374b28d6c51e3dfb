#include "codecs/codecs.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "aeolic/error.h"
#include "aeolic/renderer.h"
#include "base/median.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "base/timing.h"

namespace aeolic {
namespace {

using stream::Codec;
using stream::Pixels;

/// One tile on its way. Its memory is kept from view to view, as in a server.
struct TileMemory {
    Pixels pixels;
    std::vector<std::uint8_t> encoded, decoded;
};

/// Measures one way of sending views: cut into tiles of so many rows.
class CodecMeasurement {
public:
    CodecMeasurement(const CodecsBenchRow& row, int repeats)
        : codec_(row.codec), quality_(row.quality), repeats_(repeats)
    {
    }

    /// `forEach(count, body)` calls body(0 … count - 1).
    template <class ForEach>
    void add(const Picture& view, int tileRows, const ForEach& forEach)
    {
        cut(view, tileRows);
        std::vector<double> encodeMs, decodeMs;
        for (int i = -1; i < repeats_; ++i) {  // The first time gets the memory.
            StopWatch watch;
            forEach(tiles_.size(), [&](std::size_t t) {
                tiles_[t].encoded.clear();
                stream::encode(codec_, tiles_[t].pixels, quality_, tiles_[t].encoded);
            });
            const double encoded = watch.lapMs();
            forEach(tiles_.size(), [&](std::size_t t) {
                const Pixels& pixels = tiles_[t].pixels;
                stream::decode(codec_, tiles_[t].encoded, pixels.width, pixels.rows, pixels.channels,
                               tiles_[t].decoded);
            });
            const double decoded = watch.lapMs();
            if (i < 0) continue;
            encodeMs.push_back(encoded);
            decodeMs.push_back(decoded);
        }
        cost_.encodeMs += median(encodeMs);
        cost_.decodeMs += median(decodeMs);
        for (const TileMemory& tile : tiles_) cost_.encodedBytes += std::int64_t(tile.encoded.size());
        compare();
    }

    const CodecCost& cost() const { return cost_; }
    double psnrDb() const { return squares_ > 0 ? 10 * std::log10(255.0 * 255.0 * double(bytes_) / squares_) : 0; }

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

    void compare()
    {
        for (const TileMemory& tile : tiles_) {
            bytes_ += tile.decoded.size();
            for (std::size_t i = 0; i < tile.decoded.size(); ++i) {
                const int difference = int(tile.decoded[i]) - int(tile.pixels.data[i]);
                squares_ += difference * difference;
            }
        }
        if (quality_ == 0 && squares_ > 0)
            throw std::runtime_error("codec " + std::string(codecName(codec_)) +
                                     ": pixels did not come back as they were");
    }

    Codec codec_;
    int quality_, repeats_;
    CodecCost cost_;
    std::vector<TileMemory> tiles_;
    std::size_t bytes_ = 0;
    double squares_ = 0;
};

/// Every codec of this build, with each quality asked for; nothing measured.
std::vector<CodecsBenchRow> everyCodec(const CodecsBenchPlan& plan, int channels)
{
    std::vector<CodecsBenchRow> rows;
    for (const Codec codec : {Codec::raw, Codec::lz4, Codec::lzo, Codec::png})
        if (available(codec)) rows.push_back({codec});
    if (channels == 3)
        for (const int quality : plan.qualities) rows.push_back({Codec::jpeg, quality});
    return rows;
}

void requireRoom(const OutputOptions& output, int channels)
{
    const std::size_t bytes = std::size_t(output.width) * std::size_t(output.height) * std::size_t(channels);
    if (bytes > stream::kLargestTileBytes)
        throw InputError("--size", "found " + std::to_string(output.width) + "x" + std::to_string(output.height),
                         "at most " + std::to_string(stream::kLargestTileBytes >> 20) + " MiB of pixels of " +
                             std::to_string(channels) + " bytes");
    requireMemory("--frames", std::to_string(output.frames) + " views", bytes * std::size_t(output.frames));
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

CodecsBench benchCodecs(const CodecsBenchPlan& plan, const Watch<CodecsBench>& watch)
{
    CodecsBench result;
    const OutputOptions& output = plan.scene.output;
    result.channels = plan.scene.shading.background == "transparent" ? 4 : 3;
    requireRoom(output, result.channels);
    Renderer renderer(withoutScalarBar(plan.scene), [&](const char* what, double) { watch.tell(what, 0); });
    result.backend = renderer.info().backend;
    result.device = renderer.info().device;
    result.threads = renderer.info().threads;
    result.warnings = renderer.info().warnings;
    std::vector<Picture> views;
    double covered = 0;
    for (int i = 0; i < output.frames; ++i) {
        watch.tell("drawing", 0);
        views.push_back(renderer.render({AnimationFrame{i}}));
        result.pixelBytes += std::int64_t(views.back().pixels.size());
        covered += double(renderer.lastFrame().coveredPixels);
    }
    result.coveredShare = covered * result.channels / double(result.pixelBytes);
    watch.show(result);

    tbb::task_arena arena(result.threads);
    const std::vector<CodecsBenchRow> codecs = everyCodec(plan, result.channels);
    const double steps = 2 * double(codecs.size()) * double(views.size());
    double done = 0;
    const auto measure = [&](const CodecsBenchRow& row, int tileRows, const auto& forEach) {
        CodecMeasurement measurement(row, plan.repeats);
        for (const Picture& view : views) {
            watch.tell(std::string(codecName(row.codec)), done++ / steps);
            arena.execute([&] { measurement.add(view, tileRows, forEach); });
        }
        return measurement;
    };
    for (const CodecsBenchRow& codec : codecs) {
        const auto bands =
            measure(codec, plan.bandRows, [](std::size_t count, const auto& body) { parallelFor(count, body); });
        CodecsBenchRow& row = result.rows.emplace_back(codec);
        row.bands = bands.cost();
        row.psnrDb = bands.psnrDb();
        watch.show(result);
    }
    for (CodecsBenchRow& row : result.rows) {
        row.whole = measure(row, output.height, [](std::size_t count, const auto& body) {
                        for (std::size_t i = 0; i < count; ++i) body(i);
                    }).cost();
        watch.show(result);
    }
    return result;
}

}  // namespace aeolic
