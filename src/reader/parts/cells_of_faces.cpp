#include "reader/parts/cells_of_faces.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <utility>

#include "aeolic/error.h"

namespace aeolic {
namespace {

using Face = std::span<const std::int64_t>;

/// A cell with its corners in the order of its shape.
struct ShapedCell {
    CellShape shape = CellShape::hexahedron;
    std::array<std::int64_t, 8> corners{};
};

/// Where a corner stands in a face; the face's size where it does not. Faces are short.
std::size_t placeIn(Face face, std::int64_t corner)
{
    std::size_t at = 0;
    while (at < face.size() && face[at] != corner) ++at;
    return at;
}

bool has(Face face, std::int64_t corner)
{
    return placeIn(face, corner) < face.size();
}

/// The corner beside `corner` in a face around the base that is not in the base; -1 where there is none.
std::int64_t above(std::int64_t corner, Face base, std::span<const Face> faces)
{
    for (const Face& face : faces) {
        if (face.data() == base.data()) continue;
        const std::size_t at = placeIn(face, corner), last = face.size() - 1;
        if (at > last) continue;
        for (const std::size_t beside : {at == last ? 0 : at + 1, at == 0 ? last : at - 1})
            if (!has(base, face[beside])) return face[beside];
    }
    return -1;
}

/// The tetrahedron, pyramid, wedge or hexahedron that has these faces, seen from outside; nothing where they are those
/// of another cell.
std::optional<ShapedCell> shapedCell(std::span<const Face> faces, FirstCorner firstCorner)
{
    const auto threes = std::size_t(std::count_if(faces.begin(), faces.end(), [](Face f) { return f.size() == 3; })),
               fours = std::size_t(std::count_if(faces.begin(), faces.end(), [](Face f) { return f.size() == 4; }));
    if (threes + fours != faces.size()) return std::nullopt;
    const bool tetra = threes == 4 && fours == 0, pyramid = threes == 4 && fours == 1,
               wedge = threes == 2 && fours == 3, hexahedron = threes == 0 && fours == 6;
    if (!tetra && !pyramid && !wedge && !hexahedron) return std::nullopt;
    const std::size_t sides = wedge || tetra ? 3 : 4;
    const Face base = *std::find_if(faces.begin(), faces.end(), [&](Face f) { return f.size() == sides; });
    ShapedCell cell;
    cell.shape = tetra     ? CellShape::tetra
                 : pyramid ? CellShape::pyramid
                 : wedge   ? CellShape::wedge
                           : CellShape::hexahedron;
    const std::size_t size = cornersOf(cell.shape);
    std::copy(base.rbegin(), base.rend(), cell.corners.begin());
    if (firstCorner == FirstCorner::first)
        std::rotate(cell.corners.begin(), cell.corners.begin() + std::ptrdiff_t(sides) - 1,
                    cell.corners.begin() + std::ptrdiff_t(sides));
    for (std::size_t i = sides; i < size; ++i) cell.corners[i] = above(cell.corners[i - sides], base, faces);
    const std::span<std::int64_t> corners = std::span(cell.corners).first(size);
    for (std::size_t i = 0; i < size; ++i)
        if (corners[i] < 0 || has(corners.first(i), corners[i])) return std::nullopt;
    for (const Face& face : faces)
        for (const std::int64_t corner : face)
            if (!has(corners, corner)) return std::nullopt;
    if (wedge && firstCorner == FirstCorner::first) {
        std::rotate(corners.begin(), corners.begin() + 3, corners.end());
        std::swap(corners[1], corners[2]);
        std::swap(corners[4], corners[5]);
    }
    return cell;
}

/// The polygon whose edges these are, in any order and direction; empty where they make no polygon or several.
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

/// The list that takes the next cell: the last one where it is of this shape.
PartCells& listFor(std::vector<PartCells>& cells, CellShape shape)
{
    if (cells.empty() || cells.back().shape != shape) cells.push_back({shape, 0, {}, {}, {}});
    ++cells.back().count;
    return cells.back();
}

}  // namespace

CellsOfFaces::CellsOfFaces(MeshFaces faces, std::size_t cells, FirstCorner firstCorner, std::string where)
    : faces_(std::move(faces)), firstCorner_(firstCorner), where_(std::move(where)), begins_(cells + 1, 0)
{
    if (std::max(faces_.count(), cells) > MeshFaces::kMost)
        throw InputError(where_, fmt::format("it has {} faces and {} cells", faces_.count(), cells), "at most 2^31");
    const std::vector<std::uint32_t> inside = std::move(faces_.inside), outside = std::move(faces_.outside);
    std::size_t all = 0;
    for (const auto* side : {&inside, &outside})
        for (const std::uint32_t cell : *side)
            if (cell > 0) {
                ++begins_[cell];
                ++all;
            }
    for (std::size_t i = 1; i <= cells; ++i) begins_[i] += begins_[i - 1];
    list_.resize(all);
    std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);
    for (std::size_t i = 0; i < inside.size(); ++i) {
        const auto number = std::int32_t(i) + 1;
        if (inside[i] > 0) list_[next[inside[i] - 1]++] = number;
        if (outside[i] > 0) list_[next[outside[i] - 1]++] = -number;
    }
}

/// A cell's faces as they are seen from outside of it. They hold until the next cell is taken.
class CellsOfFaces::Turned {
public:
    explicit Turned(const CellsOfFaces& all) : all_(all) {}

    std::span<const Face> of(std::size_t cell)
    {
        const std::size_t fixed = all_.firstCorner_ == FirstCorner::first ? 1 : 0;
        const auto face = [&](std::int32_t number) { return all_.faces_.face(std::size_t(std::abs(number)) - 1); };
        std::size_t all = 0;
        for (const std::int32_t number : all_.facesOf(cell)) all += face(number).size();
        corners_.resize(all);
        faces_.clear();
        std::int64_t* to = corners_.data();
        for (const std::int32_t number : all_.facesOf(cell)) {
            const auto from = face(number);
            for (std::size_t k = 0; k < from.size(); ++k)
                to[k] = from[number > 0 || k < fixed ? k : from.size() - 1 - k + fixed];
            faces_.emplace_back(to, from.size());
            to += from.size();
        }
        return faces_;
    }

private:
    const CellsOfFaces& all_;
    std::vector<std::int64_t> corners_;
    std::vector<Face> faces_;
};

std::vector<PartCells> CellsOfFaces::cells(std::int64_t first, std::int64_t last) const
{
    std::vector<PartCells> cells;
    Turned turned(*this);
    for (std::int64_t number = first; number <= last; ++number) {
        const std::span<const Face> faces = turned.of(std::size_t(number - 1));
        if (const auto simple = shapedCell(faces, firstCorner_)) {
            PartCells& to = listFor(cells, simple->shape);
            const bool isFirst = cells.size() == 1 && to.count == 1;  // Often all cells are like it.
            if (isFirst) to.corners.reserve(std::size_t(last - first + 1) * cornersOf(simple->shape));
            to.corners.insert(to.corners.end(), simple->corners.begin(),
                              simple->corners.begin() + std::ptrdiff_t(cornersOf(simple->shape)));
            continue;
        }
        if (faces.size() < 4)
            throw InputError(where_, fmt::format("the cell {} has {} faces", number, faces.size()), "four or more");
        PartCells& to = listFor(cells, CellShape::polyhedron);
        to.sizes.push_back(std::int64_t(faces.size()));
        for (const Face& face : faces) {
            if (face.size() < 3)
                throw InputError(where_, fmt::format("the cell {} has a face of {} corners", number, face.size()),
                                 "three or more");
            to.ofFaces.push_back(std::int64_t(face.size()));
            to.corners.insert(to.corners.end(), face.begin(), face.end());
        }
    }
    return cells;
}

std::vector<PartCells> CellsOfFaces::polygons(std::int64_t first, std::int64_t last) const
{
    std::vector<PartCells> cells;
    Turned turned(*this);
    for (std::int64_t number = first; number <= last; ++number) {
        const std::span<const Face> edges = turned.of(std::size_t(number - 1));
        const std::vector<std::int64_t> polygon = polygonOfEdges(edges);
        if (polygon.empty())
            throw InputError(where_,
                             fmt::format("the cell {} has {} edges that close no polygon", number, edges.size()),
                             "edges that close");
        PartCells& to = listFor(cells, CellShape::polygon);
        to.sizes.push_back(std::int64_t(polygon.size()));
        to.corners.insert(to.corners.end(), polygon.begin(), polygon.end());
    }
    return cells;
}

}  // namespace aeolic
