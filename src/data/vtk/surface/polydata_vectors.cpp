#include "data/vtk/surface/polydata_vectors.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "data/vtk/joined_arrays.h"

namespace aeolic {

vtkSmartPointer<vtkPolyData> withVectors(vtkPolyData& input, SurfaceArrays& wanted, const std::string& where)
{
    const std::vector<ArrayInfo> there = withJoined(arraysOf(input));
    std::vector<ArrayInfo> made;
    std::optional<ArrayInfo> vectors;
    if (wanted.wantVectors) vectors = chooseVectors(there, wanted.vectors, where);
    if (vectors) made.push_back(*vectors);
    if (const auto scalar = wanted.colorBy.empty() ? std::nullopt : findScalar(there, wanted.colorBy, where))
        made.push_back(scalar->array);
    if (std::none_of(made.begin(), made.end(), [&](const ArrayInfo& array) {
            return !array.of.empty() || (vectors && array.name == vectors->name && array.components == 2);
        }))
        return &input;
    auto output = vtkSmartPointer<vtkPolyData>::New();
    output->ShallowCopy(&input);
    makeVectors(*output, made, vectors ? &*vectors : nullptr, where);
    if (vectors && !vectors->of.empty()) wanted.vectors = vectors->name;
    return output;
}

}  // namespace aeolic
