#include "data/vtk/file_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "aeolic/error.h"

namespace aeolic {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void failTruncated(const std::string& path, const std::string& declared, const std::string& found)
{
    throw InputError(path, "the file is cut off: it holds " + found, declared);
}

void checkStl(const std::string& path, std::uint64_t fileBytes)
{
    std::ifstream file(path, std::ios::binary);
    char header[84] = {};
    file.read(header, sizeof header);
    const std::string start(header, std::size_t(file.gcount()));
    std::uint32_t triangles = 0;
    if (start.size() == sizeof header) std::memcpy(&triangles, header + 80, 4);  // Little-endian, like this machine.
    if (start.size() == sizeof header && fileBytes == 84 + 50 * std::uint64_t(triangles)) return;
    if (start.find("solid") < 80) {  // Text, which ends with "endsolid NAME"; the reader takes what is before for all.
        file.clear();
        file.seekg(-std::streamoff(std::min<std::uint64_t>(fileBytes, 512)), std::ios::end);
        const std::string tail(std::istreambuf_iterator<char>(file), {});
        const bool text = std::none_of(start.begin(), start.end(), [](char c) { return c == '\0'; });
        if (text && tail.find("endsolid") != std::string::npos) return;
        if (text) failTruncated(path, "a last line 'endsolid'", "no such line");
    }
    if (start.size() < sizeof header || fileBytes < 84 + 50 * std::uint64_t(triangles))
        failTruncated(path, fmt::format("{} for the {} triangles its header declares", 84 + 50 * std::uint64_t(triangles), triangles),
                      fmt::format("{} bytes", fileBytes));
}

/// What follows a PLY header at least: lists count with their length alone.
struct PlyBody {
    bool text = false;
    std::uint64_t elements = 0, bytes = 0;
};

PlyBody readPlyHeader(std::istream& file, const std::string& path)
{
    static const std::map<std::string, int> sizes{
        {"char", 1},  {"uchar", 1},  {"int8", 1},  {"uint8", 1},  {"short", 2},   {"ushort", 2},  {"int16", 2},  {"uint16", 2},
        {"int", 4},   {"uint", 4},   {"int32", 4}, {"uint32", 4}, {"float", 4},   {"float32", 4}, {"double", 8}, {"float64", 8}};
    PlyBody body;
    std::uint64_t count = 0;
    std::string line, word, type;
    for (int number = 0; number < 10000 && std::getline(file, line); ++number) {
        std::istringstream words(line);
        words >> word;
        if (number == 0 && word != "ply") throw InputError(path, "no 'ply' in the first line", "a PLY file");
        if (word == "end_header") return body;
        if (word == "format") body.text = (words >> word) && word == "ascii";
        if (word == "element") {
            if (!(words >> word >> count)) throw InputError(path, "the header line '" + line + "'", "a name and a count");
            body.elements += count;
        } else if (word == "property" && words >> type) {
            if (type == "list") words >> type;
            const auto size = sizes.find(type);
            if (size == sizes.end()) throw InputError(path, "the type '" + type + "'", "a type that PLY has");
            body.bytes += count * std::uint64_t(size->second);
        }
    }
    failTruncated(path, "a header up to 'end_header'", "no such line");
}

void checkPly(const std::string& path, std::uint64_t fileBytes)
{
    std::ifstream file(path, std::ios::binary);
    const PlyBody body = readPlyHeader(file, path);
    const auto headerBytes = static_cast<std::uint64_t>(file.tellg());
    if (!body.text) {
        if (fileBytes - headerBytes < body.bytes)
            failTruncated(path, fmt::format("at least {} for what its header declares", body.bytes),
                          fmt::format("{} bytes behind the header", fileBytes - headerBytes));
        return;
    }
    const auto lines = static_cast<std::uint64_t>(std::count(std::istreambuf_iterator<char>(file), {}, '\n'));
    if (lines + 1 < body.elements)  // The last line may lack its end.
        failTruncated(path, fmt::format("the {} its header declares", body.elements),
                      fmt::format("{} lines behind the header", lines));
}

}  // namespace

std::uint64_t checkReadableFile(const std::string& path)
{
    const char* expected = "a file that can be read";
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) throw InputError(path, error && error.value() != ENOENT ? error.message() : "no such file", expected);
    if (fs::is_directory(status)) throw InputError(path, "it is a folder", expected);
    if (!fs::is_regular_file(status)) throw InputError(path, "it is a device or a pipe", expected);
    errno = 0;
    if (!std::ifstream(path, std::ios::binary)) throw InputError(path, std::strerror(errno), expected);
    const std::uint64_t bytes = fs::file_size(path, error);
    if (error || bytes == 0) throw InputError(path, error ? error.message() : "it is empty", expected);
    return bytes;
}

void checkDeclaredSize(const std::string& path, const std::string& extension, std::uint64_t fileBytes)
{
    if (extension == ".stl") checkStl(path, fileBytes);
    if (extension == ".ply") checkPly(path, fileBytes);
}

}  // namespace aeolic
