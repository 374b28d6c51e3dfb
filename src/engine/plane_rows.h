#pragma once

#include <optional>

#include "aeolic/plane.h"
#include "engine/plane_pixels.h"
#include "render/cpu/lic/fine_cells.h"
#include "render/gbuffer.h"

namespace aeolic {

/// Rows of a plane as the LIC stage reads a picture. Where the plane is periodic, pixels of its other end follow
/// beside it and below it.
class PlaneRows {
public:
    /// `reach`: how many pixels a value depends on in each direction. `flow` and `lic` stay as long as this does. Cost:
    /// one pass over the plane, which finds the longest vector and the texture's span.
    PlaneRows(const PlaneFlow& flow, const LicOptions& lic, int reach);

    /// The values of rows [y0, y1) of the plane depend on these rows, and on columns from -border() on.
    Extent extentFor(int y0, int y1) const;
    int border() const { return flow_.periodic ? reach_ : 0; }
    /// Fills `buffer.flow` and `buffer.links` of that extent, and `fine` where it is not null. The LIC stage reads
    /// nothing else. Rows before `fresh` stay: they are there, and in `fine`, too.
    void fill(const Extent& extent, int fresh, GBuffer& buffer, cpu::FineFlow* fine) const;

private:
    void findScales();
    void fillRow(int y, std::uint32_t* row, std::uint32_t* fineVectors, std::uint16_t* fineNoise) const;

    const PlaneFlow& flow_;
    const LicOptions& lic_;
    const int reach_;
    std::optional<PlaneGrains> grains_;         ///< Of oriented streaks.
    double longest_ = 0;                        ///< Vector; of all that are finite.
    float middle_ = 0, perUnit_ = 0;            ///< Of the texture: the value that becomes 0, and a factor.
    double flowUnitPx_ = 1, unitsPerStep_ = 0;  ///< A step is so many of the units that flow is kept in.
};

}  // namespace aeolic
