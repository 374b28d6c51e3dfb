#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <span>

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
std::int64_t indexOf(const CgnsNodePtr& node, std::int64_t number, std::size_t points)
{
    if (number < 1 || std::uint64_t(number) > points)
        node->fail(fmt::format("an element has the corner {}", number),
                   fmt::format("1 to {}, the number of points", points));
    return number - 1;
}

Wholes connectivityOf(const CgnsSection& section)
{
    const auto corners = section.node->child("ElementConnectivity");
    if (!corners) section.node->fail("it has no ElementConnectivity", "one");
    return corners->wholes();
}

/// Calls take(own numbers) for each polygon or polyhedron. The file says where they begin, or counts them before each.
template <class Take>
void forEachList(const CgnsSection& section, const Wholes& numbers, const Take& take)
{
    const auto node = section.node->child("ElementStartOffset");
    const Wholes offsets = node ? node->wholes() : Wholes();
    if (node && (offsets.size() != section.count() + 1 || offsets[0] != 0 || !std::ranges::is_sorted(offsets)))
        node->fail(fmt::format("it has {} numbers", offsets.size()),
                   fmt::format("{} numbers from 0 on, none smaller than the one before", section.count() + 1));
    std::size_t at = 0;
    for (std::size_t i = 0; i < section.count(); ++i) {
        const std::int64_t size = node ? offsets[i + 1] - offsets[i] : at < numbers.size() ? numbers[at++] : -1;
        if (size < 0 || std::uint64_t(size) > numbers.size() - at)
            section.node->fail(fmt::format("element {} is not there", section.first + std::int64_t(i)),
                               "numbers for each element");
        take(std::span(numbers).subspan(at, std::size_t(size)));
        at += std::size_t(size);
    }
}

/// Calls take(element, nodes) for each element of a kind, or of several kinds that each say which. Returns how
/// many numbers all of them have.
template <class Take>
std::size_t forEachElement(const CgnsSection& section, const Wholes& numbers, const Take& take)
{
    const bool mixed = section.type == kCgnsMixed;
    std::size_t at = 0;
    for (std::size_t i = 0; i < section.count(); ++i) {
        const std::int64_t type = !mixed ? section.type : at < numbers.size() ? numbers[at] : 0;
        at += mixed;
        const CgnsElement* element = findCgnsElement(type);
        if (!element || std::size_t(element->nodes) > numbers.size() - std::min(at, numbers.size()))
            section.node->fail(fmt::format("element {} of kind {} is not there", section.first + std::int64_t(i), type),
                               "a kind and its corners for each element");
        take(*element, std::span(numbers).subspan(at, std::size_t(element->nodes)));
        at += std::size_t(element->nodes);
    }
    return at;
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
std::vector<Number> CgnsZone::readWithout(const CgnsNodePtr& node, const Wholes& rind, const Wholes& lengths) const
{
    std::vector<std::uint64_t> first, count, whole;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        const std::int64_t before = rind.size() == 2 * lengths.size() ? rind[2 * i] : 0,
                           behind = rind.size() == 2 * lengths.size() ? rind[2 * i + 1] : 0;
        if (before < 0 || behind < 0)
            node->fail(fmt::format("there are {} and {} layers around it", before, behind), "from 0");
        first.push_back(std::uint64_t(before));
        count.push_back(std::uint64_t(lengths[i]));
        whole.push_back(first.back() + count.back() + std::uint64_t(behind));
    }
    const std::vector<std::uint64_t> found = node->shape();
    if (found == whole) return node->read<Number>(first, count);
    std::uint64_t product = 1;
    for (const std::uint64_t length : found) product *= length;
    if (rind.empty() && product == std::uint64_t(productOf(lengths))) return node->read<Number>();
    node->fail(fmt::format("it has {} numbers", fmt::join(found, " x ")), fmt::format("{}", fmt::join(whole, " x ")));
}

PartPoints CgnsZone::points() const
{
    if (points_) return points_;
    if (!coordinates_) fail("it has no coordinates", "GridCoordinates");
    const Wholes rind = coordinates_->childOf("Rind_t") ? coordinates_->childOf("Rind_t")->wholes() : Wholes();
    CgnsNodePtr axes[3];
    for (int c = 0; c < 3; ++c) axes[c] = coordinates_->child(std::string("Coordinate") + "XYZ"[c]);
    if (!axes[0] || !axes[1]) coordinates_->fail("it has no CoordinateX or CoordinateY", "Cartesian coordinates");
    std::vector<std::vector<double>> values;
    for (const auto& axis : axes)
        if (axis) values.push_back(readWithout<double>(axis, rind, vertices_));
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
    std::vector<std::uint64_t> shape = field.node->shape();
    if (shape.size() != 1) field.node->fail(fmt::format("it has {} numbers", fmt::join(shape, " x ")), "a list");
    std::int64_t around = 0;
    for (const std::int64_t layers : field.rind) {
        if (layers < 0 || std::uint64_t(layers) > shape[0] - std::uint64_t(around))
            field.node->fail(fmt::format("there are {} layers around it", layers), fmt::format("up to {}", shape[0]));
        around += layers;
    }
    return readWithout<float>(field.node, field.rind, {std::int64_t(shape[0]) - around});
}

std::vector<PartCells> CgnsZone::cells() const
{
    points();  // So that its number of points is what the file has.
    if (structured_) return {orderedCells(vertices_)};
    std::vector<PartCells> cells;
    for (const CgnsSection& section : sections_) {
        if (section.dimension != dimension_ || section.type == kCgnsNface) continue;
        std::vector<PartCells> own = cellsOf(section);
        std::move(own.begin(), own.end(), std::back_inserter(cells));
    }
    std::vector<PartCells> own = polyhedra();
    std::move(own.begin(), own.end(), std::back_inserter(cells));
    return cells;
}

/// The section's elements of the zone's dimension; others are left out.
std::vector<PartCells> CgnsZone::cellsOf(const CgnsSection& section) const
{
    if (section.type == kCgnsNgon) return {facesOf(section)};
    const Wholes numbers = connectivityOf(section);
    std::vector<PartCells> cells;
    const auto take = [&](const CgnsElement& element, std::span<const std::int64_t> nodes) {
        if (element.dimension != dimension_) return;
        if (cells.empty() || cells.back().shape != element.shape) cells.push_back({element.shape, 0, {}, {}, {}});
        for (const std::int64_t node : nodes.first(cornersOf(element.shape)))
            cells.back().corners.push_back(indexOf(section.node, node, pointCount()));
        ++cells.back().count;
    };
    const std::size_t all = forEachElement(section, numbers, take);
    if (all != numbers.size())
        section.node->fail(fmt::format("it has {} corners", numbers.size()), fmt::format("{} for its elements", all));
    return cells;
}

/// Every element of the section as a face; without corners where the element is not a face.
FaceList CgnsZone::facesByNumber(const CgnsSection& section) const
{
    const Wholes numbers = connectivityOf(section);
    FaceList faces;
    const auto add = [&](std::span<const std::int64_t> corners) {
        for (const std::int64_t corner : corners) faces.corners.push_back(indexOf(section.node, corner, pointCount()));
        faces.ends.push_back(faces.corners.size());
    };
    if (section.type == kCgnsNgon) {
        forEachList(section, numbers, [&](std::span<const std::int64_t> corners) {
            add(corners.first(corners.size() < 3 ? 0 : corners.size()));
        });
    } else {
        forEachElement(section, numbers, [&](const CgnsElement& element, std::span<const std::int64_t> nodes) {
            add(nodes.first(element.dimension == 2 ? cornersOf(element.shape) : 0));
        });
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
        const Wholes numbers = connectivityOf(section);
        PartCells own{CellShape::polyhedron, section.count(), {}, {}, {}};
        forEachList(section, numbers, [&](std::span<const std::int64_t> list) {
            if (list.empty())
                section.node->fail(
                    fmt::format("element {} has 0 faces", section.first + std::int64_t(own.sizes.size())),
                    "one or more");
            own.sizes.push_back(std::int64_t(list.size()));
            for (const std::int64_t said : list) {
                const std::int64_t number = std::max(said, -std::numeric_limits<std::int64_t>::max()),
                                   plain = std::abs(number);
                std::size_t of = 0;
                while (of < polygons.size() && (plain < polygons[of].first->first || plain > polygons[of].first->last))
                    ++of;
                if (of == polygons.size())
                    section.node->fail(fmt::format("a cell has the face {}", number), "a polygon of the zone");
                const auto place = std::size_t(plain - polygons[of].first->first);
                const auto face = polygons[of].second.face(place);
                if (face.empty() || ++uses[of][place] > 2)
                    section.node->fail(fmt::format("the face {} {}", plain,
                                                   face.empty() ? "has no corners" : "belongs to three cells"),
                                       "polygons between two cells");
                own.ofFaces.push_back(std::int64_t(face.size()));
                own.corners.insert(own.corners.end(), face.begin(), face.end());
                if (number < 0) std::reverse(own.corners.end() - std::ptrdiff_t(face.size()), own.corners.end());
            }
        });
        cells.push_back(std::move(own));
    }
    return cells;
}

}  // namespace aeolic
