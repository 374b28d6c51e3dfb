#include "reader/vtk/surface_header.h"

#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkXMLPolyDataReader.h>

#include <cstring>
#include <fstream>

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
    char header[84] = {};
    if (!std::ifstream(path, std::ios::binary).read(header, sizeof header)) return std::nullopt;
    std::uint32_t triangles = 0;
    std::memcpy(&triangles, header + 80, 4);                                   // Little-endian.
    if (fileBytes != 84 + 50 * std::uint64_t(triangles)) return std::nullopt;  // Text.
    return SurfaceCounts{0, triangles};
}

}  // namespace aeolic
