#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aeolic/error.h"
#include "render/overlay/text_size.h"
#include "stream/gateway/hub/hub.h"

namespace aeolic::stream {
namespace {

// A viewer may have two frames waiting and one being drawn, and its last one is kept.
constexpr std::uint64_t kMostOfOne = 4;
constexpr int kLongOne = 4;  // Of the limit for drawing, one picture may be expected to take this part.
constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 28;  // A frame of 16384 x 16384 takes 1 GiB on its way.

}  // namespace

/// Whether a viewer and all its followers can decode such tiles. At rest they all get the same tiles.
bool Hub::allCan(const Viewer& of, Codec codec) const
{
    return std::all_of(viewers_.begin(), viewers_.end(), [&](const auto& entry) {
        const Viewer& viewer = entry.second;
        return (viewer.id != of.id && viewer.following != of.id) || viewer.can(codec);
    });
}

/// Starts as many frames as the job draws at once: a GPU draws one while the frame before is packed and sent.
void Hub::drawNext()
{
    if (!jobRuns_ || state_ != State::ready || loading_) return;
    while (!loading_ && drawing_.size() < framesInFlight_ && takeTurn()) {
    }
}

/// Sends a viewer's wanted view to the job. False where it cannot be drawn.
bool Hub::draw(Viewer& of)
{
    const ViewRequest view = std::move(*of.wanted);
    of.wanted.reset();
    const std::uint32_t againFor = std::exchange(of.againFor, 0);
    const bool isMoving = view.moving || sceneMoves();
    DrawRequest request;
    try {
        request = drawRequest(of, view, isMoving);
    } catch (const InputError& error) {  // The view was made for another scene.
        notify(of, "error", error.what());
        return false;
    }
    const SteadyClock::time_point until = waitsUntil(of, request.scene);
    of.heldBack = now_() < until;
    if (of.heldBack) {
        tellOfWait(of, until);
        of.wanted = view;
        return false;
    }
    request.frame = ++lastFrame_;
    const OutputOptions& size = request.scene.output;
    Drawing& drawing = drawing_.emplace_back();
    drawing.viewer = of.id;
    drawing.picture = std::make_shared<StoredFrame>();
    drawing.picture->moving = isMoving;
    drawing.picture->codec = request.codec;
    drawing.picture->header = {request.frame,
                               of.id,
                               view.view,
                               std::uint32_t(size.width),
                               std::uint32_t(size.height),
                               std::uint32_t(view.width),
                               !isMoving};
    drawing.rowsHere.assign(std::size_t(size.height), false);
    drawing.rowsMissing = std::uint32_t(size.height);
    drawing.start = now_();
    drawing.paidBy = againFor;
    drawing.scene = request.scene;
    for (auto& [id, viewer] : viewers_)
        if ((id == of.id || viewer.following == of.id) && viewer.can(request.codec) && mayGetAnother(viewer)) {
            drawing.recipients.insert(id);
            tellScene(viewer);
            viewer.unshown.push_back(request.frame);
        }
    of.last = view;
    of.restIsDue = isMoving && !view.moving;
    request.direct = of.hello.direct && !direct_.empty() && drawing.recipients == std::set{of.id};
    if (request.direct) {  // The ranks' tiles may arrive before anything that comes through the gateway.
        of.port->send(frameMessage(drawing.picture->header));
        drawing.begun = true;
    }
    toJob_(jsonMessage(MessageType::draw, drawToJson(request)));
    return true;
}

DrawRequest Hub::drawRequest(const Viewer& of, const ViewRequest& view, bool isMoving) const
{
    const double scale = isMoving ? of.pace.scale() : 1.0;
    const auto scaled = [&](int side) { return std::max(1, int(std::lround(side * scale))); };
    DrawRequest request;
    request.viewer = of.id;
    request.view = view.view;
    request.askedWidth = std::uint32_t(view.width);
    request.scene = withView(scene_, fromHome(view, viewOfScene_), scaled(view.width), scaled(view.height));
    LicOptions& lic = request.scene.lic;
    if (isMoving && lic.flow == FlowMotion::loop) {  // A cycle takes the work of three or four.
        lic.flow = FlowMotion::off;
        lic.kernel = Kernel::hann;
    }
    // Steps are lengths in pixels: in a smaller picture shorter ones give streaks as long as in the full one.
    lic.steps = std::max(1, int(std::lround(lic.steps * scale)));
    ShadingOptions& shading = request.scene.shading;
    shading.textScale = textScaleOfSmaller(shading.textScale, request.scene.output.width, request.scene.output.height,
                                           view.width, view.height);
    request.quality = of.pace.quality();
    request.codec = of.pace.lossless(allCan(of, Codec::lz4));
    if (std::uint64_t(request.scene.output.width) * std::uint64_t(request.scene.output.height) > kMostPixels)
        throw InputError("view", fmt::format("found {} x {} pixels", view.width, view.height),
                         fmt::format("at most {} million pixels", kMostPixels / 1'000'000));
    const std::uint64_t bytes = 4 * std::uint64_t(view.width) * std::uint64_t(view.height);
    if (bytes > options_.frameBytes / kMostOfOne)
        throw InputError("view", fmt::format("found {} x {} pixels", view.width, view.height),
                         fmt::format("at most {} million pixels, for which there is room (--viewer-memory)",
                                     options_.frameBytes / kMostOfOne / 4'000'000));
    if (samplesOf(request.scene) > options_.mostSamples)
        throw InputError("view: lic.steps",
                         fmt::format("{} steps for {} x {} pixels are more work than this server gives one picture",
                                     request.scene.lic.steps, request.scene.output.width, request.scene.output.height),
                         "fewer steps, a smaller picture or the hierarchical method");
    const auto expected = std::chrono::ceil<std::chrono::seconds>(expectedTime(request.scene));
    if (expected > options_.drawLimit / kLongOne)
        throw InputError("view: lic.steps",
                         fmt::format("{} steps for {} x {} pixels would take about {} s", request.scene.lic.steps,
                                     request.scene.output.width, request.scene.output.height, expected.count()),
                         fmt::format("at most {} s: fewer steps, a smaller picture or the hierarchical method",
                                     (options_.drawLimit / kLongOne).count()));
    if (!isMoving) {
        if (options_.codec && *options_.codec != Codec::jpeg && allCan(of, *options_.codec))
            request.codec = *options_.codec;
        return request;
    }
    const Codec moving = options_.codec.value_or(Codec::jpeg);
    const bool opaque = request.scene.shading.background != "transparent";
    // A follower that cannot decode it waits for the picture at rest. It must not make the one it follows slow.
    if (of.can(moving) && (moving != Codec::jpeg || opaque)) request.codec = moving;
    return request;
}

Drawing* Hub::drawingOf(std::uint32_t frame)
{
    for (Drawing& drawing : drawing_)
        if (drawing.picture->header.frame == frame) return &drawing;
    return nullptr;
}

void Hub::onTile(const WireMessage& message, ByteView payload)
{
    ByteView encoded;
    const TileHeader tile = parseTile(payload, encoded);
    Drawing* drawing = drawingOf(tile.frame);
    if (!drawing) return;  // It belongs to a frame that was given up.
    StoredFrame& picture = *drawing->picture;
    if (tile.width != picture.header.width || tile.firstRow + tile.rows > picture.header.height)
        throw ProtocolError("a tile beyond its frame");
    for (std::uint32_t row = tile.firstRow; row < tile.firstRow + tile.rows; ++row) {
        if (drawing->rowsHere[row]) throw ProtocolError("tiles that overlap");
        drawing->rowsHere[row] = true;
    }
    drawing->rowsMissing -= tile.rows;
    const bool wentDirect = encoded.empty();
    if (wentDirect) {
        picture.incomplete = true;
        return finishIfWhole(*drawing);
    }
    const WireMessage kept = counted(message);
    for (const std::uint32_t id : drawing->recipients) {
        if (!drawing->begun) viewer(id).port->send(frameMessage(picture.header));
        viewer(id).port->send(kept);
    }
    drawing->begun = true;
    picture.bytes += encoded.size();
    picture.tiles.push_back(kept);
    if (frameBytes() > options_.frameBytes) saveMemory();
    finishIfWhole(*drawing);
}

void Hub::onFrameEnd(const WireMessage& message, ByteView payload)
{
    Drawing* drawing = drawingOf(WireReader(payload).u32());
    if (!drawing) return;
    drawing->picture->end = message;
    const Json stats = parseJson(payload.subspan(4));
    if (stats.contains("stagesMs")) learnSpeed(drawing->scene, stats["stagesMs"].value("convolve", 0.0));
    finishIfWhole(*drawing);
}

/// Rank 0's end may come before the last tile of another rank.
void Hub::finishIfWhole(Drawing& drawing)
{
    if (!drawing.picture->end || drawing.rowsMissing > 0) return;
    const std::shared_ptr<StoredFrame> picture = drawing.picture;
    picture->sent = now_();
    // The time that it shared with the frame before counts for that frame.
    picture->drawMs =
        std::chrono::duration<double, std::milli>(picture->sent - std::max(drawing.start, lastSent_)).count();
    lastSent_ = picture->sent;
    for (const std::uint32_t id : drawing.recipients) {
        viewer(id).port->send(picture->end);
        viewer(id).picture = picture;
    }
    if (drawing.paidBy != 0) chargeChange(drawing.paidBy, now_() - drawing.start);
    const std::uint32_t owner = drawing.viewer;
    if (const auto of = viewers_.find(owner); of != viewers_.end()) {
        of->second.picture = picture;
        of->second.endedJobs = 0;
        charge(of->second, picture->drawMs, samplesOf(drawing.scene), drawing.paidBy != 0);
        if (drawing.paidBy == 0) chargeOwnPicture(of->second, now_() - drawing.start);
    }
    ++framesDrawn_;
    drewSinceStart_ = true;
    std::erase_if(drawing_, [&](const Drawing& d) { return d.picture == picture; });
    drawNext();
    for (auto& [id, viewer] : viewers_)
        if (viewer.following == owner) catchUp(viewer);  // It may have begun to follow while the frame was drawn.
}

/// The same bytes, which count as long as anybody holds them.
WireMessage Hub::counted(const WireMessage& tile) const
{
    *frameBytes_ += tile->size();
    return {tile.get(), [tile, all = frameBytes_](const ByteVector*) { *all -= tile->size(); }};
}

/// The pictures take more memory than they may. Those kept for followers go first: they can be drawn again. Then the
/// viewers go that have been reading at one frame for longest, until it is enough.
void Hub::saveMemory()
{
    for (auto& [id, viewer] : viewers_)
        if (viewer.picture) {
            viewer.picture->tiles.clear();
            viewer.picture->incomplete = true;
        }
    while (frameBytes() > options_.frameBytes) {
        Viewer* slowest = nullptr;
        for (auto& [id, viewer] : viewers_) {
            const auto oldest = viewer.port->isOpen() ? viewer.port->oldestQueued() : std::nullopt;
            if (oldest && (!slowest || *oldest < *slowest->port->oldestQueued())) slowest = &viewer;
        }
        if (!slowest) return;
        slowest->port->close(Goodbye::policyError, "too slow");
    }
}

/// Forgets a frame that will not be finished.
void Hub::drop(Drawing& drawing)
{
    const std::uint32_t frame = drawing.picture->header.frame;
    for (const std::uint32_t id : drawing.recipients) std::erase(viewer(id).unshown, frame);
    std::erase_if(drawing_, [&](const Drawing& d) { return d.picture->header.frame == frame; });
}

void Hub::dropDrawing()
{
    while (!drawing_.empty()) drop(drawing_.front());
}

}  // namespace aeolic::stream
