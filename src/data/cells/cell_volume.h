#pragma once

#include <memory>

#include "base/bounds.h"
#include "data/cells/left_out.h"
#include "data/cells/near_surface.h"
#include "data/cells/volume_cells.h"

namespace aeolic {

/// The cells of a volume, wherever they lie. Any number of threads may ask.
class CellVolume {
public:
    virtual ~CellVolume() = default;

    /// Some of a volume's cells.
    struct Shell {
        VolumeCells cells;  ///< In the volume's order, with their points alone.
        LeftOut leftOut;    ///< The others.
    };

    /// Those near a surface. A cell is near where its middle is no farther from a triangle than the triangle's reach
    /// and `diagonals` times the cell's own. With one diagonal these are all that a CellSampler can find at places
    /// within the surface's reach. Parallel. Cost: a pass over the cells.
    virtual Shell near(NearSurface& surface, double diagonals) const = 0;

    /// A copy of the volume that shares no memory with it.
    virtual std::shared_ptr<const CellVolume> copy() const = 0;

    virtual std::size_t count() const = 0;  ///< Of the cells.
    virtual Bounds bounds() const = 0;      ///< Of all cells, world coordinates; empty where there is none.
    virtual double maxVector() const = 0;   ///< The longest of all vectors.
    virtual bool meansOfCells() const = 0;  ///< The vectors were brought to the points from cells.
};

}  // namespace aeolic
