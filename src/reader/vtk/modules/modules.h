#pragma once

#include <vtkAlgorithm.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <optional>
#include <string>

#include "description/file_kinds.h"
#include "reader/parts/part_source.h"
#include "reader/vtk/own_reader.h"

namespace aeolic {

// Formats whose libraries bring along dozens of others. They stand in modules beside the program, which loads them when
// such a file comes: to load them takes longer than to read a small file of another kind.

/// Formats that lie in HDF5 or netCDF.
struct Hdf5Module {
    std::unique_ptr<PartSource> (*openCgns)(const std::string& path, std::optional<double> time);
    std::unique_ptr<PartSource> (*openExodus)(const std::string& path, std::optional<double> time);
    std::unique_ptr<OwnReader> (*openVtkHdf)(const std::string& path, FileUse use, std::optional<double> time);
    std::unique_ptr<OwnReader> (*openNetcdfGrid)(const std::string& path, FileUse use, std::optional<double> time);
};

/// VTK's readers beside those of its XML formats.
struct VtkModule {
    vtkSmartPointer<vtkAlgorithm> (*makeStl)();
    vtkSmartPointer<vtkAlgorithm> (*makeNrrd)();
    std::unique_ptr<OwnReader> (*openEnSight6)(const std::string& path, FileUse use, std::optional<double> time);
};

/// Loads the module at first. Throws InputError where it is not there.
const Hdf5Module& hdf5Module();
const VtkModule& vtkModule();

}  // namespace aeolic

// What the modules are looked up by.
extern "C" const aeolic::Hdf5Module aeolicHdf5Module;
extern "C" const aeolic::VtkModule aeolicVtkModule;
