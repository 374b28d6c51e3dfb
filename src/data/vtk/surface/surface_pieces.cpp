#include "data/vtk/surface/surface_pieces.h"

#include "data/vtk/file_checks.h"
#include "data/vtk/file_reader.h"

namespace aeolic {

PieceRun runOf(const FieldPart& part, const std::vector<std::uint64_t>& bytes)
{
    std::uint64_t total = 0;
    for (const std::uint64_t piece : bytes) total += piece;
    PieceRun run;
    std::uint64_t before = 0;
    for (const std::uint64_t piece : bytes) {  // Each to the rank in whose share its middle lies.
        const double middle = (double(before) + 0.5 * double(piece)) / double(total);
        const int rank = int(middle * part.ranks);
        run.begin += rank < part.rank;
        run.end += rank <= part.rank;
        before += piece;
    }
    return run;
}

std::vector<std::uint64_t> pieceBytesOf(const std::string& path)
{
    std::vector<std::uint64_t> bytes;
    if (extensionOf(path) != ".pvtp") return bytes;
    checkReadableFile(path);
    for (const std::string& piece : pieceFilesOf(path)) bytes.push_back(checkReadableFile(piece));
    return bytes;
}

}  // namespace aeolic
