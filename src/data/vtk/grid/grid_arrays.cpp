#include "data/vtk/grid/grid_arrays.h"

#include <algorithm>

#include "aeolic/error.h"

namespace aeolic {
namespace {

/// Arrays on cells are brought to the points under their names.
void requireDifferentNames(const std::vector<ArrayInfo>& arrays, const std::string& path)
{
    for (const ArrayInfo& a : arrays)
        for (const ArrayInfo& b : arrays)
            if (a.name == b.name && a.onPoints && !b.onPoints)
                throw InputError(path, "found array '" + a.name + "' on points and on cells at once", "one of them");
}

}  // namespace

std::vector<ArrayInfo> GridArrays::all() const
{
    std::vector<ArrayInfo> all{vectors};
    const auto add = [&](const ArrayInfo& array) {
        if (!findInfo(all, array.name, array.onPoints)) all.push_back(array);
    };
    if (scalar) add(scalar->array);
    for (const auto& [name, choice] : contours) add(choice.array);
    return all;
}

ArrayPart GridArrays::partOfVectors() const
{
    if (!scalar || !sameArray(scalar->array, vectors)) return ArrayPart::whole;
    return scalar->part == ArrayPart::length || needsNormal(scalar->part) ? scalar->part : ArrayPart::whole;
}

GridArrays chooseArrays(const std::vector<ArrayInfo>& available, const GridRequest& request, const std::string& path)
{
    GridArrays chosen;
    chosen.vectors = chooseVectors(available, request.vectors, path);
    if (!request.colorBy.empty()) chosen.scalar = findScalar(available, request.colorBy, path);
    if (chosen.scalar) requireOfVectors(*chosen.scalar, &chosen.vectors, path);
    for (const std::string& contour : request.contours) {
        const std::optional<ScalarChoice> choice = findScalar(available, contour, path);
        if (!choice) throw InputError(path, "no array '" + contour + "' for the isosurface", oneOf(available, contour));
        requireOfVectors(*choice, nullptr, path);
        chosen.contours.insert_or_assign(contour, *choice);
    }
    requireDifferentNames(chosen.all(), path);
    return chosen;
}

void requirePoints(const std::vector<ArrayInfo>& arrays, const std::string& path)
{
    for (const ArrayInfo& array : arrays)
        if (!array.onPoints)
            throw InputError(path, "array '" + array.name + "' is on the cells", "one on the points, or --bricks off");
}

}  // namespace aeolic
