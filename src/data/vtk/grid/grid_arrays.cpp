#include "data/vtk/grid/grid_arrays.h"

#include <algorithm>

#include "aeolic/error.h"

namespace aeolic {
namespace {

bool same(const ArrayInfo& a, const ArrayInfo& b)
{
    return a.name == b.name && a.onPoints == b.onPoints;
}

}  // namespace

std::vector<ArrayInfo> GridArrays::all() const
{
    std::vector<ArrayInfo> all{vectors};
    for (const auto& choice : {scalar, contour})
        if (choice && std::none_of(all.begin(), all.end(), [&](const ArrayInfo& a) { return same(a, choice->array); }))
            all.push_back(choice->array);
    return all;
}

bool GridArrays::scalarIsVectorLength() const
{
    return scalar && scalar->magnitude && same(scalar->array, vectors);
}

GridArrays chooseArrays(const std::vector<ArrayInfo>& available, const GridRequest& request, const std::string& path)
{
    GridArrays chosen;
    chosen.vectors = chooseVectors(available, request.vectors, path);
    if (!request.colorBy.empty()) chosen.scalar = findScalar(available, request.colorBy, path);
    if (request.contour.empty()) return chosen;
    chosen.contour = findScalar(available, request.contour, path);
    if (!chosen.contour)
        throw InputError(path, "no array '" + request.contour + "' for the isosurface",
                         oneOf(available, request.contour));
    return chosen;
}

void requirePoints(const std::vector<ArrayInfo>& arrays, const std::string& path)
{
    for (const ArrayInfo& array : arrays)
        if (!array.onPoints)
            throw InputError(path, "array '" + array.name + "' is on the cells", "one on the points, or --bricks off");
}

}  // namespace aeolic
