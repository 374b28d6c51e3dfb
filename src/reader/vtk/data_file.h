#pragma once

#include <vtkAlgorithm.h>
#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "data/progress.h"
#include "data/vtk/arrays.h"
#include "reader/vtk/format_registry.h"
#include "reader/vtk/own_reader.h"

namespace aeolic {

class VtkMessages;

/// One data file: opened and asked what it holds first, then read with the arrays that are needed and no others.
/// Every failure is an InputError with one line that begins with the file's name.
class DataFile {
public:
    /// Checks that the file exists and is of a kind fit for `use`, and reads its header. `time`: which of timeSteps()
    /// will be read, where the file has several; none: the first.
    DataFile(std::string path, FileUse use, std::optional<double> time = std::nullopt);
    ~DataFile();

    const char* kind() const { return kind_->kind; }  ///< "image data": what files of its ending hold.

    /// Files of the XML family tell their content before it is read. Others need read() first.
    bool announcesArrays() const { return announces_; }
    const std::vector<ArrayInfo>& announcedArrays();

    /// Leaves out all arrays but these (and masks). Only where arrays are announced.
    void keepOnly(const std::vector<ArrayInfo>& arrays);

    /// The cells will be looked up as they are, polyhedra whole. Otherwise some formats cut them into simpler cells.
    void keepPolyhedra()
    {
        if (own_) own_->keepPolyhedra();
    }

    /// Throws InputError where the file has one of the arrays at other times alone.
    void requireAtTime(const std::vector<std::string>& arrays) const
    {
        if (own_) own_->requireAtTime(arrays);
    }

    /// Leaves out all parts but these; empty: the usual ones. Only where parts() are known; other files are read with
    /// all that they have. Comes before arrays are asked for.
    void keepParts(const std::vector<std::string>& parts);

    /// What the file says of its parts, in the order in which they are read.
    std::vector<PartInfo> parts() const { return own_ ? own_->parts() : std::vector<PartInfo>(); }

    /// Whether values were made floats when they were read; announcedArrays() say what they are in the file. The arrays
    /// are those of the parts that are kept.
    bool readsFloats() const { return own_ && own_->readsFloats(); }

    /// First and last sample in x, y, z of image data that says so in its header; nothing for anything else.
    const std::optional<std::array<int, 6>>& wholeExtent() const { return wholeExtent_; }
    glm::dvec3 imageSpacing() const;  ///< World units between its samples.

    const std::vector<double>& timeSteps() const { return timeSteps_; }

    /// All of it, or only these samples of image data, first and last in x, y and z. Throws InputError before reading
    /// if what was kept needs more memory than there is.
    vtkSmartPointer<vtkDataObject> read(const ProgressReport& progress, const char* what,
                                        const std::optional<std::array<int, 6>>& extent = std::nullopt);

    /// Only these of its pieces, as one data set. Of VTK's parallel files it is the first of them alone.
    vtkSmartPointer<vtkDataObject> readPieces(const PieceRun& run);

    /// The data that were read are not needed any longer: the next read begins anew.
    void forget();

private:
    vtkSmartPointer<vtkDataObject> withLinearCells(vtkSmartPointer<vtkDataObject> data) const;
    void requireMemoryToRead(const std::optional<std::array<int, 6>>& extent) const;
    std::string placeOf(const VtkMessages& messages) const;
    template <class Update>
    vtkSmartPointer<vtkDataObject> update(const Update& run);

    std::string path_;
    const FileKind* kind_ = nullptr;
    const FormatReader* format_ = nullptr;
    std::uint64_t fileBytes_ = 0;
    bool announces_ = false;
    bool asked_ = false;  // Our own reader, for its arrays.
    std::vector<ArrayInfo> announced_, kept_;
    std::vector<double> timeSteps_;
    std::optional<std::array<int, 6>> wholeExtent_;  // Of an image.
    std::unique_ptr<OwnReader> own_;
    vtkSmartPointer<vtkAlgorithm> reader_;  // Null for what our own code reads.
};

}  // namespace aeolic
