#include "data/vtk/file_reader.h"

#include <algorithm>
#include <filesystem>

#include "aeolic/error.h"
#include "data/named_file.h"
#include "data/vtk/checks/cell_checks.h"
#include "data/vtk/data_message.h"
#include "data/vtk/joined_arrays.h"

namespace aeolic {

template <class Request>
ReaderProcess::Answer FileReader::ask(PacketKind kind, const Request& request, const char* what,
                                      const ProgressReport& progress)
{
    return reader_->ask(kind, byteMessage(request), {path_, what}, progress);
}

FileReader::FileReader(std::string path, Use use, std::optional<double> time) : path_(std::move(path))
{
    std::error_code error;
    const OpenRequest request{std::filesystem::current_path(error).string(), path_, use, time};
    facts_ = valueIn<FileFacts>(ask(PacketKind::open, request, "opening it", {}).text, path_);
}

void FileReader::keepParts(const std::vector<std::string>& parts)
{
    request_.parts = parts;
    asked_ = false;
}

const std::vector<ArrayInfo>& FileReader::announcedArrays()
{
    if (facts_.arraysByParts && !asked_) joined_ = false;
    if (facts_.arraysByParts && !asked_)
        facts_.arrays = valueIn<std::vector<ArrayInfo>>(
            ask(PacketKind::arrays, ArraysRequest{request_.parts, atTime_}, "looking for its arrays", {}).text, path_);
    asked_ = true;
    if (!joined_ && !namedKindHas(path_, kHasMaps)) facts_.arrays = withJoined(std::move(facts_.arrays));
    joined_ = true;
    return facts_.arrays;
}

void FileReader::keepOnly(const std::vector<ArrayInfo>& arrays)
{
    request_.arrays = arraysToRead(arrays);
}

void FileReader::requireAtTime(const std::vector<std::string>& arrays)
{
    atTime_ = arrays;
    asked_ = false;
    joined_ = false;
}

GridIndex FileReader::imageDims() const
{
    GridIndex dims = facts_.wholeExtent ? ImagePiece{*facts_.wholeExtent, {}, {}}.wholeDims() : GridIndex{0, 0, 0};
    for (std::int64_t& samples : dims) samples = std::max<std::int64_t>(samples, 0);
    return dims;
}

std::optional<ImagePiece> FileReader::wholeImage() const
{
    if (!facts_.wholeExtent || request_.extent) return std::nullopt;
    ImagePiece image{*facts_.wholeExtent, {}, {}};
    const GridIndex dims = image.wholeDims();
    image.brick.cellHi = image.own.cellHi = {dims[0] - 1, dims[1] - 1, dims[2] - 1};
    return image;
}

ImagePiece FileReader::keepBrick(const FieldPart& part, bool withNeighbours)
{
    const GridIndex dims = imageDims();
    if (*std::min_element(dims.begin(), dims.end()) < 2)
        throw InputError(path_, "it cannot be read in bricks",
                         "image data (.vti, .pvti, .nhdr) of at least two samples in x, y and z, or --bricks off");
    ImagePiece piece{*facts_.wholeExtent, {}, {}};
    piece.own = BrickTree(dims, part.ranks).brick(part.rank);
    piece.brick = withNeighbours ? piece.own.grown(dims) : piece.own;
    request_.extent = piece.extent();
    return piece;
}

vtkSmartPointer<vtkDataObject> FileReader::data(const ReadRequest& request, const char* what,
                                                const ProgressReport& progress)
{
    const ReaderProcess::Answer answer = ask(PacketKind::read, request, what, progress);
    ByteReader message(answer.text);
    auto data = readData(message, answer.memory, path_);
    if (!data) throw InputError(path_, "nothing could be read", "a complete, undamaged file");
    requireSoundData(*data, path_);
    return data;
}

vtkSmartPointer<vtkDataObject> FileReader::read(const ProgressReport& progress, const char* what)
{
    return data(request_, what, progress);
}

vtkSmartPointer<vtkDataObject> FileReader::readPieces(const PieceRun& run)
{
    ReadRequest request = request_;
    request.pieces = run;
    return data(request, "reading a piece", {});
}

vtkSmartPointer<vtkDataObject> FileReader::readExtent(const std::array<int, 6>& extent)
{
    ReadRequest request = request_;
    request.extent = extent;
    return data(request, "reading a part of it", {});
}

}  // namespace aeolic
