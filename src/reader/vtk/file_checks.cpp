#include "reader/vtk/file_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include "aeolic/error.h"
#include "base/text.h"
#include "reader/vtk/checks/nrrd_header.h"
#include "reader/vtk/checks/xml_check.h"
#include "reader/vtk/checks/xml_values.h"

namespace aeolic {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void failTruncated(const std::string& path, const std::string& declared, const std::string& found)
{
    throw InputError(path, "the file is cut off: it holds " + found, declared);
}

/// The end of the file: some hundred bytes in front of its last blanks, which are a MiB at most.
std::string tailOf(const std::string& path)
{
    constexpr std::size_t enough = 512;
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    const std::streamoff bytes = file.tellg();
    std::string tail;
    for (const std::streamoff most : {2 * std::streamoff(enough), (std::streamoff{1} << 20) + std::streamoff(enough)}) {
        tail.resize(std::size_t(std::min(bytes, most)));
        file.seekg(-std::streamoff(tail.size()), std::ios::end);
        file.read(tail.data(), std::streamsize(tail.size()));
        tail.erase(tail.find_last_not_of(" \t\r\n") + 1);
        if (tail.size() >= enough) break;
    }
    return tail;
}

void requirePiece(const std::string& path, const std::string& piece)
{
    std::error_code error;
    if (!fs::is_regular_file(piece, error))
        throw InputError(path, "its piece " + piece + " is not there", "a file for each piece");
}

}  // namespace

std::vector<std::string> pieceFilesOf(const std::string& path)
{
    const XmlValues values(path);
    std::vector<std::string> pieces;
    for (int i = 0; i < values.root().GetNumberOfNestedElements(); ++i)
        for (vtkXMLDataElement* piece : childrenOf(*values.root().GetNestedElement(i), "Piece")) {
            const char* source = piece->GetAttribute("Source");
            const std::string name = source ? source : "";
            if (std::any_of(name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }))
                throw InputError(path, "the name of a piece has control characters", "a file name");
            pieces.push_back((fs::path(path).parent_path() / name).string());
            requirePiece(path, pieces.back());
        }
    return pieces;
}

std::uint64_t checkStl(const std::string& path, std::uint64_t fileBytes)
{
    std::ifstream file(path, std::ios::binary);
    char header[84] = {};
    file.read(header, sizeof header);
    const std::string start(header, std::size_t(file.gcount()));
    std::uint32_t triangles = 0;
    if (start.size() == sizeof header) std::memcpy(&triangles, header + 80, 4);  // Little-endian, like this machine.
    if (start.size() == sizeof header && fileBytes == 84 + 50 * std::uint64_t(triangles)) return fileBytes;
    if (lowerCase(start).find("solid") < 80) {
        // Text, which ends with "endsolid NAME"; the reader takes what is before for all.
        const bool text = std::none_of(start.begin(), start.end(), [](char c) { return c == '\0'; });
        if (text && lowerCase(tailOf(path)).find("endsolid") != std::string::npos) return fileBytes;
        if (text) failTruncated(path, "a last line 'endsolid'", "no such line");
    }
    if (start.size() < sizeof header || fileBytes < 84 + 50 * std::uint64_t(triangles))
        failTruncated(
            path,
            fmt::format("{} for the {} triangles its header declares", 84 + 50 * std::uint64_t(triangles), triangles),
            fmt::format("{} bytes", fileBytes));
    return fileBytes;
}

std::uint64_t checkNrrd(const std::string& path, std::uint64_t fileBytes)
{
    checkNrrdFile(path);
    return fileBytes;
}

std::uint64_t checkXml(const std::string& path, std::uint64_t fileBytes)
{
    if (tailOf(path).find("</VTKFile>") == std::string::npos)
        throw InputError(path, "the file is cut off: it does not end with </VTKFile>", "a complete file");
    return std::max(fileBytes, checkXmlFile(path));
}

}  // namespace aeolic
