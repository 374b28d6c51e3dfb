#include "data/vtk/grid_file.h"

#include <fmt/format.h>
#include <vtkCellData.h>
#include <vtkCellDataToPointData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <map>

#include "aeolic/error.h"
#include "base/half.h"
#include "data/vtk/cut.h"
#include "data/vtk/file_reader.h"
#include "data/vtk/half_slabs.h"
#include "data/vtk/isosurface.h"
#include "data/vtk/messages.h"
#include "data/vtk/polydata_mesh.h"
#include "data/vtk/uniform_grid.h"

namespace aeolic {

struct GridFile::State {
    std::string path;
    std::string arrays;
    ArrayChoices offered;
    ArrayInfo vectors;
    std::optional<ScalarChoice> scalar, contour;
    std::string colorBy;
    vtkSmartPointer<vtkDataSet> data;  // Structure and the chosen arrays, as floats on the points; all else is gone.
    std::map<std::string, double> maxMagnitude;  // Of each of these arrays.
    std::vector<Tally> tallies;
    std::vector<double> timeSteps;
    std::optional<ImagePiece> piece;  // Where only a brick was read.
    bool wantsHalves = false;
    std::optional<HalfVectors> halves;  // Where they were read as such: then `data` has no arrays.

    bool canReadHalves(const FileReader& reader) const;
    void choose(const std::vector<ArrayInfo>& available, const GridRequest& request);
    std::vector<ArrayInfo> chosen() const;
    void prepare(vtkDataSet& raw);
    void addMagnitude(const std::optional<ScalarChoice>& choice);
    std::optional<CountedSamples> counted() const;
    LoadedSurface uniformIsosurface(const SurfaceSpec& spec);
    vtkImageData* image() const { return vtkImageData::SafeDownCast(data); }
    vtkSmartPointer<vtkFloatArray> take(const std::string& name);
};

namespace {

bool same(const ArrayInfo& a, const ArrayInfo& b)
{
    return a.name == b.name && a.onPoints == b.onPoints;
}

vtkSmartPointer<vtkDataSet> structureOf(vtkDataSet& data)
{
    auto structure = vtkSmartPointer<vtkDataSet>::Take(data.NewInstance());
    structure->CopyStructure(&data);
    return structure;
}

vtkSmartPointer<vtkFloatArray> toPoints(vtkDataSet& data, vtkFloatArray& cellValues, const std::string& path)
{
    auto input = structureOf(data);
    input->GetCellData()->AddArray(&cellValues);
    const VtkMessages messages;
    vtkNew<vtkCellDataToPointData> filter;
    filter->SetInputData(input);
    filter->Update();
    vtkSmartPointer<vtkFloatArray> values =
        vtkFloatArray::SafeDownCast(filter->GetOutput()->GetPointData()->GetArray(cellValues.GetName()));
    if (messages.failed() || !values)
        throw InputError(
            path,
            fmt::format("array '{}' cannot be brought to the points ({})", cellValues.GetName(), messages.firstError()),
            "sound cells");
    return values;
}

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
    arrays = listArrays(available);
    offered = offeredArrays(available);
    vectors = chooseVectors(available, request.vectors, path);
    if (!request.colorBy.empty()) scalar = findScalar(available, request.colorBy, path);
    if (request.contour.empty()) return;
    contour = findScalar(available, request.contour, path);
    if (!contour) throw InputError(path, "no array '" + request.contour + "' for the isosurface", "one of: " + arrays);
}

std::vector<ArrayInfo> GridFile::State::chosen() const
{
    std::vector<ArrayInfo> all{vectors};
    for (const auto& choice : {scalar, contour})
        if (choice && std::none_of(all.begin(), all.end(), [&](const ArrayInfo& a) { return same(a, choice->array); }))
            all.push_back(choice->array);
    return all;
}

void GridFile::State::prepare(vtkDataSet& raw)
{
    data = structureOf(raw);
    if (vtkDataArray* ghosts = raw.GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()))
        data->GetCellData()->AddArray(ghosts);
    for (const ArrayInfo& array : chosen()) {
        vtkDataArray* source = findArray(raw, array.name, array.onPoints);
        const vtkIdType tuples = array.onPoints ? raw.GetNumberOfPoints() : raw.GetNumberOfCells();
        if (!source || source->GetNumberOfTuples() != tuples)
            throw InputError(
                path, fmt::format("array '{}' has {} values", array.name, source ? source->GetNumberOfTuples() : 0),
                fmt::format("{}, one for each of the {}", tuples, array.onPoints ? "points" : "cells"));
        vtkSmartPointer<vtkFloatArray> values = toFloats(source);
        auto* all = array.onPoints ? static_cast<vtkFieldData*>(raw.GetPointData()) : raw.GetCellData();
        all->RemoveArray(array.name.c_str());  // Frees doubles at once; floats are shared.
        const auto mine = counted();
        const MaskResult result = maskInvalid(*values, raw, array.onPoints, mine ? &*mine : nullptr);
        tallies.push_back(result.tally(path, array));
        maxMagnitude[array.name] = result.maxMagnitude;
        if (!array.onPoints) {
            values = toPoints(raw, *values, path);
            maxMagnitude[array.name] = maskInvalid(*values, *data, true).maxMagnitude;
        }
        data->GetPointData()->AddArray(values);
    }
    addMagnitude(scalar);
    addMagnitude(contour);
}

/// Of a brick, its own samples.
std::optional<CountedSamples> GridFile::State::counted() const
{
    if (!piece) return std::nullopt;
    return piece->countedIn(piece->extent());
}

void GridFile::State::addMagnitude(const std::optional<ScalarChoice>& choice)
{
    if (!choice || !choice->magnitude || data->GetPointData()->HasArray(choice->label().c_str())) return;
    if (&choice == &scalar && same(choice->array, vectors)) return;  // Computed from the sampled vector instead.
    auto* source = vtkFloatArray::SafeDownCast(data->GetPointData()->GetArray(choice->array.name.c_str()));
    auto lengths = magnitudes(*source);
    lengths->SetName(choice->label().c_str());
    data->GetPointData()->AddArray(lengths);
    maxMagnitude[choice->label()] = maxMagnitude[choice->array.name];
}

vtkSmartPointer<vtkFloatArray> GridFile::State::take(const std::string& name)
{
    vtkSmartPointer<vtkFloatArray> values = vtkFloatArray::SafeDownCast(data->GetPointData()->GetArray(name.c_str()));
    data->GetPointData()->RemoveArray(name.c_str());
    return values;
}

/// Of a brick perhaps nothing: what is left to be told is whether any other has something.
LoadedSurface GridFile::State::uniformIsosurface(const SurfaceSpec& spec)
{
    LoadedSurface surface;
    surface.where = path;
    surface.cutOut = true;
    surface.piece = piece.has_value();
    GridField grid = gridStructure(*image(), piece);
    auto* values = vtkFloatArray::SafeDownCast(data->GetPointData()->GetArray(contour->label().c_str()));
    setSamples(grid, values);
    double range[2];
    values->GetFiniteRange(range, 0);
    surface.cutRange = {range[0], range[1]};
    const Brick all{{0, 0, 0}, {grid.dims[0] - 1, grid.dims[1] - 1, grid.dims[2] - 1}};
    surface.mesh = isosurface(grid, piece ? piece->own : all, spec.value);
    surface.topology = 1;  // Only where the places are the same too: withPlaces().
    if (piece) return surface;
    requireIsosurface(spec, path, surface.cutRange, surface.mesh.triangles.size());
    surface.mesh.order = {};
    return surface;
}

void requirePoints(const std::vector<ArrayInfo>& arrays, const std::string& path)
{
    for (const ArrayInfo& array : arrays)
        if (!array.onPoints)
            throw InputError(path, "array '" + array.name + "' is on the cells", "one on the points, or --bricks off");
}

GridOutline outlineOfGridFile(const std::string& path, const GridRequest& request)
{
    const FileReader reader(path, FileReader::Use::field);
    const GridIndex dims = reader.imageDims();
    if (!reader.announcesArrays() || *std::min_element(dims.begin(), dims.end()) < 2) return {};
    const std::vector<ArrayInfo>& arrays = reader.announcedArrays();
    GridField grid;
    grid.dims = dims;
    grid.spacingWorld = reader.imageSpacing();
    const ArrayInfo vectors = chooseVectors(arrays, request.vectors, path);
    GridOutline outline{grid, std::nullopt};
    outline.vectors->name = vectors.name;
    outline.vectors->components = vectors.components;
    const auto scalar = request.colorBy.empty() ? std::nullopt : findScalar(arrays, request.colorBy, path);
    if (!scalar || (scalar->magnitude && same(scalar->array, vectors))) return outline;
    outline.scalar = grid;
    outline.scalar->name = scalar->label();
    outline.scalar->components = 1;
    return outline;
}

GridFile::GridFile(const std::string& path, const GridRequest& request, const FieldPart& part,
                   const ProgressReport& progress)
    : state_(std::make_unique<State>())
{
    state_->path = path;
    state_->colorBy = request.colorBy;
    FileReader reader(path, FileReader::Use::field, request.timeInFile);
    state_->timeSteps = reader.timeSteps();
    if (reader.announcesArrays()) {
        state_->choose(reader.announcedArrays(), request);
        reader.keepOnly(state_->chosen());
    }
    if (part.split()) {
        state_->piece = reader.keepBrick(part, !request.contour.empty());
        requirePoints(state_->chosen(), path);
    }
    state_->wantsHalves = request.halves;
    if (state_->canReadHalves(reader)) {
        readHalves(reader, progress);
        return;
    }
    const auto object = reader.read(progress, "reading the field");
    auto* raw = vtkDataSet::SafeDownCast(object);
    if (!raw || raw->GetDataObjectType() == VTK_POLY_DATA)
        throw InputError(path, "it holds " + kindOf(*object), "a grid to sample (a surface goes to --surface)");
    if (!state_->piece || !state_->piece->brick.empty()) checkStructure(*raw, path);
    if (!reader.announcesArrays()) state_->choose(arraysOf(*raw), request);
    state_->prepare(*raw);
    if (const auto image = asUniform(*state_->data, path)) state_->data = image;
}

/// Image data of which nothing but the vectors at its points is needed. Small files are read at once.
bool GridFile::State::canReadHalves(const FileReader& reader) const
{
    constexpr std::int64_t worthwhile = 1 << 24;  // Samples.
    const GridIndex dims = reader.imageDims();
    return wantsHalves && reader.announcesArrays() && chosen().size() == 1 && vectors.onPoints && !contour &&
           (!scalar || (scalar->magnitude && same(scalar->array, vectors))) && vectors.components == 3 &&
           *std::min_element(dims.begin(), dims.end()) >= 2 && dims[0] * dims[1] * dims[2] >= worthwhile;
}

void GridFile::readHalves(FileReader& reader, const ProgressReport& progress)
{
    State& s = *state_;
    const ImagePiece piece = s.piece ? *s.piece : *reader.wholeImage();
    s.halves = aeolic::readHalves(reader, piece, s.vectors, s.path, progress);
    s.maxMagnitude[s.vectors.name] = s.halves->masked.maxMagnitude;
    s.tallies.push_back(s.halves->masked.tally(s.path, s.vectors));
    s.data = asUniform(*s.halves->structure, s.path);
}

GridFile::~GridFile() = default;

bool GridFile::uniform() const
{
    return state_->piece || (state_->image() && state_->image()->GetDataDimension() == 3);
}

LoadedSurface GridFile::cut(const SurfaceSpec& spec, bool withArrays, const ProgressReport& progress)
{
    progress("cutting the surface out", 0);
    LoadedSurface surface;
    if (state_->contour && uniform()) {
        surface = state_->uniformIsosurface(spec);
    } else {
        const auto polyData =
            cutSurface(state_->piece ? *wholeStructure(*state_->image(), *state_->piece) : *state_->data, spec,
                       state_->contour ? state_->contour->label() : "", state_->path);
        SurfaceArrays arrays;
        if (withArrays) arrays = {true, state_->vectors.name, state_->colorBy};
        surface = meshFromPolyData(*polyData, state_->path, arrays, true);
    }
    // Slices and isosurfaces of a grid that moves, or of other values, may have as many triangles by chance.
    if (spec.kind != SurfaceSpec::Kind::boundary) surface.topology = withPlaces(surface.topology, surface.mesh);
    surface.mesh.name = spec.text;
    surface.arrays = state_->arrays;
    surface.offered = state_->offered;
    progress("cutting the surface out", 1);
    return surface;
}

void GridFile::resample(std::optional<double> spacing, const ProgressReport& progress)
{
    const auto image = resampleToUniform(*state_->data, spacing, state_->path, progress);
    state_->data = structureOf(*image);
    for (auto& [name, largest] : state_->maxMagnitude) {
        auto* values = vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray(name.c_str()));
        largest = maskInvalid(*values, *image, true).maxMagnitude;
        state_->data->GetPointData()->AddArray(values);
    }
}

GridField GridFile::takeVectors()
{
    State& s = *state_;
    const std::string& name = s.vectors.name;
    GridField field = gridStructure(*s.image(), s.piece);
    field.name = name;
    field.maxMagnitude = s.maxMagnitude[name];
    Tally halves{Tally::Of::halves, nameOf(s.path, s.vectors)};
    halves.longest = field.maxMagnitude;
    if (s.halves) {
        field.samples = std::move(s.halves->samples);
        field.precision = FieldPrecision::float16;
        halves.found = s.halves->clamped;
    } else {
        auto values = s.take(name);
        setSamples(field, values);
        if (!s.wantsHalves) return field;
        const auto mine = s.counted();
        if (field.maxMagnitude > kLargestHalf) halves.found = countBeyondHalves(*values, mine ? &*mine : nullptr);
        makeHalf(field, values);
    }
    s.tallies.push_back(halves);
    return field;
}

std::optional<GridField> GridFile::takeScalar()
{
    if (!state_->scalar || scalarIsVectorLength()) return std::nullopt;
    const std::string name = state_->scalar->label();
    GridField field = gridStructure(*state_->image(), state_->piece);
    field.name = name;
    field.maxMagnitude = state_->maxMagnitude[name];
    setSamples(field, state_->take(name));
    return field;
}

bool GridFile::hasScalar() const
{
    return state_->scalar.has_value();
}

bool GridFile::scalarIsVectorLength() const
{
    return state_->scalar && state_->scalar->magnitude && same(state_->scalar->array, state_->vectors);
}

std::string GridFile::scalarLabel() const
{
    return state_->scalar ? state_->scalar->label() : "";
}

ArrayChoices GridFile::offered() const
{
    return state_->offered;
}

std::string GridFile::arrays() const
{
    return state_->arrays;
}

const std::vector<double>& GridFile::timeSteps() const
{
    return state_->timeSteps;
}

const std::vector<Tally>& GridFile::tallies() const
{
    return state_->tallies;
}

}  // namespace aeolic
