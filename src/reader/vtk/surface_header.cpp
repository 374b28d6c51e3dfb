#include "reader/vtk/format_readers.h"

#include <fmt/format.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cstring>
#include <fstream>

#include "aeolic/error.h"
#include "base/text.h"
#include "data/named_file.h"
#include "data/vtk/messages.h"
#include "reader/vtk/ply_header.h"

namespace aeolic {
namespace {

/// VTK's reader knows the numbers once it has the header, but tells them only when all is read.
class PolyDataHeader : public vtkXMLPolyDataReader {
public:
    static PolyDataHeader* New();

    SurfaceCounts counts() const
    {
        SurfaceCounts counts;
        for (int i = 0; i < NumberOfPieces; ++i) {
            counts.points += std::uint64_t(NumberOfPoints[i]);
            counts.polygons += std::uint64_t(NumberOfPolys[i] + NumberOfStrips[i]);
        }
        return counts;
    }

protected:
    PolyDataHeader() = default;
};
vtkStandardNewMacro(PolyDataHeader);

/// Up to `count` bytes of the file, from `begin` on.
std::string bytesAt(const std::string& path, std::uint64_t begin, std::size_t count)
{
    std::ifstream file(path, std::ios::binary);
    file.seekg(std::streamoff(begin));
    std::string bytes(count, '\0');
    file.read(bytes.data(), std::streamsize(count));
    bytes.resize(std::size_t(file.gcount()));
    return bytes;
}

/// What a binary STL file begins with, and the triangles that it says it has.
struct StlHeader {
    static constexpr std::size_t kBytes = 84;

    explicit StlHeader(const std::string& path) : text(bytesAt(path, 0, kBytes))
    {
        if (isWhole()) std::memcpy(&triangles, text.data() + 80, 4);  // Little-endian, like this machine.
    }

    bool isWhole() const { return text.size() == kBytes; }
    std::uint64_t fileBytes() const { return kBytes + 50 * std::uint64_t(triangles); }

    std::string text;
    std::uint32_t triangles = 0;
};

}  // namespace

std::optional<SurfaceCounts> countsOfXml(const std::string& path)
{
    checkReadableFile(path);
    const VtkMessages messages;
    vtkNew<PolyDataHeader> reader;
    if (!reader->CanReadFile(path.c_str())) return std::nullopt;
    reader->SetFileName(path.c_str());
    reader->UpdateInformation();
    if (messages.failed()) return std::nullopt;
    return reader->counts();
}

std::optional<SurfaceCounts> countsOfPly(const std::string& path)
{
    checkReadableFile(path);
    std::ifstream file(path, std::ios::binary);
    SurfaceCounts counts;
    for (const PlyElement& element : readPlyHeader(file, path).elements) {
        if (element.name == "vertex") counts.points = element.count;
        if (element.name == "face") counts.polygons = element.count;
    }
    return counts;
}

/// Points are written once for every triangle, and those that are the same become one when it is read.
std::optional<SurfaceCounts> countsOfStl(const std::string& path)
{
    const std::uint64_t fileBytes = checkReadableFile(path);
    const StlHeader header(path);
    if (!header.isWhole() || fileBytes != header.fileBytes()) return std::nullopt;  // Text.
    return SurfaceCounts{0, header.triangles};
}

void checkStl(const std::string& path, std::uint64_t fileBytes)
{
    constexpr std::uint64_t tailBytes = 4096;  // With blanks behind the last line.
    const StlHeader header(path);
    if (header.isWhole() && fileBytes == header.fileBytes()) return;
    if (lowerCase(header.text).find("solid") < 80 && header.text.find('\0') == std::string::npos) {
        const std::string tail = bytesAt(path, fileBytes - std::min(fileBytes, tailBytes), tailBytes);
        if (lowerCase(tail).find("endsolid") != std::string::npos) return;
        throw InputError(path, "the file is cut off: it has no last line", "a last line 'endsolid'");
    }
    if (fileBytes < header.fileBytes())
        throw InputError(
            path, fmt::format("the file is cut off: it holds {} bytes", fileBytes),
            fmt::format("{} for the {} triangles its header declares", header.fileBytes(), header.triangles));
}

}  // namespace aeolic
