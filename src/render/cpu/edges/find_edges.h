#pragma once

#include "render/edge_mask.h"
#include "render/gbuffer.h"
#include "render/view.h"

namespace aeolic::cpu {

/// The columns of row `y` in which an edge may lie: beside the surface in this row and the rows next to it. They begin
/// at a multiple of Image::kApron. The G-buffer's depth is right in these columns of the row.
ColumnSpan edgeColumns(const GBuffer& buffer, int y);

/// Local. The edges in the rows of `compute`: a pixel and one of its eight neighbours show two sheets of the surface
/// (links.h), or one of them background, or there is a crease in the light (antialias.h). Reads the G-buffer one row
/// further. `lighting`: whether light shows. Cost: 1 ns a pixel.
void findEdges(const View& view, const GBuffer& buffer, bool lighting, const Extent& compute, EdgeMask& out);

}  // namespace aeolic::cpu
