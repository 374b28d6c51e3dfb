#pragma once

#include <vtkDataSet.h>
#include <vtkPolyData.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "data/vtk/file_reader.h"
#include "data/vtk/grid/grid_data.h"
#include "data/vtk/grid/grid_file.h"
#include "data/vtk/grid/half_slabs.h"

namespace aeolic {

/// What a GridFile holds: all of a data set (grid_file.cpp), or a piece (grid_pieces.cpp).
struct GridFile::State {
    GridRequest request;
    FieldFacts facts;
    GridArrays arrays;
    GridData grid;
    bool borrowed = false;                            // The vectors are the caller's memory …
    std::vector<std::shared_ptr<const void>> owners;  // … which these keep.
    std::optional<HalfVectors> halves;                // Where vectors were read as halves: `grid` then has no arrays.

    /// The scalar to colour by stands in an array of its own.
    bool hasOwnScalar() const { return facts.hasScalar && facts.ofVectors == ArrayPart::whole; }
    void choose(const std::vector<ArrayInfo>& available);
    vtkSmartPointer<vtkDataSet> withoutHidden(vtkDataSet& data) const;
    void take(vtkDataSet& data);
    vtkSmartPointer<vtkDataObject> withOthers(vtkDataObject& first, const ProgressReport& progress) const;
    bool canReadHalves(FileReader& reader) const;
    void readHalves(FileReader& reader, const ProgressReport& progress);
    void keepOwners(GridField& field) const;
    std::string contourArray(const SurfaceSpec& spec) const;
    SurfaceArrays cutArrays(const CutArrays& wanted) const;
    LoadedSurface uniformIsosurface(const SurfaceSpec& spec);
};

/// Throws InputError where the data set is empty, or where cells refer to points that it has not.
void checkStructure(vtkDataSet& data, const std::string& path);

/// The mesh of polygons that were cut out of a grid. An isosurface has holes where values are masked. Their own tally
/// tells of them, so corners that are nowhere are not counted.
LoadedSurface meshOfCut(vtkPolyData& polygons, const SurfaceSpec& spec, const std::string& path,
                        const SurfaceArrays& arrays);

/// Whether the surface lies where the field's values put it, and not where the file's points are.
inline bool passesThroughCells(const SurfaceSpec& spec)
{
    return spec.kind == SurfaceSpec::Kind::slice || spec.kind == SurfaceSpec::Kind::isosurface;
}

}  // namespace aeolic
