#include "reader/parts/cell_of_faces.h"

#include <algorithm>
#include <set>

namespace aeolic {
namespace {

using Face = std::span<const std::int64_t>;

/// The corner beside `corner` in a face around the base that is not in the base; -1 where there is none.
std::int64_t above(std::int64_t corner, Face base, std::span<const Face> faces)
{
    const auto inBase = [&](std::int64_t each) { return std::find(base.begin(), base.end(), each) != base.end(); };
    for (const Face& face : faces) {
        if (face.data() == base.data()) continue;
        const auto at = std::size_t(std::find(face.begin(), face.end(), corner) - face.begin());
        if (at == face.size()) continue;
        for (const std::size_t step : {std::size_t{1}, face.size() - 1})
            if (const std::int64_t beside = face[(at + step) % face.size()]; !inBase(beside)) return beside;
    }
    return -1;
}

}  // namespace

std::optional<ShapedCell> cellOfFaces(std::span<const Face> faces)
{
    const auto threes = std::size_t(std::count_if(faces.begin(), faces.end(), [](Face f) { return f.size() == 3; })),
               fours = std::size_t(std::count_if(faces.begin(), faces.end(), [](Face f) { return f.size() == 4; }));
    if (threes + fours != faces.size()) return std::nullopt;
    const bool tetra = threes == 4 && fours == 0, pyramid = threes == 4 && fours == 1,
               wedge = threes == 2 && fours == 3, hexahedron = threes == 0 && fours == 6;
    if (!tetra && !pyramid && !wedge && !hexahedron) return std::nullopt;
    const std::size_t sides = wedge || tetra ? 3 : 4;
    const Face base = *std::find_if(faces.begin(), faces.end(), [&](Face f) { return f.size() == sides; });
    ShapedCell cell{tetra     ? CellShape::tetra
                    : pyramid ? CellShape::pyramid
                    : wedge   ? CellShape::wedge
                              : CellShape::hexahedron,
                    {base.rbegin(), base.rend()}};
    std::vector<std::int64_t> upper;
    for (const std::int64_t corner : cell.corners) upper.push_back(above(corner, base, faces));
    if (tetra || pyramid) upper.resize(1);
    cell.corners.insert(cell.corners.end(), upper.begin(), upper.end());
    const std::set<std::int64_t> once(cell.corners.begin(), cell.corners.end());
    if (once.size() != cell.corners.size() || *once.begin() < 0 || cell.corners.size() != cornersOf(cell.shape))
        return std::nullopt;
    for (const Face& face : faces)
        for (const std::int64_t corner : face)
            if (!once.contains(corner)) return std::nullopt;
    return cell;
}

std::vector<std::int64_t> polygonOfEdges(std::span<const Face> edges)
{
    if (edges.size() < 3) return {};
    std::vector<std::int64_t> polygon;
    std::vector<bool> used(edges.size(), false);
    std::int64_t at = edges[0].front();
    for (std::size_t n = 0; n < edges.size(); ++n) {
        std::size_t i = 0;
        while (i < edges.size() && (used[i] || edges[i].size() != 2 || (edges[i][0] != at && edges[i][1] != at))) ++i;
        if (i == edges.size()) return {};
        used[i] = true;
        polygon.push_back(at);
        at = edges[i][0] == at ? edges[i][1] : edges[i][0];
    }
    return at == polygon.front() ? polygon : std::vector<std::int64_t>();
}

}  // namespace aeolic
