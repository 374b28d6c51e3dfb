#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "aeolic/data.h"
#include "aeolic/surface_spec.h"
#include "data/cells/cell_volume.h"
#include "data/cells/point_means.h"
#include "data/field_facts.h"
#include "data/loaded_surface.h"
#include "data/piece_run.h"
#include "data/progress.h"
#include "data/vector_field.h"
#include "data/vtk/grid/grid_outline.h"
#include "data/vtk/surface/cut_outline.h"

namespace aeolic {

/// Which of a field's arrays a cut through cells carries.
struct CutArrays {
    bool vectors = false, scalar = false;
    bool ofShells = false;  ///< Of a boundary: on shells beside cells that fill space alone, and NaN everywhere else.
};

/// A 3D data set read from a file, or in the caller's memory: vectors to sample, surfaces to cut out, a scalar to
/// colour by. Values that do not count (masked, hidden, not finite) are NaN from the start; values in cells have been
/// brought to the points. Everything throws InputError with one line that begins with the file's name.
class GridFile {
public:
    /// Where it is split, only the brick of `part` is read. That takes image data that can be read in pieces (.vti,
    /// .pvti, .nhdr) with arrays on its points.
    GridFile(const std::string& path, const GridRequest& request, const FieldPart& part,
             const ProgressReport& progress);

    /// All of a grid or a volume in the caller's memory, called `name` in messages.
    GridFile(const Grid& memory, const std::string& name, const GridRequest& request);
    GridFile(const Volume& memory, const std::string& name, const GridRequest& request);
    ~GridFile();

    /// Pieces of a volume of cells, those of `run` among volumePiecesOf(). One may be empty. Where values stand in
    /// cells, those at points on a piece's outside are right only when uniteMeans() was there.
    static std::vector<std::shared_ptr<GridFile>> readPieces(const std::string& path, const GridRequest& request,
                                                             const PieceRun& run, const ProgressReport& progress);
    bool empty() const;

    /// What a piece tells the others of values that stand in cells, and takes from them.
    PointMeans outerMeans() const;
    void takeMeans(const PointMeans& means);

    /// What a piece tells of a cut, and its share of that cut: perhaps no triangle. `number`: which piece it is.
    CutOutline outlineOf(const SurfaceSpec& spec) const;
    LoadedSurface cutPiece(const SurfaceSpec& spec, const CutArrays& wanted, const CutOutline& all, int number) const;

    /// Samples are on a uniform grid of at least two in each direction, and can be looked up in 3D as they are.
    bool uniform() const;

    /// A slice, an isosurface or the boundary, to be finished (data/loaded_surface.h). A uniform grid gives the
    /// geometry alone, to sample the field on: slice and boundary in coarse triangles, a hair inside the grid. Any
    /// other grid gives the wanted vectors and scalar on the points, too.
    LoadedSurface cut(const SurfaceSpec& spec, const CutArrays& wanted, const ProgressReport& progress);

    /// Makes the data uniform: samples every `spacing` world units (default: as many samples as points, at most 512^3)
    /// within its bounds, NaN outside its cells.
    void resample(std::optional<double> spacing, const ProgressReport& progress);

    /// Its cells are 3D, and it can be looked up in them.
    bool hasCells() const;

    /// The cells with vectors and scalar, instead of a uniform grid's. To be called once, after all cuts. Throws where
    /// none is 3D.
    std::shared_ptr<const CellVolume> takeCells();

    /// The vectors of a uniform grid. To be called once: the samples are handed over without a copy, and turned into
    /// halves in place.
    GridField takeVectors();

    /// The vectors' samples are the caller's memory, which nobody may write to.
    bool vectorsAreBorrowed() const;

    /// The scalar to colour by, unless there is none or it is a part of the vectors. To be called once.
    std::optional<GridField> takeScalar();

    const FieldFacts& facts() const;            ///< Its list of tallies is empty.
    const std::vector<Tally>& tallies() const;  ///< Counts so far; a brick counts its own samples.

private:
    GridFile(const std::string& path, const GridRequest& request);
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace aeolic
