#pragma once

#include <memory>
#include <vector>

#include "render/gl/frame_images.h"
#include "render/gl/stage_timers.h"
#include "render/guard_exchange.h"

namespace aeolic::gl {

/// The way of guard rows between GPUs: off this one, through the ranks' exchange, onto it. Only the rows that others
/// read, and that are read here, move.
class GuardRowExchange {
public:
    /// `compute`: this rank's stripe.
    void begin(GuardExchange& guards, const Extent& compute, StageTimers& timers);

    /// Collective. Fills the rows around the stripe that traces of `reach` may read.
    void receiveFlow(const FrameImages& images, const TraceReach& reach);
    void receiveLinks(const FrameImages& images, const TraceReach& reach);
    /// Both directions of a level of jumps, in their layers.
    void receiveLevel(const FrameImages& images, int level, bool withWaves, const TraceReach& reach);

    const GuardExchange& guards() const { return *guards_; }

private:
    /// One texture's layer and its rows in this process's memory.
    struct Plane {
        const Texture* texture;
        int layer;
    };
    void receive(const Extent& valid, const std::vector<Plane>& planes, const TraceReach& reach);

    GuardExchange* guards_ = nullptr;
    StageTimers* timers_ = nullptr;  // Stopped while others are waited for.
    Extent compute_;
    std::vector<std::unique_ptr<Image<std::uint32_t>>> words_;
    Image<std::uint8_t> bytes_;
};

}  // namespace aeolic::gl
