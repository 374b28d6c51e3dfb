#include "reader/ensight/ensight_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace aeolic {
namespace {

constexpr float kFarthest = 1e30F;

std::string lastWord(const std::string& line)
{
    return line.substr(line.find_last_of(" \t") + 1);
}

std::size_t sumOf(const EnSightStream& stream, const std::vector<std::int32_t>& sizes, const char* item, const char* of,
                  int least)
{
    std::size_t sum = 0;
    for (const std::int32_t size : sizes) {
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
        part.number = stream_.integer("the number of a part");
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
        EnSightSection section;
        section.name = name;
        section.element = findEnSightElement(name);
        if (!section.element)
            stream_.fail(fmt::format("part {} has elements of the unknown kind '{}'", part.number, name),
                         "hexa8, tria3 … nsided, nfaced");
        for (const EnSightSection& other : part.sections)
            if (other.name == name)
                stream_.fail(fmt::format("part {} has '{}' once more", part.number, name), "each kind once");
        section.kept = section.element->dimension >= 2 && !isEnSightGhost(name);
        section.count = stream_.count("the number of elements");
        if (elementIds_) stream_.integers(section.count, "ids of elements");
        std::size_t corners = section.count * section.element->nodes;
        if (section.element->nodes == 0) corners = readSizes(section);
        section.corners = stream_.integers(corners, "corners of elements");
        takeCorners(section, part);
        part.sections.push_back(std::move(section));
    }

    /// Returns how many corners there are.
    std::size_t readSizes(EnSightSection& section)
    {
        section.sizes = stream_.integers(section.count, "sizes of elements");
        if (section.element->shape == EnSightShape::polygon)
            return sumOf(stream_, section.sizes, "a polygon", "corners", 3);
        const std::size_t faces = sumOf(stream_, section.sizes, "a polyhedron", "faces", 1);
        section.ofFaces = stream_.integers(faces, "sizes of faces");
        return sumOf(stream_, section.ofFaces, "a face", "corners", 3);
    }

    /// Leaves the corners of the elements that are kept, from 0, and drops all others.
    void takeCorners(EnSightSection& section, const EnSightPart& part) const
    {
        const auto points = std::int64_t(part.pointCount());
        for (std::int32_t& corner : section.corners) {
            if (corner < 1 || corner > points)
                stream_.fail(fmt::format("part {} has the corner {} in '{}'", part.number, corner, section.name),
                             fmt::format("1 to {}, the number of its points", points));
            --corner;
        }
        if (!section.kept) {
            section.corners = section.sizes = section.ofFaces = {};
            return;
        }
        const std::size_t nodes = section.element->nodes, corners = section.element->corners;
        if (nodes == corners) return;
        for (std::size_t i = 0; i < section.count; ++i)
            std::copy_n(section.corners.begin() + std::ptrdiff_t(i * nodes), corners,
                        section.corners.begin() + std::ptrdiff_t(i * corners));
        section.corners.resize(section.count * corners);
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
    return std::any_of(sections.begin(), sections.end(), [](const EnSightSection& section) {
        return section.kept && section.count > 0 && section.element->dimension == 3;
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
