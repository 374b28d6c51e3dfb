#include "reader/parts/part_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "data/part_choice.h"

namespace aeolic {

namespace {

/// Whether there are `sum` in all, and at least so many in each.
bool sumUp(const std::vector<std::int64_t>& sizes, std::int64_t least, std::size_t sum)
{
    return std::ranges::all_of(sizes, [&](std::int64_t size) { return size >= least; }) &&
           std::accumulate(sizes.begin(), sizes.end(), std::int64_t{0}) == std::int64_t(sum);
}

}  // namespace

bool sizesFit(const PartCells& cells)
{
    const std::size_t fixed = cornersOf(cells.shape), corners = cells.corners.size();
    if (fixed > 0) return corners / fixed == cells.count && corners % fixed == 0;
    if (cells.sizes.size() != cells.count) return false;
    if (cells.shape == CellShape::polygon) return sumUp(cells.sizes, 3, corners);
    return sumUp(cells.sizes, 1, cells.ofFaces.size()) && sumUp(cells.ofFaces, 3, corners);
}

PartValues joinedValues(const std::vector<std::vector<float>>& components, const std::vector<std::string>& names,
                        const std::function<void(const std::string&, const std::string&)>& fail)
{
    std::size_t count = 0;
    for (const auto& each : components) count = std::max(count, each.size());
    if (count == 0) return nullptr;
    const std::size_t width = components.size() > 1 ? 3 : 1;
    auto values = std::make_shared<std::vector<float>>(count * width, 0.0F);
    for (std::size_t c = 0; c < components.size(); ++c) {
        const std::size_t own = components[c].size();
        if (own > 0 && own != count) fail(fmt::format("'{}' has {} values", names[c], own), fmt::format("{}", count));
        for (std::size_t i = 0; i < count; ++i) (*values)[i * width + c] = own > 0 ? components[c][i] : kMissing;
    }
    return values;
}

PartCells orderedCells(std::span<const std::int64_t> lengths)
{
    std::vector<std::int64_t> cells, steps;  // Of the directions in which there are cells.
    std::int64_t step = 1;
    for (const std::int64_t length : lengths) {
        if (length > 1) {
            cells.push_back(length - 1);
            steps.push_back(step);
        }
        step *= length;
    }
    PartCells all{cells.size() == 3 ? CellShape::hexahedron : CellShape::quad, 0, {}, {}, {}};
    if (cells.size() < 2) return all;
    cells.resize(3, 1);
    steps.resize(3, 0);
    all.count = std::size_t(cells[0] * cells[1] * cells[2]);
    all.corners.reserve(all.count * cornersOf(all.shape));
    const auto addRing = [&](std::int64_t at) {
        for (const std::int64_t corner : {at, at + steps[0], at + steps[0] + steps[1], at + steps[1]})
            all.corners.push_back(corner);
    };
    for (std::int64_t k = 0; k < cells[2]; ++k)
        for (std::int64_t j = 0; j < cells[1]; ++j)
            for (std::int64_t i = 0; i < cells[0]; ++i) {
                const std::int64_t at = i * steps[0] + j * steps[1] + k * steps[2];
                addRing(at);
                if (all.shape == CellShape::hexahedron) addRing(at + steps[2]);
            }
    return all;
}

std::size_t PartMesh::cellCount() const
{
    std::size_t sum = 0;
    for (const PartCells& each : cells) sum += each.count;
    return sum;
}

std::vector<std::size_t> chosenParts(const std::vector<PartInfo>& parts, const std::vector<std::string>& wanted,
                                     FileUse use, const std::string& where)
{
    if (!wanted.empty()) return chooseParts(parts, wanted, where);
    const auto isUsual = [&](const PartInfo& part) {
        return use == FileUse::field ? part.dimension == 3 : part.dimension == 2 && part.usual;
    };
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < parts.size() && use != FileUse::any; ++i)
        if (isUsual(parts[i])) chosen.push_back(i);
    if (!chosen.empty()) return chosen;
    chosen.resize(parts.size());
    std::iota(chosen.begin(), chosen.end(), std::size_t{0});
    return chosen;
}

}  // namespace aeolic
