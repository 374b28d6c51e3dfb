#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reader/openfoam/foam_surface.h"
#include "reader/vtk/own_reader.h"

namespace aeolic {

/// Patches of an OpenFOAM case as a surface: those that are named, or all walls. Values stand on the faces, as the
/// solver has them. Reads no more than those patches and the arrays that are wanted. Throws InputError.
class FoamPatches : public OwnReader {
public:
    FoamPatches(const std::string& path, std::optional<double> time);

    const std::vector<ArrayInfo>& arrays() const override { return arrays_; }
    std::vector<double> times() const override { return foam_.times; }
    const std::vector<PartInfo>& parts() const override { return none_; }
    void keepParts(std::vector<std::string> wanted) override;
    void requireAtTime(const std::vector<std::string>& arrays) const override;
    std::size_t processors() const override { return foam_.folders.size(); }
    void keepRun(const PieceRun& run) override { run_ = run; }
    vtkSmartPointer<vtkDataObject> read(const std::vector<ArrayInfo>& kept) const override;

private:
    const std::string& region() const { return chosen_.front().region; }

    FoamCase foam_;
    double time_ = 0;
    std::vector<std::string> wanted_;
    std::vector<FoamPart> chosen_;  // None before keepParts().
    std::vector<FoamField> fields_;
    std::vector<ArrayInfo> arrays_;
    std::vector<PartInfo> none_;  // It is read as one.
    std::optional<PieceRun> run_;
};

/// The moment that is read where none is given: the first. 0 where the case has no times.
double firstFoamTime(const FoamCase& foam);

/// The fields as arrays of cells. Those drawn where none is named: `preferred`, else U, where they are vectors.
std::vector<ArrayInfo> foamArrays(const std::vector<FoamField>& fields, const std::string& preferred);

}  // namespace aeolic
