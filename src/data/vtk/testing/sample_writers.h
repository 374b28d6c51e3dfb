#pragma once

/// What the sample files of grids and sheets are written with; compiled into the tests only.

#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <string>

#include "data/vtk/testing/sample_files.h"

namespace aeolic::test {

std::string extension(const std::string& path);

vtkSmartPointer<vtkDataArray> newArray(bool doubles, const char* name, int components, vtkIdType tuples);

/// Writes the XML, parallel XML or legacy format that the extension names.
void writeDataSet(const std::string& path, vtkDataSet& data, Encoding encoding);

}  // namespace aeolic::test
