#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "reader/cgns/cgns_zone.h"

namespace aeolic {
namespace {

using Wholes = std::vector<std::int64_t>;

/// The product of all lengths. Where it has no room, as that of damaged lengths, it is the largest number that has.
std::int64_t productOf(const Wholes& lengths)
{
    std::int64_t product = 1;
    for (const std::int64_t length : lengths)
        if (__builtin_mul_overflow(product, length, &product)) return std::numeric_limits<std::int64_t>::max();
    return product;
}

/// A point's number in the file as an index.
std::int64_t indexOf(const CgnsNode& node, std::int64_t number, std::size_t points)
{
    if (number < 1 || std::uint64_t(number) > points)
        node.fail(fmt::format("an element has the corner {}", number),
                  fmt::format("1 to {}, the number of points", points));
    return number - 1;
}

}  // namespace

std::size_t CgnsZone::pointCount() const
{
    return std::size_t(productOf(vertices_));
}

/// The cells of a structured zone in each direction; a direction of one point counts as one cell.
Wholes CgnsZone::cellLengths() const
{
    Wholes lengths;
    for (const std::int64_t length : vertices_) lengths.push_back(std::max<std::int64_t>(length - 1, 1));
    return lengths;
}

/// What an array has within the layers around it. `lengths`: in each direction, without them.
template <class Number>
std::vector<Number> CgnsZone::readWithout(const CgnsNode& node, const Wholes& rind, const Wholes& lengths) const
{
    std::vector<std::uint64_t> first, count, whole;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        const std::int64_t before = rind.size() == 2 * lengths.size() ? rind[2 * i] : 0,
                           behind = rind.size() == 2 * lengths.size() ? rind[2 * i + 1] : 0;
        if (before < 0 || behind < 0)
            node.fail(fmt::format("there are {} and {} layers around it", before, behind), "from 0");
        first.push_back(std::uint64_t(before));
        count.push_back(std::uint64_t(lengths[i]));
        whole.push_back(first.back() + count.back() + std::uint64_t(behind));
    }
    const std::vector<std::uint64_t> found = node.shape();
    if (found == whole) return node.read<Number>(first, count);
    std::uint64_t product = 1;
    for (const std::uint64_t length : found) product *= length;
    if (rind.empty() && product == std::uint64_t(productOf(lengths)))
        return node.read<Number>(std::vector<std::uint64_t>(found.size(), 0), found);
    node.fail(fmt::format("it has {} numbers", fmt::join(found, " x ")), fmt::format("{}", fmt::join(whole, " x ")));
}

PartPoints CgnsZone::points() const
{
    if (points_) return points_;
    if (!coordinates_) fail("it has no coordinates", "GridCoordinates");
    const Wholes rind = coordinates_->childOf("Rind_t") ? coordinates_->childOf("Rind_t")->wholes() : Wholes();
    std::optional<CgnsNode> axes[3];
    for (int c = 0; c < 3; ++c) axes[c] = coordinates_->child(std::string("Coordinate") + "XYZ"[c]);
    if (!axes[0] || !axes[1]) coordinates_->fail("it has no CoordinateX or CoordinateY", "Cartesian coordinates");
    std::vector<std::vector<double>> values;
    for (const auto& axis : axes)
        if (axis) values.push_back(readWithout<double>(*axis, rind, vertices_));
    auto points = std::make_shared<std::vector<glm::dvec3>>(pointCount());
    for (std::size_t i = 0; i < points->size(); ++i)
        (*points)[i] = {values[0][i], values[1][i], values.size() > 2 ? values[2][i] : 0};
    points_ = std::move(points);
    return points_;
}

std::vector<float> CgnsZone::read(const CgnsField& field) const
{
    if (field.onPoints) return readWithout<float>(field.node, field.rind, vertices_);
    return structured_ ? readWithout<float>(field.node, field.rind, cellLengths()) : readList(field);
}

std::vector<float> CgnsZone::readList(const CgnsField& field) const
{
    std::vector<std::uint64_t> shape = field.node.shape();
    if (shape.size() != 1) field.node.fail(fmt::format("it has {} numbers", fmt::join(shape, " x ")), "a list");
    std::int64_t around = 0;
    for (const std::int64_t layers : field.rind) {
        if (layers < 0 || std::uint64_t(layers) > shape[0] - std::uint64_t(around))
            field.node.fail(fmt::format("there are {} layers around it", layers), fmt::format("up to {}", shape[0]));
        around += layers;
    }
    return readWithout<float>(field.node, field.rind, {std::int64_t(shape[0]) - around});
}

std::vector<PartCells> CgnsZone::cells() const
{
    const std::size_t points = this->points()->size();
    std::vector<PartCells> cells;
    if (!structured_) {
        for (const CgnsSection& section : sections_) {
            if (section.dimension != dimension_) continue;
            if (section.type == kCgnsNface) continue;
            std::vector<PartCells> own = cellsOf(section);
            std::move(own.begin(), own.end(), std::back_inserter(cells));
        }
        std::vector<PartCells> own = polyhedra();
        std::move(own.begin(), own.end(), std::back_inserter(cells));
        return cells;
    }
    Wholes lengths, steps;  // Of the directions in which there are cells.
    std::int64_t step = 1;
    for (const std::int64_t length : vertices_) {
        if (length > 1) {
            lengths.push_back(length);
            steps.push_back(step);
        }
        step *= length;
    }
    if (lengths.size() < 2 || std::uint64_t(step) > points) return cells;
    PartCells own{lengths.size() == 3 ? CellShape::hexahedron : CellShape::quad, 0, {}, {}, {}};
    own.corners.reserve(points * cornersOf(own.shape));
    const std::int64_t layers = lengths.size() == 3 ? lengths[2] - 1 : 1;
    for (std::int64_t k = 0; k < layers; ++k)
        for (std::int64_t j = 0; j + 1 < lengths[1]; ++j)
            for (std::int64_t i = 0; i + 1 < lengths[0]; ++i, ++own.count)
                for (std::size_t upper = 0; upper < (lengths.size() == 3 ? 2U : 1U); ++upper) {
                    const std::int64_t at =
                        i * steps[0] + j * steps[1] + (lengths.size() == 3 ? (k + std::int64_t(upper)) * steps[2] : 0);
                    for (const std::int64_t corner : {at, at + steps[0], at + steps[0] + steps[1], at + steps[1]})
                        own.corners.push_back(corner);
                }
    cells.push_back(std::move(own));
    return cells;
}

Wholes CgnsZone::connectivity(const CgnsSection& section) const
{
    const auto corners = section.node.child("ElementConnectivity");
    if (!corners) section.node.fail("it has no ElementConnectivity", "one");
    return corners->wholes();
}

/// Where each element's numbers begin, and the last ends; nothing where the file counts them before each element.
std::optional<Wholes> CgnsZone::offsets(const CgnsSection& section) const
{
    const auto node = section.node.child("ElementStartOffset");
    if (!node) return std::nullopt;
    Wholes offsets = node->wholes();
    if (offsets.size() != section.count() + 1 || offsets[0] != 0 || !std::is_sorted(offsets.begin(), offsets.end()))
        node->fail(fmt::format("it has {} numbers", offsets.size()),
                   fmt::format("{} numbers from 0 on, none smaller than the one before", section.count() + 1));
    return offsets;
}

/// Elements of a kind, or of several kinds that each say which; those of another dimension than the zone's are left
/// out.
std::vector<PartCells> CgnsZone::cellsOf(const CgnsSection& section) const
{
    if (section.type == kCgnsNgon) return {facesOf(section)};
    const Wholes numbers = connectivity(section);
    std::vector<PartCells> cells;
    const bool mixed = section.type == kCgnsMixed;
    std::size_t at = 0;
    for (std::size_t i = 0; i < section.count(); ++i) {
        const std::int64_t type = !mixed ? section.type : at < numbers.size() ? numbers[at] : 0;
        at += mixed;
        const CgnsElement* element = findCgnsElement(type);
        if (!element || std::size_t(element->nodes) > numbers.size() - std::min(at, numbers.size()))
            section.node.fail(fmt::format("element {} of kind {} is not there", section.first + std::int64_t(i), type),
                              "a kind and its corners for each element");
        if (element->dimension == dimension_) {
            if (cells.empty() || cells.back().shape != element->shape) cells.push_back({element->shape, 0, {}, {}, {}});
            for (std::size_t k = 0; k < cornersOf(element->shape); ++k)
                cells.back().corners.push_back(indexOf(section.node, numbers[at + k], pointCount()));
            ++cells.back().count;
        }
        at += std::size_t(element->nodes);
    }
    if (at != numbers.size())
        section.node.fail(fmt::format("it has {} corners", numbers.size()), fmt::format("{} for its elements", at));
    return cells;
}

/// Every element of the section as a face; without corners where the element is not a face.
FaceList CgnsZone::facesByNumber(const CgnsSection& section) const
{
    const Wholes numbers = connectivity(section);
    FaceList faces;
    const auto ends = section.type == kCgnsNgon ? offsets(section) : std::nullopt;
    std::size_t at = 0;
    for (std::size_t i = 0; i < section.count(); ++i) {
        const auto need = [&](std::int64_t count) {
            if (count < 0 || std::uint64_t(count) > numbers.size() - std::min(at, numbers.size()))
                section.node.fail(fmt::format("element {} is not there", section.first + std::int64_t(i)),
                                  "corners for each element");
            return std::size_t(count);
        };
        std::size_t nodes = 0, corners = 0;
        if (section.type == kCgnsNgon) {
            if (ends) at = std::size_t((*ends)[i]);
            corners = nodes = ends ? need((*ends)[i + 1] - (*ends)[i]) : need(numbers[at + need(1) - 1]);
            if (!ends) need(std::int64_t(nodes) + 1);
            at += ends ? 0 : 1;
        } else {
            const std::int64_t type = section.type == kCgnsMixed ? numbers[at + need(1) - 1] : section.type;
            at += section.type == kCgnsMixed;
            const CgnsElement* element = findCgnsElement(type);
            if (!element)
                section.node.fail(fmt::format("an element has the unknown kind {}", type), "a kind of CGNS 4");
            nodes = need(element->nodes);
            corners = element->dimension == 2 ? cornersOf(element->shape) : 0;
        }
        if (corners < 3) corners = 0;
        for (std::size_t k = 0; k < corners; ++k)
            faces.corners.push_back(indexOf(section.node, numbers[at + k], pointCount()));
        faces.ends.push_back(faces.corners.size());
        at += nodes;
    }
    return faces;
}

PartCells CgnsZone::facesOf(const CgnsSection& section) const
{
    points();  // So that its number of points is what the file has.
    const FaceList all = facesByNumber(section);
    FaceList faces;
    for (std::size_t i = 0; i < all.count(); ++i)
        if (!all.face(i).empty()) faces.add(all.face(i));
    return faces.asPolygons();
}

/// Cells that the file makes of its polygons. A number below zero turns the polygon around.
std::vector<PartCells> CgnsZone::polyhedra() const
{
    std::vector<std::pair<const CgnsSection*, FaceList>> polygons;
    std::vector<PartCells> cells;
    for (const CgnsSection& section : sections_) {
        if (section.type != kCgnsNface || section.dimension != dimension_) continue;
        if (polygons.empty())
            for (const CgnsSection& other : sections_)
                if (other.type == kCgnsNgon) polygons.emplace_back(&other, facesByNumber(other));
        std::vector<std::vector<std::uint8_t>> uses;
        uses.reserve(polygons.size());
        for (const auto& [other, faces] : polygons) uses.emplace_back(faces.count(), std::uint8_t{0});
        const Wholes numbers = connectivity(section);
        const auto ends = offsets(section);
        PartCells own{CellShape::polyhedron, section.count(), {}, {}, {}};
        std::size_t at = 0;
        for (std::size_t i = 0; i < section.count(); ++i) {
            if (ends) at = std::size_t((*ends)[i]);
            if (!ends && at >= numbers.size()) section.node.fail("it is cut off", "faces for each cell");
            const std::int64_t size = ends ? (*ends)[i + 1] - (*ends)[i] : numbers[at++];
            if (size < 1 || std::uint64_t(size) > numbers.size() - std::min(at, numbers.size()))
                section.node.fail(fmt::format("cell {} has {} faces", section.first + std::int64_t(i), size),
                                  "as many as there are");
            own.sizes.push_back(size);
            for (std::int64_t k = 0; k < size; ++k) {
                const std::int64_t number = std::max(numbers[at++], -std::numeric_limits<std::int64_t>::max()),
                                   plain = std::abs(number);
                std::size_t list = 0;
                while (list < polygons.size() &&
                       (plain < polygons[list].first->first || plain > polygons[list].first->last))
                    ++list;
                if (list == polygons.size())
                    section.node.fail(fmt::format("a cell has the face {}", number), "a polygon of the zone");
                const auto place = std::size_t(plain - polygons[list].first->first);
                const auto face = polygons[list].second.face(place);
                if (face.empty() || ++uses[list][place] > 2)
                    section.node.fail(fmt::format("the face {} {}", plain,
                                                  face.empty() ? "has no corners" : "belongs to three cells"),
                                      "polygons between two cells");
                own.ofFaces.push_back(std::int64_t(face.size()));
                own.corners.insert(own.corners.end(), face.begin(), face.end());
                if (number < 0) std::reverse(own.corners.end() - std::ptrdiff_t(face.size()), own.corners.end());
            }
        }
        cells.push_back(std::move(own));
    }
    return cells;
}

}  // namespace aeolic
