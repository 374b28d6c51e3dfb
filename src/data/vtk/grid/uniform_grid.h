#pragma once

#include <vtkDataSet.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <string>

#include "data/progress.h"
#include "data/vector_field.h"
#include "data/vtk/grid/image_piece.h"

namespace aeolic {

/// The data as image data if that is what it is: image data, or a rectilinear grid with even coordinates; at least two
/// samples in each direction. Null otherwise. Arrays are shared. Throws InputError for image data that is stored
/// rotated or mirrored.
vtkSmartPointer<vtkImageData> asUniform(vtkDataSet& data, const std::string& where);

/// All point arrays of `data` on a uniform grid that spans its bounds, NaN where no cell is. See GridFile::resample.
vtkSmartPointer<vtkImageData> resampleToUniform(vtkDataSet& data, std::optional<double> spacing,
                                                const std::string& where, const ProgressReport& progress);

/// Where the samples of `image` lie, without samples. `piece`: what `image` is of a larger grid, or nothing.
GridField gridStructure(vtkImageData& image, const std::optional<ImagePiece>& piece);

/// Gives the field the array's memory, without a copy: the array stays alive as long as the field does.
void setSamples(GridField& field, const vtkSmartPointer<vtkFloatArray>& samples);

/// The whole grid that `image` is a piece of, without arrays.
vtkSmartPointer<vtkImageData> wholeStructure(vtkImageData& image, const ImagePiece& piece);

/// Turns the samples of `field`, which must be `samples` and used by nobody else, into halves and gives back the rest
/// of the memory.
void makeHalf(GridField& field, const vtkSmartPointer<vtkFloatArray>& samples);

}  // namespace aeolic
