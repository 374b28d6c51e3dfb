#include "reader/exodus/exodus_blocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

namespace aeolic {
namespace {

using Wholes = std::vector<std::int64_t>;

std::string numbered(const char* name, std::size_t number)
{
    return name + std::to_string(number);
}

/// Names and numbers of all blocks or sets. The file may say neither.
struct Labels {
    std::vector<std::string> names;
    Wholes ids;

    Labels(const NetcdfFile& file, const char* namesVariable, const char* idsVariable)
    {
        if (file.has(namesVariable)) names = file.texts(namesVariable);
        if (file.has(idsVariable)) ids = file.read<std::int64_t>(idsVariable);
    }

    void give(std::size_t i, const char* kind, std::string& name, std::vector<std::string>& groups) const
    {
        const std::string byId = kind + std::to_string(i < ids.size() ? ids[i] : std::int64_t(i + 1));
        name = i < names.size() && !names[i].empty() ? names[i] : byId;
        if (name != byId) groups.push_back(byId);
    }
};

/// By the first letters of the element's name and, of shells, by its nodes.
std::optional<CellShape> shapeOf(std::string type, std::uint64_t nodes)
{
    for (char& c : type)
        if (c >= 'a' && c <= 'z') c = char(c - 'a' + 'A');
    const auto is = [&](const char* begin) { return type.starts_with(begin); };
    if (is("NSIDED")) return CellShape::polygon;
    if (is("NFACED")) return CellShape::polyhedron;
    if (is("HEX")) return CellShape::hexahedron;
    if (is("TET")) return CellShape::tetra;
    if (is("PYR")) return CellShape::pyramid;
    if (is("WED") || is("PENTA") || is("PRI")) return CellShape::wedge;
    if (is("TRI")) return CellShape::triangle;
    if (is("QUA")) return CellShape::quad;
    if (is("SHE")) return nodes == 3 || nodes == 6 || nodes == 7 ? CellShape::triangle : CellShape::quad;
    return std::nullopt;
}

std::vector<std::uint64_t> connectivityShape(const NetcdfFile& file, const ExodusBlock& block)
{
    const std::string name = numbered("connect", block.number);
    return file.has(name) ? file.shape(name) : std::vector<std::uint64_t>();
}

/// Cells of the numbers of corners that stand beside them, as the file counts both from 1.
void requireCorners(const NetcdfFile& file, const std::string& variable, Wholes& corners, std::size_t most,
                    const char* what)
{
    for (std::int64_t& corner : corners) {
        if (corner < 1 || std::uint64_t(corner) > most)
            file.fail(fmt::format("'{}' has the {} {}", variable, what, corner), fmt::format("1 to {}", most));
        --corner;
    }
}

Wholes readSizes(const NetcdfFile& file, const std::string& variable, std::size_t count, std::size_t total)
{
    Wholes sizes = file.read<std::int64_t>(variable);
    std::size_t sum = 0;
    for (const std::int64_t size : sizes) {
        if (size < 1) file.fail(fmt::format("'{}' has the size {}", variable, size), "sizes from 1 on");
        sum += std::size_t(size);
    }
    if (sizes.size() != count || sum != total)
        file.fail(fmt::format("'{}' has {} sizes of {} in all", variable, sizes.size(), sum),
                  fmt::format("{} of {}", count, total));
    return sizes;
}

/// All faces of the file's face blocks, one after the other.
FaceList readFaces(const NetcdfFile& file, std::size_t points)
{
    FaceList faces;
    const std::size_t blocks = file.dimension("num_fa_blk").value_or(0);
    for (std::size_t block = 1; block <= blocks; ++block) {
        const std::string name = numbered("fbconn", block), sizesName = numbered("fbepecnt", block);
        Wholes corners = file.read<std::int64_t>(name);
        requireCorners(file, name, corners, points, "corner");
        const std::uint64_t count = file.dimension(numbered("num_fa_in_blk", block)).value_or(0);
        const Wholes sizes = readSizes(file, sizesName, count, corners.size());
        std::size_t at = 0;
        for (const std::int64_t size : sizes) {
            faces.add(std::span(corners).subspan(at, std::size_t(size)));
            at += std::size_t(size);
        }
    }
    return faces;
}

PartCells readPolyhedra(const NetcdfFile& file, const ExodusBlock& block, std::size_t points)
{
    const FaceList faces = readFaces(file, points);
    const std::string name = numbered("facconn", block.number);
    Wholes numbers = file.read<std::int64_t>(name);
    requireCorners(file, name, numbers, faces.count(), "face");
    PartCells cells{CellShape::polyhedron, block.count, {}, {}, {}};
    cells.sizes = readSizes(file, numbered("ebepecnt", block.number), block.count, numbers.size());
    std::vector<std::uint8_t> uses(faces.count(), 0);
    for (const std::int64_t number : numbers) {
        const auto face = faces.face(std::size_t(number));
        if (++uses[std::size_t(number)] > 2 || face.size() < 3)
            file.fail(fmt::format("'{}' has the face {} {}", name, number + 1,
                                  face.size() < 3 ? "of two corners" : "three times"),
                      "polygons between two cells");
        cells.ofFaces.push_back(std::int64_t(face.size()));
        cells.corners.insert(cells.corners.end(), face.begin(), face.end());
    }
    return cells;
}

PartCells readPolygons(const NetcdfFile& file, const ExodusBlock& block, std::size_t points)
{
    const std::string name = numbered("connect", block.number), sizesName = numbered("ebepecnt", block.number);
    PartCells cells{CellShape::polygon, block.count, file.read<std::int64_t>(name), {}, {}};
    requireCorners(file, name, cells.corners, points, "corner");
    cells.sizes = readSizes(file, sizesName, block.count, cells.corners.size());
    if (!sizesFit(cells)) file.fail(fmt::format("'{}' has polygons of two corners", sizesName), "three or more");
    return cells;
}

/// The sides of an element in the order of their numbers, seen from outside ("EXODUS II: A Finite Element Data Model",
/// section 4.8); -1 ends a side of three. Shells have two: their front and their back.
using Side = std::array<int, 4>;
std::span<const Side> sidesOf(CellShape shape)
{
    static constexpr Side tetra[] = {{0, 1, 3, -1}, {1, 2, 3, -1}, {0, 3, 2, -1}, {0, 2, 1, -1}};
    static constexpr Side pyramid[] = {{0, 1, 4, -1}, {1, 2, 4, -1}, {2, 3, 4, -1}, {0, 4, 3, -1}, {0, 3, 2, 1}};
    static constexpr Side wedge[] = {{0, 1, 4, 3}, {1, 2, 5, 4}, {0, 3, 5, 2}, {0, 2, 1, -1}, {3, 4, 5, -1}};
    static constexpr Side hexahedron[] = {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6},
                                          {0, 4, 7, 3}, {0, 3, 2, 1}, {4, 5, 6, 7}};
    static constexpr Side triangle[] = {{0, 1, 2, -1}, {2, 1, 0, -1}};
    static constexpr Side quad[] = {{0, 1, 2, 3}, {0, 3, 2, 1}};
    static constexpr std::span<const Side> all[] = {triangle, quad, {}, tetra, pyramid, wedge, hexahedron, {}};
    return all[std::size_t(shape)];
}

/// A cell of any shape by its number, for sides.
class BlockSides {
public:
    explicit BlockSides(PartCells cells) : cells_(std::move(cells))
    {
        if (cells_.shape != CellShape::polyhedron) return;
        std::size_t face = 0, corner = 0;
        for (const std::int64_t size : cells_.sizes) {
            firstFaces_.push_back(face);
            face += std::size_t(size);
        }
        for (const std::int64_t size : cells_.ofFaces) {
            firstCorners_.push_back(corner);
            corner += std::size_t(size);
        }
    }

    /// Empty where the side, from 0, is no face.
    Wholes side(std::size_t cell, std::size_t number) const
    {
        if (cells_.shape == CellShape::polyhedron) {
            if (number >= std::size_t(cells_.sizes[cell])) return {};
            const std::size_t face = firstFaces_[cell] + number;
            const auto begin = cells_.corners.begin() + std::ptrdiff_t(firstCorners_[face]);
            return {begin, begin + std::ptrdiff_t(cells_.ofFaces[face])};
        }
        const auto sides = sidesOf(cells_.shape);
        if (number >= sides.size()) return {};
        Wholes corners;
        for (const int corner : sides[number])
            if (corner >= 0) corners.push_back(cells_.corners[cell * cornersOf(cells_.shape) + std::size_t(corner)]);
        return corners;
    }

private:
    PartCells cells_;
    std::vector<std::size_t> firstFaces_, firstCorners_;  // Of a polyhedron's faces, of a face's corners.
};

}  // namespace

std::vector<ExodusBlock> readExodusBlocks(const NetcdfFile& file)
{
    const Labels labels(file, "eb_names", "eb_prop1");
    std::vector<ExodusBlock> blocks(file.dimension("num_el_blk").value_or(0));
    std::int64_t first = 1;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        ExodusBlock& block = blocks[i];
        block.number = i + 1;
        labels.give(i, "block_", block.name, block.groups);
        block.count = file.dimension(numbered("num_el_in_blk", i + 1)).value_or(0);
        block.first = first;
        first += std::int64_t(block.count);
        const std::string nodes = numbered("connect", i + 1), faces = numbered("facconn", i + 1);
        for (const std::string& variable : {nodes, faces})
            if (block.type.empty() && file.has(variable)) block.type = file.text(variable, "elem_type").value_or("");
        const auto shape = connectivityShape(file, block);
        if (block.count > 0) block.shape = shapeOf(block.type, shape.size() == 2 ? shape[1] : 0);
    }
    return blocks;
}

std::vector<ExodusSideSet> readExodusSideSets(const NetcdfFile& file)
{
    const Labels labels(file, "ss_names", "ss_prop1");
    std::vector<ExodusSideSet> sets(file.dimension("num_side_sets").value_or(0));
    for (std::size_t i = 0; i < sets.size(); ++i) {
        sets[i].number = i + 1;
        labels.give(i, "sideset_", sets[i].name, sets[i].groups);
    }
    return sets;
}

PartCells readExodusCells(const NetcdfFile& file, const ExodusBlock& block, std::size_t points)
{
    if (block.shape == CellShape::polyhedron) return readPolyhedra(file, block, points);
    if (block.shape == CellShape::polygon) return readPolygons(file, block, points);
    const std::string name = numbered("connect", block.number);
    const auto shape = connectivityShape(file, block);
    const std::size_t corners = block.shape ? cornersOf(*block.shape) : 0;
    if (corners == 0 || shape.size() != 2 || shape[0] != block.count || shape[1] < corners)
        file.fail(fmt::format("'{}' of {} elements has {} numbers", name, block.type, fmt::join(shape, " x ")),
                  fmt::format("{} x {} or more", block.count, corners));
    PartCells cells{*block.shape, block.count, file.read<std::int64_t>(name, {{0, 0}, {block.count, corners}}), {}, {}};
    requireCorners(file, name, cells.corners, points, "corner");
    return cells;
}

ExodusSides readExodusSides(const NetcdfFile& file, const ExodusSideSet& set, const std::vector<ExodusBlock>& blocks,
                            std::size_t points)
{
    const std::string elementsName = numbered("elem_ss", set.number), sidesName = numbered("side_ss", set.number);
    ExodusSides found;
    if (!file.has(elementsName)) return found;  // A set may be empty.
    const Wholes elements = file.read<std::int64_t>(elementsName), sides = file.read<std::int64_t>(sidesName);
    if (elements.size() != sides.size())
        file.fail(fmt::format("'{}' has {} numbers", sidesName, sides.size()), fmt::format("{}", elements.size()));
    std::map<std::size_t, BlockSides> known;
    const std::int64_t last = blocks.empty() ? 0 : blocks.back().first + std::int64_t(blocks.back().count) - 1;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        if (elements[i] < 1 || elements[i] > last)
            file.fail(fmt::format("'{}' has the element {}", elementsName, elements[i]), fmt::format("1 to {}", last));
        // The last block that begins no later, so that empty ones are passed over.
        const auto behind =
            std::upper_bound(blocks.begin(), blocks.end(), elements[i],
                             [](std::int64_t number, const ExodusBlock& block) { return number < block.first; });
        const auto at = std::size_t(behind - blocks.begin()) - 1;
        if (!blocks[at].shape) continue;
        if (!known.contains(at)) known.emplace(at, BlockSides(readExodusCells(file, blocks[at], points)));
        const auto cell = std::size_t(elements[i] - blocks[at].first);
        if (sides[i] < 1) file.fail(fmt::format("'{}' has the side {}", sidesName, sides[i]), "sides from 1 on");
        const Wholes corners = known.at(at).side(cell, std::size_t(sides[i] - 1));
        if (corners.empty()) continue;
        found.faces.add(corners);
        found.blocks.push_back(at);
        found.cells.push_back(cell);
        found.places.push_back(i);
    }
    return found;
}

}  // namespace aeolic
