#pragma once

#include "data/scene.h"

/// What points of several surfaces carry for the projection stage, a small whole number: which kind of colours they
/// have, what of theirs is not the field's, and whether streaks show. The G-buffer keeps the kind alone, by which a
/// palette has its tables.
namespace aeolic::surface_mark {

inline constexpr int kPlain = 0, kContext = 1;  ///< Kinds: a plain surface with streaks, and one without.
inline constexpr int kFirstColors = 2;          ///< The scene's colours, in their order, from here on.
inline constexpr int kMostKinds = 16;           ///< More than there are.
inline constexpr int kOwnVectors = 16;          ///< Is added where the points have vectors of their own.
inline constexpr int kOwnScalar = 32;           ///< Is added where the points have a scalar of their own.
inline constexpr int kNoStreaks = 64;           ///< Is added where no streaks show: the highest of all.

static_assert(kFirstColors + int(SceneColors::kMost) <= kMostKinds && kMostKinds <= kOwnVectors);

inline int of(const SceneSurface& surface)
{
    const int more = (surface.ownVectors ? kOwnVectors : 0) + (surface.ownScalar ? kOwnScalar : 0) +
                     (surface.streaks ? 0 : kNoStreaks);
    if (surface.colors != SceneSurface::kPlain) return kFirstColors + surface.colors + more;
    return (surface.streaks ? kPlain : kContext) + more;
}

}  // namespace aeolic::surface_mark
