#include "reader/parts/part_source.h"

#include <algorithm>
#include <numeric>

#include "data/part_choice.h"

namespace aeolic {

namespace {

/// Whether there are `sum` in all, and at least so many in each.
bool sumUp(const std::vector<std::int64_t>& sizes, std::int64_t least, std::size_t sum)
{
    return std::all_of(sizes.begin(), sizes.end(), [&](std::int64_t size) { return size >= least; }) &&
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

std::size_t PartMesh::cellCount() const
{
    std::size_t sum = 0;
    for (const PartCells& each : cells) sum += each.count;
    return sum;
}

std::vector<std::size_t> chosenParts(const std::vector<PartInfo>& parts, const std::vector<std::string>& wanted,
                                     FileUse use, const std::string& where)
{
    if (!wanted.empty()) {
        std::vector<PartName> names;
        names.reserve(parts.size());
        for (const PartInfo& part : parts) names.push_back({part.name, part.groups});
        return chooseParts(names, wanted, where);
    }
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
