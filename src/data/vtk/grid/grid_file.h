#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "data/load/loaded_surface.h"
#include "data/load/progress.h"
#include "data/vector_field.h"
#include "data/vtk/grid/grid_request.h"
#include "description/surface_spec.h"

namespace aeolic {

/// A 3D data set read from a file: vectors to sample, surfaces to cut out, a scalar to colour by. Values that do not
/// count (masked, hidden, not finite) are NaN from the start; values in cells have been brought to the points.
/// Everything throws InputError with one line that begins with the file's name.
class GridFile {
public:
    /// Of several parts only the brick of `part` is read, which takes image data that can be read in pieces (.vti,
    /// .pvti) with arrays on its points.
    GridFile(const std::string& path, const GridRequest& request, const FieldPart& part,
             const ProgressReport& progress);
    ~GridFile();

    /// Samples are on a uniform grid of at least two in each direction, and can be looked up in 3D as they are.
    bool uniform() const;

    /// A slice, an isosurface or the boundary. Of a uniform grid only the geometry, for the field to be sampled on
    /// (slice and boundary in coarse triangles, a hair inside the grid); else, if `withArrays`, with vectors and scalar
    /// on its points. To be finished (loaded_surface.h).
    LoadedSurface cut(const SurfaceSpec& spec, bool withArrays, const ProgressReport& progress);

    /// Makes the data uniform: samples every `spacing` world units (default: as many samples as points, at most 512^3)
    /// within its bounds, NaN outside its cells.
    void resample(std::optional<double> spacing, const ProgressReport& progress);

    /// The vectors, of a uniform grid. Once: the samples are handed over, without a copy, and turned into halves in
    /// place.
    GridField takeVectors();

    /// The scalar to colour by, unless there is none or it is the vectors' own length. Once.
    std::optional<GridField> takeScalar();

    bool hasScalar() const;
    bool scalarIsVectorLength() const;
    std::string scalarLabel() const;
    std::string arrays() const;                    ///< What the file has, for messages …
    ArrayChoices offered() const;                  ///< … and to choose from.
    const std::vector<Tally>& tallies() const;     ///< Of what was read so far; of a brick, of its own samples.
    const std::vector<double>& timeSteps() const;  ///< That the file holds, if it says so.

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace aeolic
