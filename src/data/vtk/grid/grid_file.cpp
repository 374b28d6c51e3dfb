#include "data/vtk/grid/grid_file.h"

#include <fmt/format.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

#include "aeolic/error.h"
#include "base/half.h"
#include "data/vtk/file_reader.h"
#include "data/vtk/grid/grid_data.h"
#include "data/vtk/grid/half_slabs.h"
#include "data/vtk/grid/uniform_grid.h"
#include "data/vtk/grid/volume_blocks.h"
#include "data/vtk/grid/volume_from_grid.h"
#include "data/vtk/memory/memory_arrays.h"
#include "data/vtk/memory/memory_grid.h"
#include "data/vtk/surface/cut.h"
#include "data/vtk/surface/isosurface.h"
#include "data/vtk/surface/polydata_mesh.h"

namespace aeolic {

struct GridFile::State {
    std::string names;  // All arrays there are.
    ArrayChoices offered;
    GridArrays arrays;
    std::string colorBy;
    GridData grid;
    std::vector<double> timeSteps;
    bool wantsHalves = false;
    int ranksOnHost = 1;
    bool borrowed = false;                            // The vectors are the caller's memory …
    std::vector<std::shared_ptr<const void>> owners;  // … which these keep.
    std::optional<HalfVectors> halves;                // Where vectors were read as halves: `grid` then has no arrays.

    void choose(const std::vector<ArrayInfo>& available, const GridRequest& request);
    bool canReadHalves(const FileReader& reader) const;
    void readHalves(FileReader& reader, const ProgressReport& progress);
    void keepOwners(GridField& field) const;
    LoadedSurface uniformIsosurface(const SurfaceSpec& spec);
};

namespace {

void checkStructure(vtkDataSet& data, const std::string& path)
{
    if (data.GetNumberOfPoints() == 0 || data.GetNumberOfCells() == 0)
        throw InputError(path, fmt::format("{} points and {} cells", data.GetNumberOfPoints(), data.GetNumberOfCells()),
                         "a grid with cells");
    if (auto* grid = vtkUnstructuredGrid::SafeDownCast(&data))
        if (!cellsAreSound(*grid->GetCells(), grid->GetNumberOfPoints()))
            throw InputError(path, "a cell refers to a point that does not exist",
                             "indices below the number of points");
}

}  // namespace

void GridFile::State::choose(const std::vector<ArrayInfo>& available, const GridRequest& request)
{
    names = listArrays(available);
    offered = offeredArrays(available);
    arrays = chooseArrays(available, request, grid.path);
}

GridFile::GridFile(const std::string& path, const GridRequest& request, const FieldPart& part,
                   const ProgressReport& progress)
    : state_(std::make_unique<State>())
{
    state_->grid.path = path;
    state_->colorBy = request.colorBy;
    FileReader reader(path, FileReader::Use::field, request.timeInFile);
    state_->timeSteps = reader.timeSteps();
    if (request.lookUp) reader.keepPolyhedra();
    reader.keepParts(request.parts);
    if (reader.announcesArrays()) {
        state_->choose(reader.announcedArrays(), request);
        reader.keepOnly(state_->arrays.all());
    }
    if (part.split()) {
        state_->grid.piece = reader.keepBrick(part, !request.contour.empty());
        requirePoints(state_->arrays.all(), path);
    }
    state_->wantsHalves = request.halves;
    state_->ranksOnHost = request.ranksOnHost;
    if (state_->canReadHalves(reader)) {
        state_->readHalves(reader, progress);
        return;
    }
    const auto object = reader.read(progress, "reading the field");
    vtkSmartPointer<vtkDataSet> raw = vtkDataSet::SafeDownCast(object);
    if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(object)) raw = volumeOf(*blocks, path);
    if (!raw || raw->GetDataObjectType() == VTK_POLY_DATA)
        throw InputError(path, "it holds " + kindOf(*object), "a grid to sample (a surface goes to --surface)");
    GridData& grid = state_->grid;
    if (!grid.piece || !grid.piece->brick.empty()) checkStructure(*raw, path);
    if (!reader.announcesArrays()) state_->choose(arraysOf(*raw), request);
    grid.take(*raw, state_->arrays);
    if (const auto image = asUniform(*grid.set, path)) grid.set = image;
}

GridFile::GridFile(const Grid& memory, const std::string& name, const GridRequest& request)
    : state_(std::make_unique<State>())
{
    state_->grid.path = name;
    state_->colorBy = request.colorBy;
    state_->wantsHalves = request.halves;
    state_->ranksOnHost = request.ranksOnHost;
    const auto image = imageFromMemory(memory, name);
    checkStructure(*image, name);
    state_->choose(arraysOf(*image), request);
    state_->borrowed = takeCopies(*image, state_->arrays.all(), request.halves);  // The vectors come first.
    for (const auto* arrays : {&memory.pointArrays, &memory.cellArrays})
        for (const NamedArray& array : *arrays) state_->owners.push_back(array.values.owner);
    state_->grid.take(*image, state_->arrays);
    if (const auto uniform = asUniform(*state_->grid.set, name)) state_->grid.set = uniform;
}

/// Whether vectors can be read as halves: from image data, where nothing but the vectors at its points is needed. Small
/// files are read at once.
bool GridFile::State::canReadHalves(const FileReader& reader) const
{
    constexpr std::int64_t worthwhile = 1 << 24;  // Samples.
    const GridIndex dims = reader.imageDims();
    return wantsHalves && reader.announcesArrays() && arrays.all().size() == 1 && arrays.vectors.onPoints &&
           !arrays.contour && (!arrays.scalar || arrays.scalarIsVectorLength()) && arrays.vectors.components == 3 &&
           *std::min_element(dims.begin(), dims.end()) >= 2 && dims[0] * dims[1] * dims[2] >= worthwhile;
}

void GridFile::State::readHalves(FileReader& reader, const ProgressReport& progress)
{
    const ImagePiece piece = grid.piece ? *grid.piece : *reader.wholeImage();
    halves = aeolic::readHalves(reader, piece, arrays.vectors, grid.path, progress);
    grid.maxMagnitude[arrays.vectors.name] = halves->masked.maxMagnitude;
    grid.tallies.push_back(halves->masked.tally(grid.path, arrays.vectors));
    grid.set = asUniform(*halves->structure, grid.path);
}

/// The field's samples may be the caller's memory.
void GridFile::State::keepOwners(GridField& field) const
{
    if (!owners.empty())
        field.samples =
            std::shared_ptr<const void>(field.samples.get(), [samples = field.samples, kept = owners](const void*) {});
}

/// This part's piece of the isosurface. It may be empty: whether any rank has a triangle is found out later.
LoadedSurface GridFile::State::uniformIsosurface(const SurfaceSpec& spec)
{
    const std::optional<ImagePiece>& piece = grid.piece;
    LoadedSurface surface;
    surface.where = grid.path;
    surface.cutOut = true;
    surface.piece = piece.has_value();
    GridField scalar = gridStructure(*grid.image(), piece);
    auto* values = vtkFloatArray::SafeDownCast(grid.set->GetPointData()->GetArray(arrays.contour->label().c_str()));
    setSamples(scalar, values);
    double range[2];
    values->GetFiniteRange(range, 0);
    surface.cutRange = {range[0], range[1]};
    const Brick all{{0, 0, 0}, {scalar.dims[0] - 1, scalar.dims[1] - 1, scalar.dims[2] - 1}};
    const Brick& cells = piece ? piece->own : all;
    requireRoomFor(spec, grid.path, isosurfaceSize(scalar, cells, spec.value), ranksOnHost);
    surface.mesh = isosurface(scalar, cells, spec.value);
    surface.topology = 1;  // Equal only where the places are equal too: withPlaces().
    if (piece) return surface;
    requireIsosurface(spec, grid.path, surface.cutRange, surface.mesh.triangles.size());
    surface.mesh.order = {};
    return surface;
}

GridFile::~GridFile() = default;

bool GridFile::uniform() const
{
    const GridData& grid = state_->grid;
    return grid.piece || (grid.image() && grid.image()->GetDataDimension() == 3);
}

LoadedSurface GridFile::cut(const SurfaceSpec& spec, bool withArrays, const ProgressReport& progress)
{
    progress("cutting the surface out", 0);
    const GridData& grid = state_->grid;
    const auto& contour = state_->arrays.contour;
    LoadedSurface surface;
    if (contour && uniform()) {
        surface = state_->uniformIsosurface(spec);
    } else {
        const auto polyData = cutSurface(grid.piece ? *wholeStructure(*grid.image(), *grid.piece) : *grid.set, spec,
                                         contour ? contour->label() : "", grid.path, state_->ranksOnHost);
        SurfaceArrays arrays;
        if (withArrays) arrays = {true, state_->arrays.vectors.name, state_->colorBy};
        surface = meshFromPolyData(*polyData, grid.path, arrays, true);
    }
    // Slices and isosurfaces of a grid that moves, or of other values, may have as many triangles by chance.
    const bool ofAllCells = spec.kind == SurfaceSpec::Kind::boundary || spec.kind == SurfaceSpec::Kind::image;
    if (!ofAllCells) surface.topology = withPlaces(surface.topology, surface.mesh);
    surface.mesh.name = spec.text;
    surface.arrays = state_->names;
    surface.offered = state_->offered;
    progress("cutting the surface out", 1);
    return surface;
}

void GridFile::resample(std::optional<double> spacing, const ProgressReport& progress)
{
    state_->borrowed = false;
    state_->grid.resample(spacing, progress);
}

bool GridFile::hasCells() const
{
    const GridData& grid = state_->grid;
    return !grid.piece && !uniform() && hasVolume(*grid.set);
}

std::shared_ptr<const VolumeCells> GridFile::takeCells()
{
    GridData& grid = state_->grid;
    const bool ownScalar = hasScalar() && !scalarIsVectorLength();
    const auto vectors = grid.release(state_->arrays.vectors.name);
    const auto scalars = ownScalar ? grid.release(scalarLabel()) : vtkSmartPointer<vtkFloatArray>();
    auto cells = volumeFromGrid(*grid.set, *vectors, scalars, grid.path);
    cells->maxVector = grid.maxMagnitude[state_->arrays.vectors.name];
    grid.set = nullptr;  // Its cells take as much memory as the tree that is to be made of these.
    cells->meansOfCells = !state_->arrays.vectors.onPoints;
    return cells;
}

GridField GridFile::takeVectors()
{
    State& s = *state_;
    GridData& grid = s.grid;
    const std::string& name = s.arrays.vectors.name;
    GridField field = gridStructure(*grid.image(), grid.piece);
    field.name = name;
    field.maxMagnitude = grid.maxMagnitude[name];
    Tally halves{Tally::Of::halves, nameOf(grid.path, s.arrays.vectors)};
    halves.longest = field.maxMagnitude;
    if (s.halves) {
        field.samples = std::move(s.halves->samples);
        field.precision = FieldPrecision::float16;
        halves.found = s.halves->clamped;
    } else {
        auto values = grid.release(name);
        setSamples(field, values);
        s.keepOwners(field);
        if (!s.wantsHalves) return field;
        const auto mine = grid.counted();
        if (field.maxMagnitude > kLargestHalf) halves.found = countBeyondHalves(*values, mine ? &*mine : nullptr);
        makeHalf(field, values);
    }
    grid.tallies.push_back(halves);
    return field;
}

std::optional<GridField> GridFile::takeScalar()
{
    if (!hasScalar() || scalarIsVectorLength()) return std::nullopt;
    GridData& grid = state_->grid;
    const std::string name = scalarLabel();
    GridField field = gridStructure(*grid.image(), grid.piece);
    field.name = name;
    field.maxMagnitude = grid.maxMagnitude[name];
    setSamples(field, grid.release(name));
    state_->keepOwners(field);
    return field;
}

bool GridFile::hasScalar() const
{
    return state_->arrays.scalar.has_value();
}

bool GridFile::vectorsAreBorrowed() const
{
    return state_->borrowed;
}

bool GridFile::scalarIsVectorLength() const
{
    return state_->arrays.scalarIsVectorLength();
}

std::string GridFile::scalarLabel() const
{
    return hasScalar() ? state_->arrays.scalar->label() : "";
}

ArrayChoices GridFile::offered() const
{
    return state_->offered;
}

std::string GridFile::arrays() const
{
    return state_->names;
}

const std::vector<double>& GridFile::timeSteps() const
{
    return state_->timeSteps;
}

const std::vector<Tally>& GridFile::tallies() const
{
    return state_->grid.tallies;
}

}  // namespace aeolic
