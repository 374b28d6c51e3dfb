#include "data/mesh/triangle_order.h"

#include <algorithm>
#include <numeric>

namespace aeolic {
namespace {

void takeTriangles(SurfaceMesh& mesh, const std::vector<std::uint32_t>& places)
{
    permute(mesh.triangles, places);
    permute(mesh.cellVectors, places);
    permute(mesh.cellScalars, places);
    permute(mesh.order, places);
}

}  // namespace

void sortTriangles(SurfaceMesh& mesh)
{
    if (std::is_sorted(mesh.order.begin(), mesh.order.end())) return;
    std::vector<std::uint32_t> places(mesh.order.size());
    std::iota(places.begin(), places.end(), 0u);
    std::stable_sort(places.begin(), places.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return mesh.order[a] < mesh.order[b]; });
    takeTriangles(mesh, places);
}

void dropRepeatedTriangles(SurfaceMesh& mesh)
{
    if (std::adjacent_find(mesh.order.begin(), mesh.order.end()) == mesh.order.end()) return;
    std::vector<std::uint32_t> places;
    for (std::uint32_t i = 0; i < mesh.order.size(); ++i)
        if (i == 0 || mesh.order[i] != mesh.order[i - 1]) places.push_back(i);
    takeTriangles(mesh, places);
}

}  // namespace aeolic
