#include "data/mesh/triangle_order.h"

#include <algorithm>
#include <numeric>

namespace aeolic {

void takeTriangles(SurfaceMesh& mesh, const std::vector<std::uint32_t>& places)
{
    permute(mesh.triangles, places);
    permute(mesh.cellVectors, places);
    permute(mesh.cellScalars, places);
    permute(mesh.order, places);
}

std::vector<std::uint32_t> sortedByNumber(const SurfaceMesh& mesh)
{
    std::vector<std::uint32_t> places(mesh.order.size());
    std::iota(places.begin(), places.end(), 0u);
    std::stable_sort(places.begin(), places.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return mesh.order[a] < mesh.order[b]; });
    return places;
}

void sortTriangles(SurfaceMesh& mesh)
{
    if (!std::is_sorted(mesh.order.begin(), mesh.order.end())) takeTriangles(mesh, sortedByNumber(mesh));
}

}  // namespace aeolic
