#pragma once

#include <vtkAlgorithm.h>
#include <vtkSmartPointer.h>

#include <string>

#include "description/file_kinds.h"

namespace aeolic {

using ReaderMaker = vtkSmartPointer<vtkAlgorithm> (*)();

/// How a file of one of the kinds (description/file_kinds.h) is read.
struct FileFormat {
    const char* kind;        ///< What is in it, as kindOf() (data_kind.h) says it.
    ReaderMaker makeReader;  ///< Null where VTK does not read it.
};

/// The format of `extension`. Throws InputError where there is none, or none fit for `use`: it begins with `path`.
FileFormat chooseFormat(const std::string& path, const std::string& extension, FileUse use);

}  // namespace aeolic
