#pragma once

#include "base/extent.h"
#include "render/gbuffer.h"
#include "render/view.h"

namespace aeolic::cpu {

/// Local. Fills `buffer.links` over `compute`, where its rows may have any surface: which of a pixel's eight neighbours
/// lie on its own sheet of it, so that tracing and interpolation never cross a silhouette. Reads invDepth, gradients
/// and flow one pixel further.
///
/// 1/depth is linear in pixels on a plane, so each facet predicts its neighbour's value. Two pixels are linked where
/// one of the two predictions holds, or where the two facets' planes meet between the pixels: a crease, however sharp,
/// but not a silhouette. A fixed depth tolerance would fail at grazing angles (architecture: "sheets"). Pixels without
/// flow are linked to nothing.
void linkSheets(const View& view, const Extent& compute, GBuffer& buffer);

}  // namespace aeolic::cpu
