#include "data/vtk/memory/memory_grid.h"

#include <fmt/format.h>

#include <limits>

#include "aeolic/error.h"
#include "data/vtk/checks/cell_checks.h"
#include "data/vtk/memory/memory_arrays.h"

namespace aeolic {

vtkSmartPointer<vtkImageData> imageFromMemory(const Grid& grid, const std::string& name)
{
    double samples = 1;
    for (const std::int64_t count : grid.dims) samples *= double(count);
    for (const std::int64_t count : grid.dims)
        if (count < 0 || count > std::numeric_limits<int>::max() || samples > 1e15)
            throw InputError(name, fmt::format("{} x {} x {} samples", grid.dims[0], grid.dims[1], grid.dims[2]),
                             "how many there are in x, y and z");
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(int(grid.dims[0]), int(grid.dims[1]), int(grid.dims[2]));
    image->SetOrigin(grid.origin.data());
    image->SetSpacing(grid.spacing.data());
    addArrays(*image, grid.pointArrays, true, name);
    addArrays(*image, grid.cellArrays, false, name);
    requireSoundData(*image, name);
    return image;
}

}  // namespace aeolic
