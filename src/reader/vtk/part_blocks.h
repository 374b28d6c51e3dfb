#pragma once

#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <string>
#include <vector>

#include "reader/vtk/own_reader.h"

namespace aeolic {

/// The parts of a file, as VTK's data sets.
class PartBlocks : public OwnReader {
public:
    PartBlocks(std::unique_ptr<PartSource> source, const std::string& path, FileUse use);

    const std::vector<PartInfo>& parts() override { return source_->parts(); }
    void keepParts(const std::vector<std::string>& wanted) override;
    void requireAtTime(const std::vector<std::string>& arrays) const override { source_->requireAtTime(arrays); }
    void keepPolyhedra() override { source_->keepPolyhedra(); }

    /// A multi-block data set with the parts' names: polygons of a part that is faces, an unstructured grid of one that
    /// fills space. Every block has all `kept` arrays; values that the file does not have are NaN. Of a field, parts
    /// that have their points in common are one block.
    vtkSmartPointer<vtkDataObject> read(const std::vector<ArrayInfo>& kept) override;

    /// The only block.
    vtkSmartPointer<vtkDataObject> readPieces(const std::vector<ArrayInfo>& kept, const PieceRun& run) override;

private:
    std::unique_ptr<PartSource> source_;
};

}  // namespace aeolic
