#pragma once

#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <string>
#include <vector>

#include "data/ensight/ensight_case.h"
#include "data/vtk/arrays.h"
#include "data/vtk/file_formats.h"

namespace aeolic {

/// The parts of an EnSight Gold case at one of its times.
class EnSightBlocks {
public:
    /// Reads the case file alone. `time`: none: the first. Throws InputError.
    EnSightBlocks(const std::string& path, FileUse use, std::optional<double> time);

    const std::vector<ArrayInfo>& arrays() const { return arrays_; }
    std::vector<double> times() const { return case_.times(); }

    /// Leaves out all parts but these (data/part_choice.h). Where none is named, a surface is made of the parts that
    /// are faces, a field of those that fill space.
    void keepParts(std::vector<std::string> wanted) { wanted_ = std::move(wanted); }

    /// A multi-block data set with the parts' names: polygons of a part that is faces, an unstructured grid of one that
    /// fills space. Every block has all `kept` arrays; values that the files do not have are NaN. Throws InputError.
    vtkSmartPointer<vtkDataObject> read(const std::vector<ArrayInfo>& kept) const;

private:
    EnSightCase case_;
    FileUse use_;
    std::optional<double> time_;
    std::vector<ArrayInfo> arrays_;
    std::vector<std::string> wanted_;
};

}  // namespace aeolic
