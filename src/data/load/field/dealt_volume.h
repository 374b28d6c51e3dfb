#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "data/cells/cell_volume.h"
#include "data/load/agreement.h"

namespace aeolic {

/// The cells of a volume, of which every rank has its own pieces.
struct DealtVolume {
    std::vector<std::shared_ptr<const CellVolume>> own;  ///< In the volume's order, by rank.
    bool everywhere = true;                              ///< Every rank has all of it.
    Bounds boundsWorld;                                  ///< Of all of it.
    double maxVector = 0;
    std::uint64_t cells = 0;  ///< How many there are in all.
    bool meansOfCells = false;
    std::string name;  ///< The file's, for messages.

    /// Local. With memory of its own.
    std::shared_ptr<const DealtVolume> copy() const;
};

/// Collective. Makes one volume of what the ranks have.
std::shared_ptr<const DealtVolume> dealtVolume(std::vector<std::shared_ptr<const CellVolume>> own, bool everywhere,
                                               const std::string& name, Agreement& agreement);

/// Collective. The cells near a surface, of all ranks: CellVolume::near(). `zone`: the same on all ranks, or, where
/// the surface is `inPieces`, each rank's own, and then every rank gets the cells near its piece.
CellVolume::Shell shellAround(const DealtVolume& volume, SurfaceZone zone, double diagonals, bool inPieces,
                              Agreement& agreement);

}  // namespace aeolic
