#pragma once

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <string>

#include "data/progress.h"
#include "data/vtk/arrays.h"
#include "data/vtk/file_reader.h"

namespace aeolic {

/// Vectors read from image data as halves.
struct HalfVectors {
    vtkSmartPointer<vtkImageData> structure;  ///< The structure of the data read, without arrays.
    std::shared_ptr<const void> samples;      ///< Halves, laid out as GridField says.
    MaskResult masked;                        ///< Counted over the samples that this rank counts.
    std::int64_t clamped = 0;                 ///< Values beyond the largest half, among the same samples.
};

/// Bytes of a slab's floats: enough for a long read, and little beside any field that matters.
inline constexpr std::int64_t kHalfSlabBytes = 32 << 20;

/// Reads `vectors`, on the points, from a piece of an image file. It reads a few layers at a time, so that no more
/// floats are in memory than a slab has. A field of halves then needs little more memory than the halves. Throws
/// InputError.
HalfVectors readHalves(FileReader& reader, const ImagePiece& piece, const ArrayInfo& vectors, const std::string& path,
                       const ProgressReport& progress, std::int64_t slabBytes = kHalfSlabBytes);

}  // namespace aeolic
