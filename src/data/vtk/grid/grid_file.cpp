#include "data/vtk/grid/grid_file.h"

#include <fmt/format.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

#include "aeolic/error.h"
#include "base/half.h"
#include "data/vtk/data_objects.h"
#include "data/vtk/file_reader.h"
#include "data/vtk/grid/grid_file_state.h"
#include "data/vtk/grid/grid_volume.h"
#include "data/vtk/grid/hidden_cells.h"
#include "data/vtk/grid/straight_image.h"
#include "data/vtk/grid/uniform_grid.h"
#include "data/vtk/grid/volume_blocks.h"
#include "data/vtk/joined_arrays.h"
#include "data/vtk/memory/memory_arrays.h"
#include "data/vtk/memory/memory_volume.h"
#include "data/vtk/surface/cut.h"
#include "data/vtk/surface/isosurface.h"
#include "data/vtk/surface/polydata_mesh.h"
#include "data/vtk/surface/shells.h"

namespace aeolic {

void checkStructure(vtkDataSet& data, const std::string& path)
{
    if (data.GetNumberOfPoints() == 0 || data.GetNumberOfCells() == 0)
        throw InputError(path, fmt::format("{} points and {} cells", data.GetNumberOfPoints(), data.GetNumberOfCells()),
                         "a grid with cells");
}

LoadedSurface meshOfCut(vtkPolyData& polygons, const SurfaceSpec& spec, const std::string& path,
                        const SurfaceArrays& arrays)
{
    LoadedSurface surface = meshFromPolyData(polygons, path, arrays, true);
    if (spec.kind == SurfaceSpec::Kind::isosurface)
        std::erase_if(surface.tallies, [](const Tally& tally) { return tally.of == Tally::Of::corners; });
    return surface;
}

void GridFile::State::choose(const std::vector<ArrayInfo>& available)
{
    arrays = chooseArrays(available, request, grid.path);
    facts.name = grid.path;
    facts.arrays = listArrays(available);
    facts.offered = offeredArrays(available);
    facts.vectorsName = arrays.vectors.name;
    facts.hasScalar = arrays.scalar.has_value();
    facts.ofVectors = arrays.partOfVectors();
    if (arrays.scalar) facts.scalarName = arrays.scalar->label();
}

/// The data, or, of a structured grid that hides cells, those that it shows. A uniform grid stays one where only points
/// are hidden and nothing is cut out of it: its samples there are masked.
vtkSmartPointer<vtkDataSet> GridFile::State::withoutHidden(vtkDataSet& data) const
{
    if (data.GetDataObjectType() == VTK_UNSTRUCTURED_GRID) return &data;
    const HiddenParts hidden = hiddenPartsOf(data);
    if (!hidden.cells && !hidden.points) return &data;
    if (!hidden.cells && !request.cutsOut && asUniform(data, grid.path)) return &data;
    if (grid.piece) throw InputError(grid.path, "it hides cells (vtkGhostType)", "one without, or --bricks off");
    vtkSmartPointer<vtkDataSet> shown = shownCells(data, grid.path);
    if (shown->GetNumberOfCells() == 0) throw InputError(grid.path, "it hides all of its cells", "a grid with cells");
    return shown;
}

GridFile::GridFile(const std::string& path, const GridRequest& request) : state_(std::make_unique<State>())
{
    state_->request = request;
    state_->grid.path = path;
}

GridFile::GridFile(const std::string& path, const GridRequest& request, const FieldPart& part,
                   const ProgressReport& progress)
    : GridFile(path, request)
{
    FileReader reader(path, FileReader::Use::field, request.timeInFile);
    state_->facts.timeSteps = reader.timeSteps();
    if (request.lookUp) reader.keepPolyhedra();
    reader.keepParts(request.parts);
    reader.requireAtTime(request.arrays());
    if (reader.announcesArrays()) {
        state_->choose(reader.announcedArrays());
        reader.keepOnly(state_->arrays.all());
    }
    if (part.split()) {
        state_->grid.piece = reader.keepBrick(part, !request.contours.empty());
        requirePoints(state_->arrays.all(), path);
    }
    if (request.otherFiles.empty() && state_->canReadHalves(reader)) {
        state_->readHalves(reader, progress);
        return;
    }
    vtkSmartPointer<vtkDataObject> object = reader.read(progress, "reading the field");
    if (!request.otherFiles.empty()) object = state_->withOthers(*object, progress);
    vtkSmartPointer<vtkDataSet> raw = vtkDataSet::SafeDownCast(object);
    if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(object)) raw = volumeOf(*blocks, path);
    if (!raw || raw->GetDataObjectType() == VTK_POLY_DATA)
        throw InputError(path, "it holds " + kindOf(*object), "a grid to sample (a surface goes to --surface)");
    GridData& grid = state_->grid;
    if (!grid.piece) raw = straightened(*raw, path);
    if (!grid.piece || !grid.piece->brick.empty()) checkStructure(*raw, path);
    raw = state_->withoutHidden(*raw);
    if (!reader.announcesArrays()) state_->choose(withJoined(arraysOf(*raw)));
    makeVectors(*raw, state_->arrays.all(), &state_->arrays.vectors, path);
    grid.take(*raw, state_->arrays);
    grid.addMagnitudes(state_->arrays);
    if (const auto image = asUniform(*grid.set, path)) grid.set = image;
}

GridFile::GridFile(const Grid& memory, const std::string& name, const GridRequest& request) : GridFile(name, request)
{
    state_->take(*imageFromMemory(memory, name));
    for (const auto* arrays : {&memory.pointArrays, &memory.cellArrays})
        for (const NamedArray& array : *arrays) state_->owners.push_back(array.values.owner);
    if (const auto uniform = asUniform(*state_->grid.set, name)) state_->grid.set = uniform;
}

GridFile::GridFile(const Volume& memory, const std::string& name, const GridRequest& request) : GridFile(name, request)
{
    state_->take(*cellsFromMemory(memory, name));
}

/// All parts of a volume as blocks, each with the arrays that are needed. `first`: that of the file itself.
vtkSmartPointer<vtkDataObject> GridFile::State::withOthers(vtkDataObject& first, const ProgressReport& progress) const
{
    auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    blocks->SetBlock(0, &first);
    for (const std::string& file : request.otherFiles) {
        FileReader reader(file, FileReader::Use::field, request.timeInFile);
        if (reader.announcesArrays()) reader.keepOnly(chooseArrays(reader.announcedArrays(), request, file).all());
        const auto part = reader.read(progress, "reading the field");
        blocks->SetBlock(blocks->GetNumberOfBlocks(), part);
    }
    return blocks;
}

/// A data set whose arrays may be the caller's.
void GridFile::State::take(vtkDataSet& data)
{
    checkStructure(data, grid.path);
    const vtkSmartPointer<vtkDataSet> shown = withoutHidden(data);
    choose(withJoined(arraysOf(*shown)));
    makeVectors(*shown, arrays.all(), &arrays.vectors, grid.path);
    borrowed = takeCopies(*shown, arrays.all(), request.halves);  // The vectors come first.
    grid.take(*shown, arrays);
    grid.addMagnitudes(arrays);
}

/// Whether vectors can be read as halves: from image data, where nothing but the vectors at its points is needed. Small
/// files are read at once.
bool GridFile::State::canReadHalves(FileReader& reader) const
{
    const std::vector<ArrayInfo> available =
        reader.announcesArrays() ? reader.announcedArrays() : std::vector<ArrayInfo>();
    constexpr std::int64_t worthwhile = 1 << 24;  // Samples.
    const GridIndex dims = reader.imageDims();
    const auto hides = [](const ArrayInfo& array) { return array.name == vtkDataSetAttributes::GhostArrayName(); };
    if (reader.announcesArrays() && std::any_of(available.begin(), available.end(), hides)) return false;
    const glm::dvec3 spacing = reader.imageSpacing();
    if (!(std::min({spacing.x, spacing.y, spacing.z}) > 0)) return false;
    return request.halves && reader.announcesArrays() && arrays.all().size() == 1 && arrays.vectors.onPoints &&
           arrays.contours.empty() && arrays.vectors.of.empty() && !hasOwnScalar() && arrays.vectors.components == 3 &&
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

std::string GridFile::State::contourArray(const SurfaceSpec& spec) const
{
    return spec.kind == SurfaceSpec::Kind::isosurface ? arrays.contours.at(spec.array).label() : std::string();
}

SurfaceArrays GridFile::State::cutArrays(const CutArrays& wanted) const
{
    // On the points of the cut stands what stood on the cells, too.
    const std::string scalar =
        arrays.scalar ? arrays.scalar->array.name + std::string(suffixOf(arrays.scalar->part)) : request.colorBy;
    return {wanted.vectors, arrays.vectors.name, wanted.scalar ? scalar : std::string()};
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
    auto* values = vtkFloatArray::SafeDownCast(grid.set->GetPointData()->GetArray(contourArray(spec).c_str()));
    setSamples(scalar, values);
    double range[2];
    values->GetFiniteRange(range, 0);
    surface.cutRange = {range[0], range[1]};
    const Brick all{{0, 0, 0}, {scalar.dims[0] - 1, scalar.dims[1] - 1, scalar.dims[2] - 1}};
    const Brick& cells = piece ? piece->own : all;
    requireRoomFor(spec, grid.path, isosurfaceSize(scalar, cells, spec.value), request.ranksOnHost);
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

LoadedSurface GridFile::cut(const SurfaceSpec& spec, const CutArrays& wanted, const ProgressReport& progress)
{
    progress("cutting the surface out", 0);
    const GridData& grid = state_->grid;
    LoadedSurface surface;
    if (spec.kind == SurfaceSpec::Kind::isosurface && uniform()) {
        surface = state_->uniformIsosurface(spec);
    } else {
        const vtkSmartPointer<vtkDataSet> whole =
            grid.piece ? vtkSmartPointer<vtkDataSet>(wholeStructure(*grid.image(), *grid.piece)) : grid.set;
        vtkDataSet& data = *whole;
        const std::string contour = state_->contourArray(spec);
        const CutOutline all = outlineOfCut(data, spec, contour);
        requireCut(all, spec, grid.path, state_->request.ranksOnHost);
        const std::vector<char> shells = wanted.ofShells ? shellCells(data) : std::vector<char>();
        const auto polygons = shells.empty() ? cutSurface(data, spec, contour, grid.path, all)
                                             : boundaryWithShells(data, shells, grid.path);
        requirePolygons(std::size_t(polygons->GetNumberOfPolys()), all, spec, grid.path);
        surface = meshOfCut(*polygons, spec, grid.path,
                            state_->cutArrays(wanted.ofShells && shells.empty() ? CutArrays{} : wanted));
        if (!shells.empty()) {  // What is masked counts in the volume's points, and the scalar is the field's.
            std::erase_if(surface.tallies, [](const Tally& tally) { return tally.of == Tally::Of::maskedPoints; });
            surface.scalarLabel.clear();
            surface.ofVectors = ArrayPart::whole;
        }
    }
    // Slices and isosurfaces of a grid that moves, or of other values, may have as many triangles by chance.
    if (passesThroughCells(spec)) surface.topology = withPlaces(surface.topology, surface.mesh);
    surface.mesh.name = spec.text;
    surface.arrays = state_->facts.arrays;
    surface.offered = state_->facts.offered;
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

std::shared_ptr<const CellVolume> GridFile::takeCells()
{
    GridData& grid = state_->grid;
    if (!hasVolume(*grid.set))
        throw InputError(
            grid.path, fmt::format("the data is flat: none of its {} cells has a volume", grid.set->GetNumberOfCells()),
            "a 3D field to sample, or --surface boundary to draw the flat data itself");
    const std::string& name = state_->facts.vectorsName;
    const auto vectors = grid.release(name);
    const auto scalars =
        state_->hasOwnScalar() ? grid.release(state_->facts.scalarName) : vtkSmartPointer<vtkFloatArray>();
    auto cells = std::make_shared<GridVolume>(std::move(grid.set), vectors, scalars, grid.path);
    cells->longest = grid.maxMagnitude[name];
    cells->areMeans = !state_->arrays.vectors.onPoints;
    return cells;
}

GridField GridFile::takeVectors()
{
    State& s = *state_;
    GridData& grid = s.grid;
    const std::string& name = s.facts.vectorsName;
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
        if (!s.request.halves) return field;
        const auto mine = grid.counted();
        if (field.maxMagnitude > kLargestHalf) halves.found = countBeyondHalves(*values, mine ? &*mine : nullptr);
        makeHalf(field, values);
    }
    grid.tallies.push_back(halves);
    return field;
}

std::optional<GridField> GridFile::takeScalar()
{
    if (!state_->hasOwnScalar()) return std::nullopt;
    GridData& grid = state_->grid;
    const std::string& name = state_->facts.scalarName;
    GridField field = gridStructure(*grid.image(), grid.piece);
    field.name = name;
    field.maxMagnitude = grid.maxMagnitude[name];
    setSamples(field, grid.release(name));
    state_->keepOwners(field);
    return field;
}

bool GridFile::vectorsAreBorrowed() const
{
    return state_->borrowed;
}

const FieldFacts& GridFile::facts() const
{
    return state_->facts;
}

const std::vector<Tally>& GridFile::tallies() const
{
    return state_->grid.tallies;
}

}  // namespace aeolic
