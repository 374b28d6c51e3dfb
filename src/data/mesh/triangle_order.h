#pragma once

#include <cstdint>
#include <vector>

#include "data/mesh/surface_mesh.h"

namespace aeolic {

/// values[i] becomes values[places[i]]; no value, where there is none.
template <class Value>
void permute(std::vector<Value>& values, const std::vector<std::uint32_t>& places)
{
    if (values.empty()) return;
    std::vector<Value> sorted;
    sorted.reserve(places.size());
    for (const std::uint32_t place : places) sorted.push_back(values[place]);
    values.swap(sorted);
}

/// Sorts the triangles by their numbers (SurfaceMesh::order), with all that belongs to them. Those of the same number
/// stay in their order.
void sortTriangles(SurfaceMesh& mesh);

/// How sortTriangles() sorts: the places of the triangles before.
std::vector<std::uint32_t> sortedByNumber(const SurfaceMesh& mesh);

/// Takes these triangles, in this order, with all that belongs to them; points stay.
void takeTriangles(SurfaceMesh& mesh, const std::vector<std::uint32_t>& places);

}  // namespace aeolic
