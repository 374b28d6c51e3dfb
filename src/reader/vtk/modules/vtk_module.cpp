#include <vtkSTLReader.h>

#include "reader/vtk/modules/ensight_reader.h"
#include "reader/vtk/modules/modules.h"
#include "reader/vtk/modules/nrrd_reader.h"

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
