/// The PLY reader: what it takes for a surface has as many normals and values as points and polygons.
#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "aeolic/error.h"
#include "memory_file.h"
#include "reader/vtk/format_readers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const aeolic::fuzz::MemoryFile file(data, size);
    try {
        const auto read = aeolic::readPly(file.path(), {});
        auto* const surface = vtkPolyData::SafeDownCast(read);
        for (int i = 0; i < surface->GetPointData()->GetNumberOfArrays(); ++i)
            if (surface->GetPointData()->GetArray(i)->GetNumberOfTuples() != surface->GetNumberOfPoints())
                __builtin_trap();
        for (int i = 0; i < surface->GetCellData()->GetNumberOfArrays(); ++i)
            if (surface->GetCellData()->GetArray(i)->GetNumberOfTuples() != surface->GetNumberOfCells())
                __builtin_trap();
    } catch (const aeolic::InputError& error) {
        aeolic::fuzz::requireOneLine(error.what());
    }
    return 0;
}
