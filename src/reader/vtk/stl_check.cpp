#include "reader/vtk/stl_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <fstream>

#include "aeolic/error.h"
#include "base/text.h"

namespace aeolic {
namespace {

constexpr std::size_t headerBytes = 84, triangleBytes = 50;

/// Up to so many bytes from there on.
std::string bytesAt(std::ifstream& file, std::uint64_t begin, std::size_t count)
{
    std::string bytes(count, '\0');
    file.clear();
    file.seekg(std::streamoff(begin));
    file.read(bytes.data(), std::streamsize(count));
    bytes.resize(std::size_t(file.gcount()));
    return bytes;
}

}  // namespace

void checkStl(const std::string& path, std::uint64_t fileBytes)
{
    constexpr std::uint64_t tailBytes = 4096;  // With blanks behind the last line.
    std::ifstream file(path, std::ios::binary);
    const std::string start = bytesAt(file, 0, headerBytes);
    std::uint32_t triangles = 0;
    if (start.size() == headerBytes)
        std::memcpy(&triangles, start.data() + 80, 4);  // Little-endian, like this machine.
    const std::uint64_t expected = headerBytes + triangleBytes * std::uint64_t(triangles);
    if (start.size() == headerBytes && fileBytes == expected) return;
    if (lowerCase(start).find("solid") < 80 && start.find('\0') == std::string::npos) {
        const std::string tail = bytesAt(file, fileBytes - std::min(fileBytes, tailBytes), tailBytes);
        if (lowerCase(tail).find("endsolid") != std::string::npos) return;
        throw InputError(path, "the file is cut off: it has no last line", "a last line 'endsolid'");
    }
    if (start.size() < headerBytes || fileBytes < expected)
        throw InputError(path, fmt::format("the file is cut off: it holds {} bytes", fileBytes),
                         fmt::format("{} for the {} triangles its header declares", expected, triangles));
}

}  // namespace aeolic
