#pragma once

#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "data/progress.h"
#include "data/reading/reader_pool.h"
#include "data/vtk/arrays.h"
#include "data/vtk/grid/image_piece.h"
#include "data/vtk/reader_messages.h"

namespace aeolic {

/// One data file, which another process reads: opened and asked what it holds first, then read with the arrays that are
/// needed and no others. Every failure is an InputError with one line that begins with the file's name, also where the
/// other process ends.
class FileReader {
public:
    using Use = FileUse;

    /// Checks that the file exists and is of a kind fit for `use`, and reads its header. `time`: which of timeSteps()
    /// will be read, where the file has several; none: the first.
    FileReader(std::string path, Use use, std::optional<double> time = std::nullopt);

    /// Files of the XML family tell their content before it is read. Others need read() first.
    bool announcesArrays() const { return facts_.announcesArrays; }
    const std::vector<ArrayInfo>& announcedArrays();

    /// Leaves out all arrays but these (and masks). Only where arrays are announced.
    void keepOnly(const std::vector<ArrayInfo>& arrays);

    /// The cells will be looked up as they are, polyhedra whole. Otherwise some formats cut them into simpler cells.
    void keepPolyhedra() { request_.polyhedra = true; }

    /// These arrays must be there at the time that is read: announcedArrays() throws InputError where one of them is
    /// there at other times alone.
    void requireAtTime(const std::vector<std::string>& arrays);

    /// Leaves out all parts but these; empty: the usual ones. Only where parts() are known; other files are read with
    /// all that they have. Comes before arrays are asked for.
    void keepParts(const std::vector<std::string>& parts);

    /// What the file says of its parts, in the order in which they are read.
    const std::vector<PartInfo>& parts() const { return facts_.parts; }

    /// Samples in x, y, z of image data that says so in its header; zeros for anything else.
    GridIndex imageDims() const;
    glm::dvec3 imageSpacing() const { return facts_.spacingWorld; }  ///< World units between them.

    /// Reads only the brick of `part`, its ghost samples included, and `withNeighbours` one more layer all around. Only
    /// for image data that is read in pieces (.vti, .pvti, .nhdr, .nrrd): anything else is an InputError.
    ImagePiece keepBrick(const FieldPart& part, bool withNeighbours);

    /// All of an image as a piece, of which readExtent() reads parts. Nothing for other files.
    std::optional<ImagePiece> wholeImage() const;

    const std::vector<double>& timeSteps() const { return facts_.timeSteps; }

    /// Throws InputError before reading if what was kept needs more memory than there is.
    vtkSmartPointer<vtkDataObject> read(const ProgressReport& progress, const char* what);

    /// Only these of its pieces as one data set, of VTK's parallel files one alone. It may have places of polygons
    /// (kTrianglesPlaces).
    vtkSmartPointer<vtkDataObject> readPieces(const PieceRun& run);
    vtkSmartPointer<vtkDataObject> readPiece(int piece) { return readPieces({piece, piece + 1}); }

    /// Only these samples of image data, first and last in x, y and z.
    vtkSmartPointer<vtkDataObject> readExtent(const std::array<int, 6>& extent);

private:
    template <class Request>
    ReaderProcess::Answer ask(PacketKind kind, const Request& request, const char* what,
                              const ProgressReport& progress);
    vtkSmartPointer<vtkDataObject> data(const ReadRequest& request, const char* what, const ProgressReport& progress);

    std::string path_;
    ReaderLease reader_;
    FileFacts facts_;
    bool asked_ = false;               // For the arrays of the parts that are meant.
    std::vector<std::string> atTime_;  // What requireAtTime() was told.
    bool joined_ = false;              // Those that are put together of others are among the arrays.
    ReadRequest request_;
};

}  // namespace aeolic
