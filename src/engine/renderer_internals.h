#pragma once

#include <cstdint>
#include <memory>

#include "aeolic/renderer.h"

namespace aeolic {

struct ColorMap;
struct Scene;

/// What Aeolic's own programs need of a renderer, and its users do not. Everything is Local.
class RendererInternals {
public:
    /// The loaded scene, at the moment that was drawn last.
    static const Scene& scene(const Renderer& renderer);
    /// The colour map of the frames to come.
    static const ColorMap& colorMap(const Renderer& renderer);
    /// The ranks that draw.
    static const std::shared_ptr<Communicator>& ranks(const Renderer& renderer);
    /// How often setData(), setShown() and setTime() have shown other data.
    static std::uint64_t revision(const Renderer& renderer);
};

}  // namespace aeolic
