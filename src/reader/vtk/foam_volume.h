#pragma once

#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <string>
#include <vector>

#include "reader/openfoam/foam_case.h"
#include "reader/vtk/own_reader.h"

namespace aeolic {

/// The cells of an OpenFOAM case at one of its times, with values in the cells.
class FoamVolume : public OwnReader {
public:
    /// Looks at folders and headers alone. `time`: none: the first. Throws InputError.
    FoamVolume(const std::string& path, std::optional<double> time);

    const std::vector<ArrayInfo>& arrays() const override { return arrays_; }
    std::vector<double> times() const override { return {}; }  // Who reads a case has asked for them (foamTimes()).
    const std::vector<PartInfo>& parts() const override { return none_; }
    void keepParts(std::vector<std::string>) override {}
    void requireAtTime(const std::vector<std::string>& names) const override;
    std::size_t processors() const override { return foam_.folders.size(); }
    bool readsFloats() const override { return false; }

    /// Otherwise read() cuts polyhedra into simpler cells, which VTK's filters handle better.
    void keepPolyhedra() override { polyhedra_ = true; }

    /// An unstructured grid; that of a decomposed case is put together. VTK reads what checkFoamVolume() found sound.
    vtkSmartPointer<vtkDataObject> read(const std::vector<ArrayInfo>& kept) const override;

    /// The cells of one processor.
    vtkSmartPointer<vtkDataObject> readPiece(const std::vector<ArrayInfo>& kept, int processor) const override;

private:
    vtkSmartPointer<vtkDataObject> read(const std::vector<ArrayInfo>& kept, std::optional<std::size_t> processor) const;

    FoamCase foam_;
    double time_ = 0;
    bool polyhedra_ = false;
    std::vector<ArrayInfo> arrays_;
    std::vector<PartInfo> none_;  // It is read as one.
};

}  // namespace aeolic
