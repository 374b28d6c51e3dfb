#pragma once

#include "data/scene.h"

namespace aeolic {

/// What points of several surfaces carry for the projection stage, a small whole number: which kind of colours they
/// have, and whether streaks show. The G-buffer keeps the kind alone, by which a palette has its tables.
namespace surface_mark {

inline constexpr int kPlain = 0, kContext = 1;  ///< Kinds: a plain surface with streaks, and one without.
inline constexpr int kFirstColors = 2;          ///< The scene's colours, in their order, from here on.
inline constexpr int kMostKinds = 16;           ///< More than there are.
inline constexpr int kNoStreaks = kMostKinds;   ///< Is added where no streaks show.

static_assert(kFirstColors + int(SceneColors::kMost) <= kMostKinds);

inline int of(const SceneSurface& surface)
{
    const int withoutStreaks = surface.streaks ? 0 : kNoStreaks;
    if (surface.colors != SceneSurface::kPlain) return kFirstColors + surface.colors + withoutStreaks;
    return surface.streaks ? kPlain : kContext + withoutStreaks;
}

}  // namespace surface_mark

}  // namespace aeolic
