#include <vtkSTLReader.h>

#include "reader/vtk/format_readers.h"
#include "reader/vtk/modules/modules.h"

namespace aeolic {
namespace {

template <class Reader>
vtkSmartPointer<vtkAlgorithm> make()
{
    return vtkSmartPointer<Reader>::New();
}

}  // namespace
}  // namespace aeolic

extern "C" const aeolic::VtkModule aeolicVtkModule{aeolic::make<vtkSTLReader>, aeolic::makeNrrdReader,
                                                   aeolic::openEnSight6};
