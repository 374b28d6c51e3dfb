#include "reader/cgns/cgns_parts.h"
#include "reader/exodus/exodus_parts.h"
#include "reader/vtk/hdf/hdf_file.h"
#include "reader/vtk/modules/modules.h"
#include "reader/vtk/netcdf/netcdf_grid.h"

extern "C" const aeolic::Hdf5Module aeolicHdf5Module{aeolic::openCgnsFile, aeolic::openExodusFile, aeolic::openVtkHdf,
                                                     aeolic::openNetcdfGrid};
