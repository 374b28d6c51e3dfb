#include "data/vtk/grid/half_slabs.h"

#include <vtkDataSet.h>
#include <vtkFloatArray.h>

#include <algorithm>

#include "aeolic/error.h"
#include "base/half.h"
#include "base/large_memory.h"
#include "base/memory.h"

namespace aeolic {
namespace {

/// A slab's vectors as floats, invalid ones masked.
vtkSmartPointer<vtkFloatArray> readSlab(FileReader& reader, const std::array<int, 6>& extent, const ImagePiece& piece,
                                        const ArrayInfo& vectors, const std::string& path, HalfVectors& result)
{
    const auto object = reader.readExtent(extent);
    auto* image = vtkImageData::SafeDownCast(object);
    vtkDataArray* array = image ? findArray(*image, vectors.name, true) : nullptr;
    const auto samples =
        std::int64_t(extent[1] - extent[0] + 1) * (extent[3] - extent[2] + 1) * (extent[5] - extent[4] + 1);
    if (!array || array->GetNumberOfTuples() != samples)
        throw InputError(path,
                         "array '" + vectors.name + "' has " + std::to_string(array ? array->GetNumberOfTuples() : 0) +
                             " values in a part of " + std::to_string(samples),
                         "one for each of the points");
    vtkSmartPointer<vtkFloatArray> values = toFloats(array);
    const CountedSamples counted = piece.countedIn(extent);
    const MaskResult masked = maskInvalid(*values, *image, true, &counted);
    result.masked.add(masked);
    if (masked.maxMagnitude > kLargestHalf) result.clamped += countBeyondHalves(*values, &counted);
    result.structure = vtkSmartPointer<vtkImageData>::New();
    result.structure->CopyStructure(image);
    return values;
}

}  // namespace

HalfVectors readHalves(FileReader& reader, const ImagePiece& piece, const ArrayInfo& vectors, const std::string& path,
                       const ProgressReport& progress, std::int64_t slabBytes)
{
    std::array<int, 6> all = piece.extent();
    const auto layer = std::int64_t(all[1] - all[0] + 1) * (all[3] - all[2] + 1) * vectors.components;
    const std::int64_t layers = all[5] - all[4] + 1;
    const auto count = std::size_t(layer * layers);
    requireMemory(path, "the field in half precision", count * sizeof(std::uint16_t) + std::uint64_t(slabBytes));
    // A gather of the last halves may read past them.
    const std::shared_ptr<std::uint16_t> halves(makeLargeArray<std::uint16_t>(count + 2).release(), FreeLarge());

    HalfVectors result;
    const std::int64_t step = std::max<std::int64_t>(1, slabBytes / (layer * std::int64_t(sizeof(float))));
    for (std::int64_t first = 0; first < layers; first += step) {
        progress("reading the field", double(first) / double(layers));
        std::array<int, 6> slab = all;
        slab[4] = all[4] + int(first);
        slab[5] = all[4] + int(std::min(first + step, layers)) - 1;
        const auto values = readSlab(reader, slab, piece, vectors, path, result);
        halvesFromFloatsParallel(values->GetPointer(0), halves.get() + first * layer,
                                 std::size_t(values->GetNumberOfValues()));
    }
    result.structure->SetExtent(all.data());
    result.samples = halves;
    progress("reading the field", 1);
    return result;
}

}  // namespace aeolic
