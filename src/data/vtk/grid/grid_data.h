#pragma once

#include <vtkDataSet.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "data/load/progress.h"
#include "data/tally.h"
#include "data/vtk/grid/grid_arrays.h"
#include "data/vtk/grid/image_piece.h"

namespace aeolic {

/// A data set in memory, all that is needed of it: its structure, and the arrays as floats on the points, NaN where
/// they do not count. Everything throws InputError that begins with `path`.
struct GridData {
    std::string path;
    std::optional<ImagePiece> piece;  ///< Where only a brick was read.
    vtkSmartPointer<vtkDataSet> set;
    std::map<std::string, double> maxMagnitude;  ///< Of each of its arrays.
    std::vector<Tally> tallies;                  ///< Of a brick, of its own samples.

    /// Takes over what is needed of `raw`, which loses it. Of what is coloured and cut by its length, that length too.
    void take(vtkDataSet& raw, const GridArrays& arrays);

    /// See GridFile::resample().
    void resample(std::optional<double> spacing, const ProgressReport& progress);

    /// An array, which is no longer part of the set then. Null if there is none of that name.
    vtkSmartPointer<vtkFloatArray> release(const std::string& name);

    /// Null where it is something else.
    vtkImageData* image() const { return vtkImageData::SafeDownCast(set); }

    /// Of a brick, its own samples; else nothing, which means all.
    std::optional<CountedSamples> counted() const;

private:
    void takeArray(vtkDataSet& raw, const ArrayInfo& array);
    void addMagnitude(const std::optional<ScalarChoice>& choice);
};

}  // namespace aeolic
