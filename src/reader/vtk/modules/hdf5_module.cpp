#include "reader/parts/open_parts.h"
#include "reader/vtk/format_readers.h"
#include "reader/vtk/modules/modules.h"

extern "C" const aeolic::Hdf5Module aeolicHdf5Module{aeolic::openCgnsFile, aeolic::openExodusFile, aeolic::openVtkHdf,
                                                     aeolic::openNetcdfGrid};
