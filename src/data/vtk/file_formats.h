#pragma once

#include <vtkAlgorithm.h>
#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <string>

namespace aeolic {

enum class FileUse { surface, field, any };

/// One kind of file that can be read, known by its extension.
struct FileFormat {
    const char* extension;  ///< ".vtp", in lower case.
    FileUse use;
    const char* kind;                               ///< What is in it, as kindOf() says it.
    vtkSmartPointer<vtkAlgorithm> (*makeReader)();  ///< Null for PLY and legacy VTK.
};

/// The format of `extension`. Throws InputError where there is none, or none fit for `use`: it begins with `path`.
const FileFormat& chooseFormat(const std::string& path, const std::string& extension, FileUse use);

/// ".vtp", in lower case.
std::string extensionOf(const std::string& path);

/// "image data", "an unstructured grid" …
std::string kindOf(vtkDataObject& data);

}  // namespace aeolic
