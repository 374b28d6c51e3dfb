#pragma once

#include <vtkDataSet.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "data/cells/point_means.h"
#include "data/progress.h"
#include "data/tally.h"
#include "data/vtk/grid/grid_arrays.h"
#include "data/vtk/grid/image_piece.h"

namespace aeolic {

/// What is needed of a data set in memory: its structure, and the arrays as floats on the points, NaN where they do not
/// count. Everything throws InputError that begins with `path`.
struct GridData {
    std::string path;
    std::optional<ImagePiece> piece;  ///< The brick, where no more was read.
    vtkSmartPointer<vtkDataSet> set;
    std::map<std::string, double> maxMagnitude;  ///< The longest value of each array.
    std::vector<Tally> tallies;                  ///< A brick counts only its own samples.

    /// Takes the arrays that are needed out of `raw`.
    void take(vtkDataSet& raw, const GridArrays& arrays);

    /// See GridFile::resample().
    void resample(std::optional<double> spacing, const ProgressReport& progress);

    /// An array, which is no longer part of the set then. Null if no array has that name.
    vtkSmartPointer<vtkFloatArray> release(const std::string& name);

    /// What the set, a piece of a mesh, tells its neighbours of values that came from cells (data/cells/point_means.h).
    /// Cost: that of its outside.
    PointMeans outerMeans() const;

    /// Takes such values over, united with the neighbours'.
    void takeMeans(const PointMeans& means);

    /// Null where it is something else.
    vtkImageData* image() const { return vtkImageData::SafeDownCast(set); }

    /// Which samples count: a brick's own; null where all do.
    std::optional<CountedSamples> counted() const;

    /// Lengths and components of vectors that are coloured or cut by, from the vectors as they now are.
    void addMagnitudes(const GridArrays& arrays);

private:
    void takeArray(vtkDataSet& raw, const ArrayInfo& array);
    void addMagnitude(const std::optional<ScalarChoice>& choice);

    std::vector<vtkFloatArray*> fromCells() const;

    std::vector<std::string> fromCells_;  // Names of arrays that were brought to the points.
};

}  // namespace aeolic
