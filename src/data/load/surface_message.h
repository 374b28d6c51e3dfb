#pragma once

#include <span>
#include <vector>

#include "base/byte_message.h"
#include "base/uninitialized.h"
#include "data/load/agreement.h"
#include "data/loaded_surface.h"

namespace aeolic {

/// A surface as a message to other ranks, as it was read.
Bytes messageOf(const LoadedSurface& surface);

/// Throws std::runtime_error for a message that is malformed.
LoadedSurface surfaceOf(std::span<const std::byte> message);

/// Pieces that are not placed yet as one that is not, either. No arrays are lost. What only one piece can tell is that
/// of the first. `welds`: points of different pieces that lie at the same place become one, with the values of the
/// first. `pieces` is not empty.
LoadedSurface appendPieces(std::vector<LoadedSurface> pieces, bool welds = false);

/// Pieces that are not placed yet as one surface that is, about the centre of all its points. Its triangles come in the
/// order of their numbers (SurfaceMesh::order), its points as the triangles use them: the same whichever the pieces
/// were.
LoadedSurface joinPieces(std::vector<LoadedSurface> pieces, bool welds = false);

/// Collective. All of a surface of which each rank has read its share: StepReader::surface().
LoadedSurface shareSurface(LoadedSurface mine, Agreement& agreement);

/// Counts what a tally counts with that of the same thing, if there is one.
void addTally(std::vector<Tally>& all, const Tally& tally);

}  // namespace aeolic
