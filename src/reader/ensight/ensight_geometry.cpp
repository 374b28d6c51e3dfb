#include "reader/ensight/ensight_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

namespace aeolic {
namespace {

constexpr float kFarthest = 1e30F;

using Shape = CellShape;

struct EnSightElement {
    std::string_view name;
    std::size_t nodes;  ///< In the file; 0 where each element has its own number.
    int dimension;      ///< 3: it fills space.
    Shape shape;        ///< Of its corners, which come first. Without meaning where the dimension is below 2.
};

constexpr EnSightElement elements[] = {
    {"point", 1, 0, Shape::triangle},     {"bar2", 2, 1, Shape::triangle},    {"bar3", 3, 1, Shape::triangle},
    {"tria3", 3, 2, Shape::triangle},     {"tria6", 6, 2, Shape::triangle},   {"quad4", 4, 2, Shape::quad},
    {"quad8", 8, 2, Shape::quad},         {"nsided", 0, 2, Shape::polygon},   {"tetra4", 4, 3, Shape::tetra},
    {"tetra10", 10, 3, Shape::tetra},     {"pyramid5", 5, 3, Shape::pyramid}, {"pyramid13", 13, 3, Shape::pyramid},
    {"penta6", 6, 3, Shape::wedge},       {"penta15", 15, 3, Shape::wedge},   {"hexa8", 8, 3, Shape::hexahedron},
    {"hexa20", 20, 3, Shape::hexahedron}, {"nfaced", 0, 3, Shape::polyhedron}};

bool isGhost(std::string_view name)
{
    return name.starts_with("g_");
}

/// Null for an unknown name. The elements of ghosts ("g_hexa8") have the row of the others.
const EnSightElement* findElement(std::string_view name)
{
    if (isGhost(name)) name.remove_prefix(2);
    const auto* const found =
        std::ranges::find_if(elements, [&](const EnSightElement& element) { return element.name == name; });
    return found == std::end(elements) ? nullptr : found;
}

std::string lastWord(const std::string& line)
{
    return line.substr(line.find_last_of(" \t") + 1);
}

std::size_t sumOf(const EnSightStream& stream, const std::vector<std::int64_t>& sizes, const char* item, const char* of,
                  int least)
{
    std::size_t sum = 0;
    for (const std::int64_t size : sizes) {
        if (size < least) stream.fail(fmt::format("{} has {} {}", item, size, of), fmt::format("{} or more", least));
        sum += std::size_t(size);
    }
    return sum;
}

class GeometryText {
public:
    explicit GeometryText(const EnSightPlace& place) : stream_(place) {}

    EnSightGeometry read()
    {
        geometry_.format = stream_.format();
        stream_.line();  // Two of description.
        stream_.line();
        nodeIds_ = idsFollow("node id");
        elementIds_ = idsFollow("element id");
        std::string word = stream_.keyword();
        if (word == "extents") {
            stream_.skipExtents();
            word = stream_.keyword();
        }
        if (word.empty()) stream_.fail("the file is cut off", "parts");
        while (word == "part") word = readPart();
        if (!word.empty()) stream_.fail(fmt::format("found '{}'", word), "'part'");
        return std::move(geometry_);
    }

private:
    bool idsFollow(const std::string& what)
    {
        const std::string line = stream_.line();
        const std::string how = line.starts_with(what) ? lastWord(line) : "";
        if (how != "off" && how != "assign" && how != "given" && how != "ignore")
            stream_.fail(fmt::format("found '{}'", line), fmt::format("'{} off', given, assign or ignore", what));
        return how == "given" || how == "ignore";
    }

    /// Returns the word behind the part; empty at the end of the file.
    std::string readPart()
    {
        EnSightPart part;
        part.number = int(stream_.integer("the number of a part"));
        if (!geometry_.indices.emplace(part.number, geometry_.parts.size()).second)
            stream_.fail(fmt::format("part {} comes once more", part.number), "each part once");
        part.name = stream_.line();
        if (part.name.empty()) part.name = fmt::format("part {}", part.number);
        std::string word = stream_.keyword();
        if (word.starts_with("block")) {
            readEnSightBlock(stream_, word, part);
            word = stream_.keyword();
            if (nodeIds_ && word == "node_ids") word = behindIds(part.pointCount());
            if (elementIds_ && word == "element_ids") word = behindIds(part.sections[0].count);
        } else if (word == "coordinates") {
            readPoints(part);
            for (word = stream_.keyword(); !word.empty() && word != "part"; word = stream_.keyword())
                readSection(part, word);
        }
        geometry_.parts.push_back(std::move(part));
        return word;
    }

    std::string behindIds(std::size_t count)
    {
        stream_.integers(count, "ids");
        return stream_.keyword();
    }

    void readPoints(EnSightPart& part)
    {
        const std::size_t count = stream_.count("the number of points");
        if (nodeIds_) stream_.integers(count, "ids of points");
        for (std::vector<float>& axis : part.points) axis = readEnSightCoordinates(stream_, count);
    }

    void readSection(EnSightPart& part, const std::string& name)
    {
        const EnSightElement* element = findElement(name);
        if (!element)
            stream_.fail(fmt::format("part {} has elements of the unknown kind '{}'", part.number, name),
                         "hexa8, tria3 … nsided, nfaced");
        for (const EnSightSection& other : part.sections)
            if (other.name == name)
                stream_.fail(fmt::format("part {} has '{}' once more", part.number, name), "each kind once");
        const std::size_t count = stream_.count("the number of elements");
        if (elementIds_) stream_.integers(count, "ids of elements");
        PartCells cells{element->shape, count, {}, {}, {}};
        const std::size_t corners = element->nodes == 0 ? readSizes(cells) : count * element->nodes;
        cells.corners = stream_.integers(corners, "corners of elements");
        const auto points = std::int64_t(part.pointCount());
        for (std::int64_t& corner : cells.corners) {
            if (corner < 1 || corner > points)
                stream_.fail(fmt::format("part {} has the corner {} in '{}'", part.number, corner, name),
                             fmt::format("1 to {}, the number of its points", points));
            --corner;
        }
        const bool kept = element->dimension >= 2 && !isGhost(name);
        if (kept) dropPointsBetween(cells, element->nodes);
        part.sections.push_back({name, count, kept, kept ? std::move(cells) : PartCells()});
    }

    /// Returns how many corners there are.
    std::size_t readSizes(PartCells& cells)
    {
        cells.sizes = stream_.integers(cells.count, "sizes of elements");
        if (cells.shape == Shape::polygon) return sumOf(stream_, cells.sizes, "a polygon", "corners", 3);
        const std::size_t faces = sumOf(stream_, cells.sizes, "a polyhedron", "faces", 1);
        cells.ofFaces = stream_.integers(faces, "sizes of faces");
        return sumOf(stream_, cells.ofFaces, "a face", "corners", 3);
    }

    /// Drops the points between corners. `nodes`: how many points each element has in the file.
    static void dropPointsBetween(PartCells& cells, std::size_t nodes)
    {
        const std::size_t corners = cornersOf(cells.shape);
        if (nodes == corners) return;
        for (std::size_t i = 0; i < cells.count; ++i)
            std::copy_n(cells.corners.begin() + std::ptrdiff_t(i * nodes), corners,
                        cells.corners.begin() + std::ptrdiff_t(i * corners));
        cells.corners.resize(cells.count * corners);
    }

    EnSightStream stream_;
    bool nodeIds_ = false, elementIds_ = false;
    EnSightGeometry geometry_;
};

}  // namespace

std::size_t EnSightPart::cells() const
{
    std::size_t sum = 0;
    for (const EnSightSection& section : sections) sum += section.kept ? section.count : 0;
    return sum;
}

bool EnSightPart::fillsSpace() const
{
    return std::ranges::any_of(sections, [](const EnSightSection& section) {
        return section.count > 0 && aeolic::fillsSpace(section.cells.shape);
    });
}

std::vector<float> readEnSightCoordinates(EnSightStream& stream, std::size_t count)
{
    std::vector<float> values = stream.floats(count, "coordinates");
    for (const float value : values)
        if (!(std::abs(value) <= kFarthest)) stream.fail(fmt::format("a coordinate is {}", value), "at most 1e30");
    return values;
}

EnSightGeometry readEnSightGeometry(const EnSightPlace& place)
{
    return GeometryText(place).read();
}

}  // namespace aeolic
