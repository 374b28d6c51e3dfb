#include "stream/job/job_frames.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <span>

#include "aeolic/error.h"
#include "base/parallel.h"
#include "base/timing.h"
#include "cluster/comm/hosts.h"
#include "cluster/comm/together.h"
#include "render/backend.h"
#include "stream/job/scene_report.h"

namespace aeolic::stream {
namespace {

// Rows of a band: whole MCUs of any JPEG, enough bands for all cores, and few enough that each compresses well.
constexpr int kBandRows = 64;

// A tile has a limit of bytes; a picture has none.
int bandRows(const Picture& rows)
{
    const std::size_t rowBytes = std::size_t(rows.width) * std::size_t(rows.channels);
    return int(std::clamp<std::size_t>((std::size_t{32} << 20) / rowBytes, 1, kBandRows));
}

WireMessage tileMessage(const DrawnFrame& picture, const DrawRequest& draw, int rank, int begin, int end)
{
    const std::size_t rowBytes = std::size_t(picture.width) * std::size_t(picture.channels);
    ByteVector bytes = beginMessage(MessageType::tile, kTileHeaderBytes + std::size_t(end - begin) * rowBytes / 4);
    TileHeader header{draw.frame,
                      std::uint32_t(picture.firstRow + begin),
                      std::uint32_t(end - begin),
                      std::uint32_t(picture.width),
                      std::uint16_t(rank),
                      std::uint8_t(draw.codec),
                      std::uint8_t(picture.channels),
                      0};
    putTileHeader(bytes, header);
    encode(draw.codec,
           {picture.pixels.data() + std::size_t(begin) * rowBytes, picture.width, end - begin, picture.channels},
           draw.quality, bytes);
    const std::uint32_t crc = crc32(ByteView(bytes).subspan(kHeaderBytes + kTileHeaderBytes));
    for (std::size_t i = 0; i < 4; ++i) bytes[kHeaderBytes + kTileHeaderBytes - 4 + i] = std::uint8_t(crc >> (8 * i));
    return endMessage(std::move(bytes));
}

/// Local. Encodes a rank's finished rows in bands, on all threads of the current arena. Each band is handed to `send`
/// as a Tile message as soon as it is ready, in any order; several threads may call `send` at once. Returns the bytes
/// of all messages together.
std::size_t sendStripe(const DrawnFrame& stripe, const DrawRequest& draw, int rank,
                       const std::function<void(WireMessage)>& send)
{
    const int rows = stripe.height;
    if (rows == 0) return 0;
    const int band = bandRows(stripe);
    std::atomic<std::size_t> bytes{0};
    parallelFor(std::size_t((rows + band - 1) / band), [&](std::size_t i) {
        const int begin = int(i) * band;
        WireMessage message = tileMessage(stripe, draw, rank, begin, std::min(begin + band, rows));
        bytes += message->size();
        send(std::move(message));
    });
    return bytes;
}

}  // namespace

void show(const SceneDescription& asked, Renderer& renderer)
{
    const auto switches = [](const SceneDescription& scene) {
        std::vector<bool> shown;
        for (const SurfaceItem& item : scene.surfaces) shown.push_back(item.shown);
        return shown;
    };
    const std::vector<bool> shown = switches(asked);
    if (shown != switches(renderer.description())) renderer.setShown(shown);
    const std::optional<double> moment = asked.time.moment;
    if (moment && moment != renderer.info().time) renderer.setTime(*moment);
}

Json aboutThisRank(const Communicator& ranks, const TileServer* tiles)
{
    return {{"rank", ranks.rank()},
            {"ranks", ranks.size()},
            {"host", placeOfThisProcess().host},
            {"pid", getpid()},
            {"direct", tiles ? Json(tiles->port()) : Json()}};
}

GatewayAddress addressForAll(Communicator& ranks, const std::string& line)
{
    const auto text = std::as_bytes(std::span(line));
    Bytes bytes(text.begin(), text.end());
    ranks.broadcast(bytes);
    return addressFromJson({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

JobFrames::JobFrames(std::shared_ptr<Communicator> ranks, JobLink& link, TileServer* tiles)
    : ranks_(std::move(ranks)), link_(link), tiles_(tiles)
{
}

void JobFrames::say(MessageType type, const Json& json)
{
    if (ranks_->isRoot()) link_.send(jsonMessage(type, jsonText(json)));
}

void JobFrames::complain(const std::string& message, const char* what, const Json& number)
{
    constexpr std::size_t most = 4096;  // Bytes; names in a message may be long.
    say(MessageType::notice, {{"level", "error"}, {"message", message.substr(0, most)}, {what, number}});
}

void JobFrames::report(Json report, const Json& load)
{
    if (!load.is_null()) report["load"] = load;
    // The gateway adds the surface, which a viewer has named in one message.
    constexpr std::size_t room = 64 << 10;
    const std::size_t bytes = jsonText(report).size() + room;
    const std::size_t most = payloadLimit(std::uint8_t(MessageType::scene), Sender::rank);
    if (bytes > most)
        return complain(InputError("scene", "found " + std::to_string(bytes >> 10) + " KiB of times, arrays and names",
                                   "at most " + std::to_string(most >> 10) + " KiB, for viewers to choose from")
                            .what(),
                        "load", load);
    say(MessageType::scene, report);
}

void JobFrames::tryOrTell(const char* what, const Json& number, const std::function<void()>& action)
{
    try {
        action();
    } catch (const DeviceError&) {
        throw;
    } catch (const std::exception& error) {
        const bool everywhere = ranks_->size() == 1 || dynamic_cast<const Agreed*>(&error);
        if (!everywhere) throw;
        complain(error.what(), what, number);
    }
}

void JobFrames::start(Renderer* renderer, const DrawRequest& request)
{
    tryOrTell("frame", request.frame, [&] {
        if (!renderer) throw InputError("no scene is loaded");
        renderer->setLic(request.scene.lic);
        renderer->setShading(request.scene.shading);
        const OutputOptions& size = request.scene.output;
        renderer->setSize(size.width, size.height);
        renderer->start({request.scene.camera, false});
        const SceneInfo& info = renderer->info();
        started_.push_back({request, {info.warnings.begin() + std::ptrdiff_t(info.dataWarnings), info.warnings.end()}});
    });
}

void JobFrames::probe(Renderer* renderer, const ProbeRequest& request)
{
    tryOrTell("pick", request.viewer, [&] {
        if (!renderer) throw InputError("no scene is loaded");
        StopWatch watch;
        const OutputOptions& size = request.scene.output;
        renderer->setSize(size.width, size.height);
        const auto place = renderer->pick(request.x, request.y, request.scene.camera);
        say(MessageType::picked, {{"viewer", request.viewer},
                                  {"view", request.view},
                                  {"tookMs", watch.lapMs()},
                                  {"place", place ? placeReport(*place) : Json()}});
    });
}

void JobFrames::finish(Renderer& renderer)
{
    const Started frame = std::move(started_.front());
    const DrawRequest& request = frame.request;
    started_.pop_front();
    tryOrTell("frame", request.frame, [&] {
        stripe_ = renderer.finish(std::move(stripe_));
        StopWatch watch;
        const std::size_t bytes =
            sendStripe(stripe_, request, ranks_->rank(), [&](const WireMessage& tile) { sendTile(request, tile); });
        sayFrameEnd(renderer, frame, watch.lapMs(), bytes);
    });
}

/// Sends a tile to the viewer itself, and tells the gateway which rows went; or sends it through the gateway.
void JobFrames::sendTile(const DrawRequest& request, const WireMessage& tile)
{
    if (!request.direct || !tiles_ || !tiles_->send(request.viewer, tile)) return link_.send(tile);
    ByteVector sent = beginMessage(MessageType::tile, kTileHeaderBytes);
    sent.insert(sent.end(), tile->begin() + kHeaderBytes, tile->begin() + kHeaderBytes + kTileHeaderBytes);
    link_.send(endMessage(std::move(sent)));
}

void JobFrames::sayFrameEnd(const Renderer& renderer, const Started& frame, double encodeMs, std::size_t bytes)
{
    if (!ranks_->isRoot()) return;
    const FrameStats& stats = renderer.lastFrame();
    Json ranks = Json::array();
    for (const RankStats& rank : stats.ranks)
        ranks.push_back(
            {{"rank", rank.rank}, {"firstRow", rank.firstRow}, {"rows", rank.rows}, {"busyMs", rank.busyMs}});
    const Json end{{"totalMs", stats.totalMs},
                   {"stagesMs",
                    {{"balance", stats.balanceMs},
                     {"project", stats.projectMs},
                     {"composite", stats.compositeMs},
                     {"convolve", stats.convolveMs},
                     {"shade", stats.shadeMs}}},
                   {"encodeMs", encodeMs},
                   {"bytes", bytes},
                   {"warnings", frame.warnings},
                   {"ranks", ranks},
                   {"legend", stripe_.legend ? Json(*stripe_.legend) : Json()}};
    link_.send(frameEndMessage(frame.request.frame, jsonText(end)));
}

}  // namespace aeolic::stream
