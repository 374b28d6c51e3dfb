#include "data/vtk/grid/grid_outline.h"

#include <algorithm>

#include "data/vtk/file_reader.h"
#include "data/vtk/grid/grid_arrays.h"

namespace aeolic {

GridOutline outlineOfGridFile(const std::string& path, const GridRequest& request)
{
    FileReader reader(path, FileReader::Use::field);
    const GridIndex dims = reader.imageDims();
    if (!reader.announcesArrays() || *std::min_element(dims.begin(), dims.end()) < 2) return {};
    const GridArrays arrays = chooseArrays(reader.announcedArrays(), request, path);
    GridField grid;
    grid.dims = dims;
    grid.spacingWorld = reader.imageSpacing();
    GridOutline outline{grid, std::nullopt};
    outline.vectors->name = arrays.vectors.name;
    outline.vectors->components = arrays.vectors.components;
    if (!arrays.scalar || arrays.partOfVectors() != ArrayPart::whole) return outline;
    outline.scalar = grid;
    outline.scalar->name = arrays.scalar->label();
    outline.scalar->components = 1;
    return outline;
}

}  // namespace aeolic
