#include "render/gl/device/gpu_state.h"

#include <algorithm>

#include "render/gl/device/draw_visibility.h"

namespace aeolic::gl {

void GpuState::draw(Programs& programs, const View& from, const Extent& area)
{
    const ViewBlock block = makeViewBlock(from, images.valid.y0, images.valid.height());
    view.write(0, sizeof block, &block);
    bindView();
    drawVisibility(programs, scene, from, images.target, area);
}

void GpuState::bindView() const
{
    glBindBufferBase(GL_UNIFORM_BUFFER, kViewBinding, view.id());
}

void GpuState::findLinks(Programs& programs, const View& from, const Extent& drawn, const Extent& neighbours)
{
    const int first = images.valid.y0;
    near.find(programs, images, neighbours.y0 - first, neighbours.y1 - first);
    linkSheets(programs, near, images, from.focalPx, drawn.y0 - first, drawn.y1 - first);
}

void GpuState::receiveFlow(Programs& programs, GuardExchange& guards, const Extent& compute, int sampled, int whole)
{
    const Extent& valid = images.valid;
    exchange.begin(guards, compute, valid, frames.drawn().timers);
    exchange.add({{&images.flow, 0}}, sampled);
    exchange.add({{&images.links, 0}}, whole);
    exchange.send();
    exchange.receive();
    const GuardRows guard = guards.rows(sampled);
    near.find(programs, images, std::max(compute.y0 - guard.above - valid.y0, 0),
              std::min(compute.y1 + guard.below, valid.y1) - valid.y0);
}

}  // namespace aeolic::gl
