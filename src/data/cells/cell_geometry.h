#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <span>

#include "data/cells/volume_cells.h"
#include "data/cells/volume_sampler.h"

namespace aeolic {

using Corners = std::span<const std::uint32_t>;

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The mean of the corners' values, each as often as a face has it.
template <class Value, class Get>
Value cellMean(const VolumeCells& cells, std::size_t cell, const Get& get)
{
    Value sum(0);
    std::size_t count = 0;
    cells.forEachFace(cell, [&](Corners face) {
        for (const std::uint32_t id : face) sum += get(id);
        count += face.size();
    });
    return sum / double(count);
}

template <class Value, class Get>
Value faceMean(Corners face, const Get& get)
{
    Value sum(0);
    for (const std::uint32_t id : face) sum += get(id);
    return sum / double(face.size());
}

/// Whether the cell holds the point: `place` gets the tetrahedron that holds it best.
bool within(const VolumeCells& cells, std::uint32_t cell, const glm::dvec3& point, CellPlace& place);

/// The place on one face nearest to the point: all of CellPlace but the cell and the face. What is surely beyond
/// `farthest` is not looked at; where nothing else is there, the distance is infinite.
CellPlace nearestOnFace(const VolumeCells& cells, Corners face, const glm::dvec3& point, double farthest = kInfinity);

/// The place on the cell's faces nearest to the point. Faces that are surely beyond `farthest` are not looked at; where
/// all are, its distance is infinite.
CellPlace nearestOn(const VolumeCells& cells, std::uint32_t cell, const glm::dvec3& point, double farthest = kInfinity);

}  // namespace aeolic
