#include "data/vtk/arrays.h"

#include <fmt/format.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>
#include <type_traits>

#include "aeolic/error.h"
#include "base/half.h"
#include "base/parallel.h"

namespace aeolic {

namespace {

constexpr std::size_t grain = std::size_t{1} << 15;

/// The array of that whole name, else of the name behind point: or cell:.
const ArrayInfo* findNamed(const std::vector<ArrayInfo>& arrays, const std::string& text)
{
    for (const bool onPoints : {true, false})
        if (const ArrayInfo* whole = findInfo(arrays, text, onPoints)) return whole;
    const ArrayRef ref = parseArray(text);
    if (!ref.onPoints || ref.part != ArrayPart::whole) return nullptr;
    return findInfo(arrays, ref.name, *ref.onPoints);
}

enum class VectorKind { none, floats, wholeNumbers, joined, flat };

/// What vectors an array may be, of which nobody has said that it is one. Bytes are colours.
VectorKind kindOf(const ArrayInfo& array)
{
    const bool isFloat = array.vtkType == VTK_FLOAT || array.vtkType == VTK_DOUBLE;
    const bool isByte =
        array.vtkType == VTK_CHAR || array.vtkType == VTK_SIGNED_CHAR || array.vtkType == VTK_UNSIGNED_CHAR;
    if (array.activeNormals || isByte || isMaskName(array.name)) return VectorKind::none;
    for (const char* other : {"Normals", "TCoords", "TextureCoords", "TextureCoordinates", "Texture Coordinates"})
        if (array.name == other) return VectorKind::none;
    if (array.components == 2) return isFloat ? VectorKind::flat : VectorKind::none;
    if (array.components != 3) return VectorKind::none;
    return !array.of.empty() ? VectorKind::joined : isFloat ? VectorKind::floats : VectorKind::wholeNumbers;
}

std::string componentText(int components)
{
    return components == 1 ? "1 component" : fmt::format("{} components", components);
}

/// Which tuples the data set itself declares void: resampling's valid-point mask, and hidden ghosts.
class Hidden {
public:
    Hidden(vtkDataSet& data, bool onPoints)
    {
        const char* maskName = onPoints ? "vtkValidPointMask" : "vtkValidCellMask";
        vtkDataArray* mask = attributesOf(data, onPoints)->GetArray(maskName);
        if (mask && mask->GetNumberOfComponents() == 1) {
            valid_ = vtkSmartPointer<vtkUnsignedCharArray>::New();
            valid_->DeepCopy(mask);
        }
        ghosts_ = vtkUnsignedCharArray::SafeDownCast(
            attributesOf(data, onPoints)->GetArray(vtkDataSetAttributes::GhostArrayName()));
        hiddenBit_ = onPoints ? int(vtkDataSetAttributes::HIDDENPOINT) : int(vtkDataSetAttributes::HIDDENCELL);
    }
    bool any() const { return valid_ || ghosts_; }
    bool operator()(vtkIdType i) const
    {
        return (valid_ && valid_->GetValue(i) == 0) || (ghosts_ && (ghosts_->GetValue(i) & hiddenBit_));
    }

private:
    vtkSmartPointer<vtkUnsignedCharArray> valid_;
    vtkUnsignedCharArray* ghosts_ = nullptr;
    unsigned char hiddenBit_ = 0;
};

double squaredLength(const float* tuple, int components)
{
    double sum = 0;  // A float's square never overflows a double, so an infinite sum means an infinite component.
    for (int c = 0; c < components; ++c) sum += double(tuple[c]) * double(tuple[c]);
    return sum;
}

/// Floats that are masked are written to, const ones only counted.
template <int Components, class Float>
MaskResult maskRange(Float* values, std::size_t begin, std::size_t end, int components, const Hidden* hidden,
                     const CountedSamples* counted)
{
    const int count = Components > 0 ? Components : components;
    MaskResult result;
    double maxSquared = 0;
    for (std::size_t i = begin; i < end; ++i) {
        Float* tuple = values + i * std::size_t(count);
        const double squared = squaredLength(tuple, count);
        const bool isHidden = hidden && (*hidden)(vtkIdType(i));
        if (!isHidden && squared < std::numeric_limits<double>::infinity()) {
            maxSquared = std::max(maxSquared, squared);
            continue;
        }
        if (!counted || (*counted)(std::int64_t(i))) ++(isHidden ? result.masked : result.nonFinite);
        if constexpr (!std::is_const_v<Float>) std::fill_n(tuple, count, std::numeric_limits<float>::quiet_NaN());
    }
    result.maxMagnitude = std::sqrt(maxSquared);
    return result;
}

template <class Float>
MaskResult maskAll(Float* values, const vtkFloatArray& array, vtkDataSet& data, bool onPoints,
                   const CountedSamples* counted)
{
    const Hidden hidden(data, onPoints);
    const int components = array.GetNumberOfComponents();
    MaskResult total;
    std::mutex totalMutex;
    parallelRanges(std::size_t(array.GetNumberOfTuples()), grain, [&](std::size_t begin, std::size_t end) {
        const Hidden* some = hidden.any() ? &hidden : nullptr;
        const MaskResult part = components == 3 ? maskRange<3>(values, begin, end, 3, some, counted)
                                                : maskRange<0>(values, begin, end, components, some, counted);
        const std::lock_guard lock(totalMutex);  // Sums and maxima: the order does not matter.
        total.add(part);
    });
    total.all = counted ? counted->count() : array.GetNumberOfTuples();
    return total;
}

template <class Source>
void convert(const Source* source, float* target, std::size_t count)
{
    parallelRanges(count, grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) target[i] = static_cast<float>(source[i]);
    });
}

}  // namespace

const ArrayInfo* findInfo(const std::vector<ArrayInfo>& arrays, const std::string& name, bool onPoints)
{
    for (const ArrayInfo& array : arrays)
        if (array.onPoints == onPoints && array.name == name) return &array;
    return nullptr;
}

vtkDataSetAttributes* attributesOf(vtkDataSet& data, bool onPoints)
{
    return data.GetAttributes(onPoints ? vtkDataObject::POINT : vtkDataObject::CELL);
}

void takeTuples(vtkDataSetAttributes& all, vtkIdList& ids, vtkDataSetAttributes& some)
{
    some.CopyAllOn();
    some.CopyAllocate(&all, ids.GetNumberOfIds());
    if (ids.GetNumberOfIds() == 0) return;
    vtkNew<vtkIdList> places;
    places->SetNumberOfIds(ids.GetNumberOfIds());
    std::iota(places->begin(), places->end(), vtkIdType(0));
    some.CopyData(&all, &ids, places);
}

std::vector<ArrayInfo> arraysOf(vtkDataSet& data)
{
    std::vector<ArrayInfo> arrays;
    for (const bool onPoints : {true, false}) {
        vtkDataSetAttributes* all = attributesOf(data, onPoints);
        for (int i = 0; i < all->GetNumberOfArrays(); ++i) {
            vtkDataArray* array = all->GetArray(i);  // Null for strings.
            if (!array || !array->GetName()) continue;
            arrays.push_back({array->GetName(), onPoints, array->GetNumberOfComponents(), array->GetDataType(),
                              array == all->GetVectors(), array == all->GetNormals()});
        }
    }
    return arrays;
}

std::string listArrays(const std::vector<ArrayInfo>& arrays)
{
    std::string text;
    for (const ArrayInfo& array : arrays)
        if (!isMaskName(array.name))
            text += fmt::format("{}{} ({}, {})", text.empty() ? "" : ", ", array.name,
                                array.onPoints ? "points" : "cells", componentText(array.components));
    return text.empty() ? "none" : text;
}

std::string oneOf(const std::vector<ArrayInfo>& arrays, const std::string& typed)
{
    return "one of: " + listArrays(arrays) + nearestArray(typed, offeredArrays(arrays));
}

ArrayChoices offeredArrays(const std::vector<ArrayInfo>& arrays)
{
    ArrayChoices offered;
    for (const ArrayInfo& array : arrays) {
        const auto same = [&](const ArrayChoice& known) { return known.name == array.name; };
        if (!isMaskName(array.name) && std::none_of(offered.begin(), offered.end(), same))
            offered.push_back({array.name, array.components});
    }
    return offered;
}

const ArrayInfo& chooseVectors(const std::vector<ArrayInfo>& arrays, const std::string& name, const std::string& where)
{
    if (!name.empty()) {
        const ArrayInfo* named = findNamed(arrays, name);
        if (!named) throw InputError(where, "no array '" + name + "'", oneOf(arrays, name));
        if (named->components != 3 && named->components != 2)
            throw InputError(where, fmt::format("array '{}' has {}", name, componentText(named->components)),
                             "3 for vectors; there are: " + listArrays(arrays));
        return *named;
    }
    for (const bool onPoints : {true, false})
        for (const ArrayInfo& array : arrays)
            if (array.activeVectors && array.onPoints == onPoints && array.components == 3) return array;

    for (const VectorKind kind : {VectorKind::floats, VectorKind::wholeNumbers, VectorKind::joined, VectorKind::flat}) {
        std::vector<const ArrayInfo*> candidates;
        for (const ArrayInfo& array : arrays)
            if (kindOf(array) == kind) candidates.push_back(&array);
        if (candidates.size() == 1) return *candidates.front();
        if (!candidates.empty())
            throw InputError(where, "several arrays of vectors and none is active",
                             "--vectors with one of: " + listArrays(arrays));
    }
    throw InputError(where, "no array of vectors", "an array of 3 components; there are: " + listArrays(arrays));
}

std::optional<ScalarChoice> findScalar(const std::vector<ArrayInfo>& arrays, const std::string& spec,
                                       const std::string& where)
{
    if (const ArrayInfo* array = findNamed(arrays, spec)) {  // First as it is: names like "thermo:mag" exist.
        if (array->components == 1) return ScalarChoice{*array};
        throw InputError(where, fmt::format("array '{}' has {}", spec, componentText(array->components)),
                         array->components > 3 ? "1 to colour or contour by, or " + spec + ":mag"
                                               : fmt::format("1 to colour or contour by, or {0}:mag, {0}:x …", spec));
    }
    const ArrayPart part = parseArray(spec).part;
    if (part == ArrayPart::whole) return std::nullopt;
    const ArrayInfo* array = findNamed(arrays, spec.substr(0, spec.size() - suffixOf(part).size()));
    if (!array) return std::nullopt;
    const auto component = componentOf(part);
    const bool ofVectors = component || needsNormal(part);
    if (ofVectors && (array->components < 2 || array->components > 3 || component.value_or(0) >= array->components))
        throw InputError(where, fmt::format("array '{}' has {}", array->name, componentText(array->components)),
                         fmt::format("vectors, for '{}'", spec));
    return ScalarChoice{*array, part};
}

bool sameArray(const ArrayInfo& a, const ArrayInfo& b)
{
    return a.name == b.name && a.onPoints == b.onPoints;
}

void requireOfVectors(const ScalarChoice& scalar, const ArrayInfo* vectors, const std::string& where)
{
    if (!needsNormal(scalar.part) || (vectors && sameArray(scalar.array, *vectors))) return;
    throw InputError(where,
                     vectors
                         ? fmt::format("'{}' to colour by, but streaks that follow '{}'", scalar.label(), vectors->name)
                         : fmt::format("'{}' to colour by, but no streaks that follow it", scalar.label()),
                     vectors ? "'" + labelOf(vectors->name, scalar.part) + "', of the vectors that the streaks follow"
                             : "the vectors that the streaks follow");
}

bool isMaskName(const std::string& name)
{
    return name == "vtkValidPointMask" || name == "vtkValidCellMask" || name == vtkDataSetAttributes::GhostArrayName();
}

vtkDataArray* findArray(vtkDataSet& data, const std::string& name, bool onPoints)
{
    return attributesOf(data, onPoints)->GetArray(name.c_str());
}

vtkSmartPointer<vtkFloatArray> toFloats(vtkDataArray* array)
{
    if (auto* floats = vtkFloatArray::SafeDownCast(array)) return floats;
    auto floats = vtkSmartPointer<vtkFloatArray>::New();
    floats->SetName(array->GetName());
    floats->SetNumberOfComponents(array->GetNumberOfComponents());
    floats->SetNumberOfTuples(array->GetNumberOfTuples());
    const auto count = static_cast<std::size_t>(array->GetNumberOfValues());
    switch (array->HasStandardMemoryLayout() ? array->GetDataType() : VTK_VOID) {
        vtkTemplateMacro(convert(static_cast<const VTK_TT*>(array->GetVoidPointer(0)), floats->GetPointer(0), count));
        default:  // Bits, and layouts of other libraries.
            for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
                for (int c = 0; c < array->GetNumberOfComponents(); ++c)
                    floats->SetTypedComponent(i, c, static_cast<float>(array->GetComponent(i, c)));
    }
    return floats;
}

vtkSmartPointer<vtkFloatArray> partOf(vtkFloatArray& vectors, ArrayPart part)
{
    auto lengths = vtkSmartPointer<vtkFloatArray>::New();
    lengths->SetNumberOfTuples(vectors.GetNumberOfTuples());
    const std::optional<int> one = componentOf(part);
    const int components = vectors.GetNumberOfComponents();
    const float* source = vectors.GetPointer(0);
    float* target = lengths->GetPointer(0);
    parallelRanges(std::size_t(vectors.GetNumberOfTuples()), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const float* tuple = source + i * std::size_t(components);
            target[i] = one ? tuple[*one] : static_cast<float>(std::sqrt(squaredLength(tuple, components)));
        }
    });
    return lengths;
}

std::string nameOf(const std::string& where, const ArrayInfo& array)
{
    return fmt::format("{}: array '{}'", where, array.name);
}

Tally MaskResult::tally(const std::string& where, const ArrayInfo& array) const
{
    return {array.onPoints ? Tally::Of::maskedPoints : Tally::Of::maskedCells, nameOf(where, array), masked, nonFinite,
            all};
}

void MaskResult::add(const MaskResult& other)
{
    masked += other.masked;
    nonFinite += other.nonFinite;
    all += other.all;
    maxMagnitude = std::max(maxMagnitude, other.maxMagnitude);
}

MaskResult maskInvalid(vtkFloatArray& values, vtkDataSet& data, bool onPoints, const CountedSamples* counted)
{
    const MaskResult result = maskAll(values.GetPointer(0), values, data, onPoints, counted);
    values.Modified();
    return result;
}

MaskResult countInvalid(vtkDataArray& values, vtkDataSet& data, bool onPoints)
{
    const vtkSmartPointer<vtkFloatArray> floats = toFloats(&values);
    return maskAll(static_cast<const float*>(floats->GetPointer(0)), *floats, data, onPoints, nullptr);
}

std::int64_t countBeyondHalves(vtkFloatArray& values, const CountedSamples* counted)
{
    const auto components = std::size_t(values.GetNumberOfComponents());
    const float* pointer = values.GetPointer(0);
    return parallelSum(std::size_t(values.GetNumberOfTuples()), grain, [&](std::size_t i) {
        const float* tuple = pointer + i * components;
        const auto beyond = std::count_if(tuple, tuple + components, isBeyondHalves);
        return beyond > 0 && (!counted || (*counted)(std::int64_t(i))) ? std::int64_t(beyond) : 0;
    });
}

}  // namespace aeolic
