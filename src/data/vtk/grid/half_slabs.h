#pragma once

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>

#include "data/load/progress.h"
#include "data/vtk/arrays.h"
#include "data/vtk/file_reader.h"

namespace aeolic {

/// Vectors read from image data as halves.
struct HalfVectors {
    vtkSmartPointer<vtkImageData> structure;  ///< Of what was read, without arrays.
    std::shared_ptr<const void> samples;      ///< Halves, laid out as GridField says.
    MaskResult masked;                        ///< Of the samples that this rank counts …
    std::int64_t clamped = 0;                 ///< … as these: values beyond the largest half.
};

/// Floats of a slab, in bytes: long enough reads, and small beside any field that counts.
inline constexpr std::int64_t kHalfSlabBytes = 32 << 20;

/// Reads `vectors`, on the points, of the piece of an image file a few layers at a time, so that never more floats are
/// in memory than a slab has: a field of halves then needs little more memory than the halves. Throws InputError.
HalfVectors readHalves(FileReader& reader, const ImagePiece& piece, const ArrayInfo& vectors, const std::string& path,
                       const ProgressReport& progress, std::int64_t slabBytes = kHalfSlabBytes);

}  // namespace aeolic
