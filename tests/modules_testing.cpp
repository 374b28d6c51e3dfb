// The tests have what the reader's modules hold in themselves.
#include "reader/vtk/modules/modules.h"

namespace aeolic {

const Hdf5Module& hdf5Module()
{
    return aeolicHdf5Module;
}

const VtkModule& vtkModule()
{
    return aeolicVtkModule;
}

}  // namespace aeolic
