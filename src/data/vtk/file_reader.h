#pragma once

#include <vtkAlgorithm.h>
#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <string>
#include <vector>

#include "data/progress.h"
#include "data/vtk/arrays.h"

namespace aeolic {

/// One data file: opened and asked what it holds first, then read with the arrays that are needed and no others.
/// Every failure is an InputError with one line that begins with the file's name.
class FileReader {
public:
    enum class Use { surface, field, any };

    /// Checks that the file exists and is of a kind fit for `use`, and reads its header.
    FileReader(std::string path, Use use);
    ~FileReader();

    /// Formats of the XML family say what is inside before it is read; others need read() first.
    bool announcesArrays() const { return announces_; }
    const std::vector<ArrayInfo>& announcedArrays() const { return announced_; }

    /// Leaves out all arrays but these (and masks). Only where arrays are announced.
    void keepOnly(const std::vector<ArrayInfo>& arrays);

    const std::vector<double>& timeSteps() const { return timeSteps_; }

    /// Throws InputError before reading if what was kept needs more memory than there is.
    vtkSmartPointer<vtkDataObject> read(const ProgressReport& progress, const char* what);

private:
    void requireMemoryToRead() const;

    std::string path_, extension_;
    std::uint64_t fileBytes_ = 0;
    bool announces_ = false;
    std::vector<ArrayInfo> announced_, kept_;
    std::vector<double> timeSteps_;
    std::vector<std::int64_t> wholeDims_;   // Points in x, y, z of an image; empty for anything else.
    vtkSmartPointer<vtkAlgorithm> reader_;  // Null for PLY.
};

/// ".vtp", in lower case.
std::string extensionOf(const std::string& path);

/// "image data", "an unstructured grid" …
std::string kindOf(vtkDataObject& data);

}  // namespace aeolic
