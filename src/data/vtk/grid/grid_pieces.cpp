#include <fmt/format.h>
#include <vtkUnstructuredGrid.h>

#include "aeolic/error.h"
#include "data/vtk/data_objects.h"
#include "data/vtk/grid/grid_file_state.h"
#include "data/vtk/joined_arrays.h"
#include "data/vtk/surface/cut.h"
#include "data/vtk/surface/polydata_mesh.h"

namespace aeolic {

namespace {

/// Reads pieces of one file, or parts that are files themselves.
class PieceReader {
public:
    PieceReader(const std::string& path, const GridRequest& request) : request_(request) { open(path); }

    FileReader& first() { return *reader_; }

    /// Where the piece that was read last lies, for messages.
    const std::string& path() const { return path_; }

    void keepOnly(const std::vector<ArrayInfo>& arrays)
    {
        kept_ = arrays;
        reader_->keepOnly(arrays);
    }

    vtkSmartPointer<vtkDataObject> read(int number)
    {
        if (request_.otherFiles.empty()) return reader_->readPiece(number);
        if (number > 0) {
            open(request_.otherFiles[std::size_t(number) - 1]);
            reader_->keepOnly(kept_);
        }
        return reader_->read({}, "");
    }

private:
    void open(const std::string& path)
    {
        path_ = path;
        reader_.emplace(path, FileReader::Use::field, request_.timeInFile);
        if (request_.lookUp) reader_->keepPolyhedra();
        reader_->keepParts(request_.parts);
        reader_->requireAtTime(request_.arrays());
    }

    const GridRequest& request_;
    std::string path_;
    std::optional<FileReader> reader_;
    std::vector<ArrayInfo> kept_;
};

}  // namespace

std::vector<std::shared_ptr<GridFile>> GridFile::readPieces(const std::string& path, const GridRequest& request,
                                                            const PieceRun& run, const ProgressReport& progress)
{
    PieceReader reader(path, request);
    State common;
    common.request = request;
    common.grid.path = path;
    common.facts.timeSteps = reader.first().timeSteps();
    common.choose(reader.first().announcedArrays());
    reader.keepOnly(common.arrays.all());

    std::vector<std::shared_ptr<GridFile>> pieces;
    for (int number = run.begin; number < run.end; ++number) {
        progress("reading the field", double(number - run.begin) / (run.end - run.begin));
        const std::shared_ptr<GridFile> piece(new GridFile(path, request));
        State& state = *piece->state_;
        state.facts = common.facts;
        state.arrays = common.arrays;
        const auto object = reader.read(number);
        auto* cells = vtkUnstructuredGrid::SafeDownCast(object);
        if (!cells) throw InputError(reader.path(), "it holds " + kindOf(*object), "pieces of cells");
        if (cells->GetNumberOfCells() == 0) {
            state.grid.set = vtkSmartPointer<vtkUnstructuredGrid>::New();
        } else {
            checkStructure(*cells, reader.path());
            makeVectors(*cells, state.arrays.all(), &state.arrays.vectors, path);
            for (const ArrayInfo& array : state.arrays.all())
                if (!findArray(*cells, array.name, array.onPoints))
                    throw InputError(
                        reader.path(),
                        fmt::format("no array '{}' on its {}", array.name, array.onPoints ? "points" : "cells"),
                        "the arrays of the first part in every part");
            state.grid.take(*cells, state.arrays);
        }
        pieces.push_back(piece);
    }
    progress("reading the field", 1);
    return pieces;
}

bool GridFile::empty() const
{
    return state_->grid.set->GetNumberOfCells() == 0;
}

PointMeans GridFile::outerMeans() const
{
    return empty() ? PointMeans{} : state_->grid.outerMeans();
}

void GridFile::takeMeans(const PointMeans& means)
{
    if (empty()) return;
    if (!means.points.empty()) state_->grid.takeMeans(means);
    state_->grid.addMagnitudes(state_->arrays);
}

CutOutline GridFile::outlineOf(const SurfaceSpec& spec) const
{
    return empty() ? CutOutline{} : outlineOfCut(*state_->grid.set, spec, state_->contourArray(spec));
}

LoadedSurface GridFile::cutPiece(const SurfaceSpec& spec, const CutArrays& wanted, const CutOutline& all,
                                 int number) const
{
    const std::string& path = state_->grid.path;
    SurfaceArrays arrays = state_->cutArrays(wanted);
    arrays.part = {number, number + 2};  // One of several.
    const auto polygons = empty() ? vtkSmartPointer<vtkPolyData>::New()
                                  : cutSurface(*state_->grid.set, spec, state_->contourArray(spec), path, all);
    return meshOfCut(*polygons, spec, path, arrays);
}

}  // namespace aeolic
