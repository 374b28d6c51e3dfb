#pragma once

#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <string>
#include <vector>

#include "data/vtk/arrays.h"
#include "reader/openfoam/foam_case.h"

namespace aeolic {

/// The cells of an OpenFOAM case at one of its times, with values in the cells.
class FoamVolume {
public:
    /// Looks at folders and headers alone. `time`: none: the first. Throws InputError.
    FoamVolume(const std::string& path, std::optional<double> time);

    const std::vector<ArrayInfo>& arrays() const { return arrays_; }
    std::size_t processors() const { return foam_.folders.size(); }

    /// Throws InputError where one of them is there at other times alone.
    void requireAtTime(const std::vector<std::string>& names) const;

    /// Otherwise read() cuts polyhedra into simpler cells, which VTK's filters handle better.
    void keepPolyhedra() { polyhedra_ = true; }

    /// An unstructured grid; that of a decomposed case is put together. VTK reads what checkFoamVolume() found sound.
    /// `processor`: only that one's cells, of which there may be none.
    vtkSmartPointer<vtkDataObject> read(const std::vector<ArrayInfo>& kept,
                                        std::optional<std::size_t> processor = std::nullopt) const;

private:
    FoamCase foam_;
    double time_ = 0;
    bool polyhedra_ = false;
    std::vector<ArrayInfo> arrays_;
};

}  // namespace aeolic
