#include "data/vtk/memory/memory_arrays.h"

#include <fmt/format.h>
#include <vtkDoubleArray.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>
#include <vtkTypeUInt32Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "aeolic/error.h"
#include "base/memory.h"
#include "base/parallel.h"

namespace aeolic {
namespace {

constexpr std::size_t grain = std::size_t{1} << 15;

/// VTK takes memory that it may write to. Nobody writes to this: see takeCopies().
template <class Array>
vtkSmartPointer<vtkDataArray> wrappedAs(const ArrayView& view, const std::string& where)
{
    using Value = typename Array::ValueType;
    auto array = vtkSmartPointer<Array>::New();
    array->SetNumberOfComponents(view.components);
    const std::int64_t tuple = view.components * std::int64_t(sizeof(Value)), values = view.count * view.components;
    if (view.strideBytes != 0 && view.strideBytes != tuple) {
        requireMemory(where, "a copy without gaps", std::uint64_t(view.count * tuple));
        array->SetNumberOfTuples(view.count);
        const auto* from = static_cast<const std::byte*>(view.data);
        auto* to = reinterpret_cast<std::byte*>(array->GetPointer(0));
        for (std::int64_t i = 0; i < view.count; ++i)
            std::memcpy(to + i * tuple, from + i * view.strideBytes, std::size_t(tuple));
        return array;
    }
    if (values > 0) array->SetArray(static_cast<Value*>(const_cast<void*>(view.data)), values, 1);
    return array;
}

std::int64_t bytesOf(ValueType type)
{
    switch (type) {
        case ValueType::float64:
        case ValueType::int64:
            return 8;
        case ValueType::uint8:
            return 1;
        default:
            return 4;
    }
}

void checkView(const ArrayView& view, const std::string& where)
{
    constexpr std::int64_t most = std::int64_t{1} << 56;
    if (view.components < 1 || view.components > 1024)
        throw InputError(where, fmt::format("{} components", view.components), "from 1 to 1024");
    const std::int64_t tuple = view.components * bytesOf(view.type);
    if (view.count < 0 || view.count > most / tuple)
        throw InputError(where, fmt::format("{} tuples", view.count), "a number of tuples that memory can hold");
    if (view.count > 0 && !view.data) throw InputError(where, "a null pointer", "values");
    if (view.strideBytes != 0 && view.strideBytes < tuple)
        throw InputError(where, fmt::format("tuples {} bytes apart", view.strideBytes),
                         fmt::format("at least {}, what a tuple takes", tuple));
}

bool allFinite(const vtkFloatArray& array)
{
    const float* values = const_cast<vtkFloatArray&>(array).GetPointer(0);
    return holdsForAll(std::size_t(array.GetNumberOfValues()), grain, [&](std::size_t begin, std::size_t end) {
        return std::all_of(values + begin, values + end, [](float value) { return std::isfinite(value); });
    });
}

bool hasMasks(vtkDataSet& data, bool onPoints)
{
    for (const ArrayInfo& array : arraysOf(data))
        if (array.onPoints == onPoints && isMaskName(array.name)) return true;
    return false;
}

}  // namespace

vtkSmartPointer<vtkDataArray> wrapped(const ArrayView& view, const std::string& where)
{
    checkView(view, where);
    switch (view.type) {
        case ValueType::float32:
            return wrappedAs<vtkFloatArray>(view, where);
        case ValueType::float64:
            return wrappedAs<vtkDoubleArray>(view, where);
        case ValueType::int32:
            return wrappedAs<vtkTypeInt32Array>(view, where);
        case ValueType::uint32:
            return wrappedAs<vtkTypeUInt32Array>(view, where);
        case ValueType::int64:
            return wrappedAs<vtkTypeInt64Array>(view, where);
        case ValueType::uint8:
            return wrappedAs<vtkUnsignedCharArray>(view, where);
    }
    throw InputError(where, fmt::format("value type {}", int(view.type)), "one of the names of ValueType");
}

vtkSmartPointer<vtkIdTypeArray> wrappedIndices(const ArrayView& view, const std::string& where)
{
    if (view.count == 0) return vtkSmartPointer<vtkIdTypeArray>::New();  // Whatever they would have been.
    if (view.type != ValueType::int32 && view.type != ValueType::uint32 && view.type != ValueType::int64)
        throw InputError(where, "indices that are not int32, uint32 or int64", "whole numbers");
    const auto given = wrapped(view, where);
    auto indices = vtkSmartPointer<vtkIdTypeArray>::New();
    if (auto* same = vtkTypeInt64Array::SafeDownCast(given); same && view.strideBytes == 0 && sizeof(vtkIdType) == 8) {
        if (view.count > 0)
            indices->SetArray(reinterpret_cast<vtkIdType*>(same->GetPointer(0)), same->GetNumberOfValues(), 1);
        return indices;
    }
    requireMemory(where, "indices of 64 bits", std::uint64_t(given->GetNumberOfValues()) * sizeof(vtkIdType));
    indices->SetNumberOfValues(given->GetNumberOfValues());
    const auto convert = [&](const auto* from) {
        parallelRanges(std::size_t(given->GetNumberOfValues()), grain, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) indices->SetValue(vtkIdType(i), vtkIdType(from[i]));
        });
    };
    if (view.type == ValueType::int32)
        convert(static_cast<const std::int32_t*>(given->GetVoidPointer(0)));
    else if (view.type == ValueType::uint32)
        convert(static_cast<const std::uint32_t*>(given->GetVoidPointer(0)));
    else
        convert(static_cast<const std::int64_t*>(given->GetVoidPointer(0)));
    return indices;
}

void requireComponents(const ArrayView& view, int expected, const std::string& where)
{
    if (view.components != expected)
        throw InputError(where, fmt::format("{} components", view.components), fmt::format("{}", expected));
}

vtkSmartPointer<vtkPoints> wrappedPoints(const ArrayView& view, const std::string& where)
{
    const bool floating = view.type == ValueType::float32 || view.type == ValueType::float64;
    if (!floating) throw InputError(where, "whole numbers", "float or double");
    auto points = vtkSmartPointer<vtkPoints>::New();
    if (view.count == 0) return points;
    requireComponents(view, 3, where);
    points->SetData(wrapped(view, where));
    return points;
}

vtkSmartPointer<vtkCellArray> wrappedCells(const ArrayView& offsets, const ArrayView& connectivity,
                                           const std::string& name, const char* cell)
{
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    if (offsets.count == 0 && connectivity.count == 0) return cells;
    const std::string where = name + ": offsets";
    requireComponents(offsets, 1, where);
    requireComponents(connectivity, 1, name + ": connectivity");
    const auto begins = wrappedIndices(offsets, where);
    const auto corners = wrappedIndices(connectivity, name + ": connectivity");
    const vtkIdType *begin = begins->GetPointer(0), *end = begin + begins->GetNumberOfValues();
    if (corners->GetNumberOfValues() == 0 && begin != end && *(end - 1) > 0)
        throw InputError(name + ": connectivity", "it is empty",
                         fmt::format("{} indices, as the offsets say", *(end - 1)));
    if (begin == end)
        throw InputError(where, "they are empty",
                         fmt::format("where each {} begins, and {} at the end", cell, corners->GetNumberOfValues()));
    if (*begin != 0 || *(end - 1) != corners->GetNumberOfValues() || !std::is_sorted(begin, end))
        throw InputError(where, "they do not rise from 0 to the number of indices",
                         fmt::format("where each {} begins, and {} at the end", cell, corners->GetNumberOfValues()));
    cells->SetData(begins, corners);
    return cells;
}

void addArrays(vtkDataSet& data, const std::vector<NamedArray>& arrays, bool onPoints, const std::string& where)
{
    vtkDataSetAttributes* all = attributesOf(data, onPoints);
    for (const NamedArray& array : arrays) {
        if (array.name.empty()) throw InputError(where, "an array without a name", "a name for each array");
        if (all->HasArray(array.name.c_str()))
            throw InputError(where, "array '" + array.name + "' is given twice", "each name once");
        const std::string here = where + ": array '" + array.name + "'";
        const auto values = wrapped(array.values, here);
        values->SetName(array.name.c_str());
        all->AddArray(values);
        if (array.activeVectors || array.activeNormals) requireComponents(array.values, 3, here);
        if (array.activeVectors) all->SetActiveVectors(array.name.c_str());
        if (array.activeNormals) all->SetActiveNormals(array.name.c_str());
    }
}

bool takeCopies(vtkDataSet& data, const std::vector<ArrayInfo>& arrays, bool always)
{
    bool firstIsCallers = false;
    for (const ArrayInfo& array : arrays) {
        auto* floats = vtkFloatArray::SafeDownCast(findArray(data, array.name, array.onPoints));
        if (!floats) continue;  // Floats are made of all others.
        const bool copy = always || hasMasks(data, array.onPoints) || !allFinite(*floats);
        if (&array == &arrays.front()) firstIsCallers = !copy && array.onPoints;
        if (!copy) continue;
        auto own = vtkSmartPointer<vtkFloatArray>::New();
        own->DeepCopy(floats);
        attributesOf(data, array.onPoints)->AddArray(own);  // In the place of the one of the same name.
    }
    return firstIsCallers;
}

}  // namespace aeolic
