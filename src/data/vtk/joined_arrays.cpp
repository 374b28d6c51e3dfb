#include "data/vtk/joined_arrays.h"

#include <vtkFloatArray.h>

#include <algorithm>
#include <array>

#include "aeolic/error.h"
#include "base/parallel.h"
#include "data/vector_names.h"

namespace aeolic {
namespace {

void addJoined(std::vector<ArrayInfo>& arrays, bool onPoints, bool flat)
{
    std::vector<std::string> names;
    for (const ArrayInfo& array : arrays)
        if (array.onPoints == onPoints && array.components == 1 && !isMaskName(array.name)) names.push_back(array.name);
    const auto isTaken = [&](const std::string& name) {
        return std::any_of(arrays.begin(), arrays.end(),
                           [&](const ArrayInfo& a) { return a.onPoints == onPoints && a.name == name; });
    };
    std::vector<ArrayInfo> joined;
    for (const NamedComponents& each : joinComponents(names, flat, true)) {
        if (each.of.size() < 2 || isTaken(each.name)) continue;
        ArrayInfo& array = joined.emplace_back();
        array.name = each.name;
        array.onPoints = onPoints;
        array.components = int(each.of.size());
        array.vtkType = VTK_FLOAT;
        for (const std::size_t i : each.of) array.of.push_back(names[i]);
    }
    arrays.insert(arrays.end(), joined.begin(), joined.end());
}

/// A component of an array; a null one is zero everywhere.
struct SourceComponent {
    vtkDataArray* array = nullptr;
    int number = 0;
};

vtkSmartPointer<vtkFloatArray> joinedOf(const std::array<SourceComponent, 3>& components, const std::string& name,
                                        vtkIdType tuples)
{
    auto values = vtkSmartPointer<vtkFloatArray>::New();
    values->SetName(name.c_str());
    values->SetNumberOfComponents(3);
    values->SetNumberOfTuples(tuples);
    float* target = values->GetPointer(0);
    for (std::size_t c = 0; c < 3; ++c) {
        const auto floats = components[c].array ? toFloats(components[c].array) : nullptr;
        const float* source = floats ? floats->GetPointer(0) + components[c].number : nullptr;
        const std::size_t step = floats ? std::size_t(floats->GetNumberOfComponents()) : 0;
        parallelRanges(std::size_t(tuples), std::size_t{1} << 15, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) target[3 * i + c] = source ? source[i * step] : 0.0f;
        });
    }
    return values;
}

/// What an array's components are in the data; nothing where one is not there.
std::vector<SourceComponent> componentsIn(const ArrayInfo& array, vtkDataSet& data)
{
    const vtkIdType tuples = array.onPoints ? data.GetNumberOfPoints() : data.GetNumberOfCells();
    std::vector<SourceComponent> components;
    for (int c = 0; c < array.components; ++c) {
        const bool isOne = array.of.empty();
        vtkDataArray* source = findArray(data, isOne ? array.name : array.of[std::size_t(c)], array.onPoints);
        if (!source || source->GetNumberOfTuples() != tuples ||
            source->GetNumberOfComponents() != (isOne ? array.components : 1))
            return {};
        components.push_back({source, isOne ? c : 0});
    }
    return components;
}

}  // namespace

std::vector<ArrayInfo> withJoined(std::vector<ArrayInfo> arrays)
{
    for (const bool onPoints : {true, false}) addJoined(arrays, onPoints, false);
    const auto isVector = [](const ArrayInfo& array) { return array.components == 3 && array.name != "Normals"; };
    if (std::none_of(arrays.begin(), arrays.end(), isVector))
        for (const bool onPoints : {true, false}) addJoined(arrays, onPoints, true);
    return arrays;
}

std::vector<ArrayInfo> arraysToRead(const std::vector<ArrayInfo>& arrays)
{
    std::vector<ArrayInfo> all;
    for (const ArrayInfo& array : arrays) {
        if (array.of.empty()) all.push_back(array);
        for (const std::string& name : array.of) {
            ArrayInfo& one = all.emplace_back();
            one.name = name;
            one.onPoints = array.onPoints;
        }
    }
    return all;
}

std::optional<int> flatAxisOf(vtkDataSet& data)
{
    double b[6];
    data.GetBounds(b);
    const std::array<double, 3> size{b[1] - b[0], b[3] - b[2], b[5] - b[4]};
    const double longest = *std::max_element(size.begin(), size.end());
    for (const int axis : {2, 1, 0})
        if (size[std::size_t(axis)] <= 1e-9 * longest) return axis;
    return std::nullopt;
}

void makeVectors(vtkDataSet& data, const std::vector<ArrayInfo>& arrays, const ArrayInfo* vectors,
                 const std::string& path)
{
    for (const ArrayInfo& array : arrays) {
        const bool areVectors = vectors && sameArray(array, *vectors);
        if (array.of.empty() && !(areVectors && array.components == 2)) continue;
        const std::vector<SourceComponent> found = componentsIn(array, data);
        if (found.empty()) continue;
        std::array<SourceComponent, 3> components;
        if (found.size() == 3) {
            std::copy(found.begin(), found.end(), components.begin());
        } else {
            const auto across = flatAxisOf(data);
            if (!across)
                throw InputError(path, "array '" + array.name + "' has 2 components",
                                 "3 for vectors; two are enough in flat data");
            components[*across == 0 ? 1 : 0] = found[0];
            components[*across == 2 ? 1 : 2] = found[1];
        }
        attributesOf(data, array.onPoints)
            ->AddArray(joinedOf(components, array.name, found.front().array->GetNumberOfTuples()));
    }
}

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
