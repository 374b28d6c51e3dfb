#include <algorithm>
#include <utility>

#include "aeolic/error.h"
#include "stream/gateway/hub/hub.h"

namespace aeolic::stream {
namespace {

constexpr double kMostMs = 60000;  // More is no time that a rank has taken.

}  // namespace

/// Each viewer has at most one pick at the job. Of those that wait the newest counts.
void Hub::onPick(Viewer& from, PickRequest pick)
{
    from.pick = std::move(pick);
    sendPick(from);
}

void Hub::sendPick(Viewer& of)
{
    if (!of.pick || of.picking || !jobRuns_ || state_ != State::ready || loading_) return;
    const PickRequest pick = *std::exchange(of.pick, std::nullopt);
    const ViewRequest& view = pick.view;
    ProbeRequest probe{of.id, view.view, pick.x, pick.y, {}};
    try {
        probe.scene = withView(scene_, fromHome(view, viewOfScene_), view.width, view.height);
    } catch (const InputError& error) {  // The view was made for another scene.
        return notify(of, "error", error.what());
    }
    of.picking = view.view;
    toJob_(jsonMessage(MessageType::probe, probeToJson(probe)));
}

void Hub::sendPicks()
{
    for (auto& [id, viewer] : viewers_) sendPick(viewer);
}

void Hub::onPicked(ByteView payload)
{
    Json picked = parseJson(payload);
    const auto asker = viewers_.find(picked.at("viewer").get<std::uint32_t>());
    if (asker == viewers_.end() || asker->second.picking != picked.at("view").get<std::uint32_t>()) return;
    Viewer& viewer = asker->second;
    viewer.picking.reset();
    if (const double tookMs = picked.at("tookMs").get<double>(); tookMs > 0)
        viewer.timeHad += std::min(tookMs, kMostMs);
    picked.erase("viewer");
    picked.erase("tookMs");
    viewer.port->send(jsonMessage(MessageType::picked, jsonText(picked)));
    sendPick(viewer);
}

/// The job could not tell.
void Hub::failPick(std::uint32_t id, const std::string& message)
{
    const auto asker = viewers_.find(id);
    if (asker == viewers_.end() || !asker->second.picking) return;
    asker->second.picking.reset();
    notify(asker->second, "error", message);
    sendPick(asker->second);
}

/// The job has gone, and what it was asked with it.
void Hub::forgetPicks()
{
    for (auto& [id, viewer] : viewers_) {
        viewer.pick.reset();
        viewer.picking.reset();
    }
}

}  // namespace aeolic::stream
