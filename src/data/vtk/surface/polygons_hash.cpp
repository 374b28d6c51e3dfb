#include "data/vtk/surface/polygons_hash.h"

#include <vtkCellArray.h>

#include "base/fnv.h"
#include "data/loaded_surface.h"

namespace aeolic {

std::uint64_t polygonsHash(vtkPolyData& polyData)
{
    Fnv hash;
    const auto mix = [&](vtkIdType number) { hash.mix(std::uint64_t(number)); };
    mix(polyData.GetNumberOfPoints());
    for (vtkCellArray* cells : {polyData.GetPolys(), polyData.GetStrips()}) {
        vtkIdType size = 0;
        const vtkIdType* corners = nullptr;
        mix(cells->GetNumberOfCells());
        for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell) {
            cells->GetCellAtId(cell, size, corners);
            mix(size);
            for (vtkIdType k = 0; k < size; ++k) mix(corners[k]);
        }
    }
    return knownTopology(hash.value);
}

}  // namespace aeolic
