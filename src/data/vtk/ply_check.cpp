#include "data/vtk/ply_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <vector>

#include "aeolic/error.h"

namespace aeolic {

namespace {

constexpr std::int64_t longestList = 255;  // VTK keeps a face's number of corners in a byte.

struct PlyProperty {
    std::string name;
    int bytes = 0;       ///< Of the value, or of one entry of the list.
    int countBytes = 0;  ///< Of the list's length; 0: no list.
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    enum class Format { text, littleEndian, bigEndian } format = Format::text;
    std::vector<PlyElement> elements;
};

[[noreturn]] void failCutOff(const std::string& path, const PlyElement& element, std::uint64_t found)
{
    throw InputError(path, fmt::format("the file is cut off: it holds {} of type '{}'", found, element.name),
                     fmt::format("the {} its header declares", element.count));
}

int typeBytes(const std::string& type, const std::string& path)
{
    static const std::map<std::string, int> bytes{
        {"char", 1},  {"uchar", 1},  {"int8", 1},  {"uint8", 1},  {"short", 2},   {"ushort", 2},  {"int16", 2},  {"uint16", 2},
        {"int", 4},   {"uint", 4},   {"int32", 4}, {"uint32", 4}, {"float", 4},   {"float32", 4}, {"double", 8}, {"float64", 8}};
    const auto found = bytes.find(type);
    if (found == bytes.end()) throw InputError(path, "the type '" + type.substr(0, 40) + "' in the header", "a type that PLY has");
    return found->second;
}

[[noreturn]] void failHeader(const std::string& path, const std::string& line, const std::string& expected)
{
    std::string shown;  // One line of readable characters, however the file begins.
    for (const char c : line.substr(0, 60)) shown += c >= ' ' && c <= '~' ? c : '?';
    throw InputError(path, "its header has the line '" + shown + "'", expected);
}

PlyHeader::Format readFormat(std::istringstream& words, const std::string& path, const std::string& line)
{
    std::string format, version;
    words >> format >> version;
    if (version == "1.0" && format == "ascii") return PlyHeader::Format::text;
    if (version == "1.0" && format == "binary_little_endian") return PlyHeader::Format::littleEndian;
    if (version == "1.0" && format == "binary_big_endian") return PlyHeader::Format::bigEndian;
    failHeader(path, line, "'format ascii 1.0', 'format binary_little_endian 1.0' or 'format binary_big_endian 1.0'");
}

PlyProperty readProperty(std::istringstream& words, const std::string& path, const std::string& line)
{
    PlyProperty property;
    std::string type, countType;
    words >> type;
    if (type == "list" && words >> countType >> type) property.countBytes = typeBytes(countType, path);
    property.bytes = typeBytes(type, path);
    if (!(words >> property.name)) failHeader(path, line, "a property with a type and a name");
    return property;
}

PlyHeader readHeader(std::istream& file, const std::string& path)
{
    PlyHeader header;
    std::string line, word;
    bool formatKnown = false;
    for (int number = 0; number < 10000 && std::getline(file, line); ++number) {
        std::istringstream words(line);
        word.clear();
        words >> word;
        if (number == 0 ? word != "ply" : word == "ply") throw InputError(path, "no 'ply' in the first line", "a PLY file");
        if (word == "ply" || word == "comment" || word == "obj_info") continue;
        if (word == "end_header") {
            if (!formatKnown) failHeader(path, line, "a format first");
            return header;
        }
        if (word == "format") {
            header.format = readFormat(words, path, line);
            formatKnown = true;
        } else if (word == "element") {
            PlyElement element;
            if (!(words >> element.name >> element.count)) failHeader(path, line, "an element with a name and a count");
            header.elements.push_back(element);
        } else if (word == "property" && !header.elements.empty()) {
            header.elements.back().properties.push_back(readProperty(words, path, line));
        } else {
            failHeader(path, line, "format, comment, element, property or end_header");
        }
    }
    throw InputError(path, "the file is cut off within its header", "a header up to 'end_header'");
}

/// What VTK's reader takes for granted of an element.
void require(const PlyHeader& header, const char* element, const std::vector<std::string>& properties, bool lists,
             const std::string& path)
{
    const auto found = std::find_if(header.elements.begin(), header.elements.end(), [&](const PlyElement& e) { return e.name == element; });
    if (found == header.elements.end()) throw InputError(path, fmt::format("it has no element '{}'", element), "vertices and faces");
    const auto count = std::count_if(found->properties.begin(), found->properties.end(), [&](const PlyProperty& p) {
        return (p.countBytes > 0) == lists && std::find(properties.begin(), properties.end(), p.name) != properties.end();
    });
    if (count != (lists ? 1 : 3))
        throw InputError(path, fmt::format("its element '{}' lacks a property", element),
                         lists ? "a list vertex_indices" : "numbers x, y and z");
}

/// The whole number in the next bytes, or nothing at the end of the file.
std::optional<std::int64_t> readCount(std::istream& file, int bytes, bool bigEndian)
{
    char raw[8] = {};
    if (!file.read(raw, bytes)) return std::nullopt;
    std::uint64_t value = 0;
    for (int i = 0; i < bytes; ++i)
        value |= std::uint64_t(static_cast<unsigned char>(raw[bigEndian ? bytes - 1 - i : i])) << (8 * i);
    return static_cast<std::int64_t>(value);
}

void checkListLength(std::int64_t length, const PlyElement& element, const std::string& path)
{
    if (length < 0 || length > longestList)
        throw InputError(path, fmt::format("a list of {} entries in '{}'", length, element.name), fmt::format("at most {}", longestList));
}

void walkBinary(std::istream& file, const PlyElement& element, bool bigEndian, const std::string& path)
{
    const bool lists = std::any_of(element.properties.begin(), element.properties.end(), [](const PlyProperty& p) { return p.countBytes > 0; });
    const std::streamoff start = file.tellg();
    file.seekg(0, std::ios::end);
    const auto left = static_cast<std::uint64_t>(file.tellg() - start);
    file.seekg(start);
    if (!lists) {
        std::uint64_t bytes = 0;
        for (const PlyProperty& property : element.properties) bytes += std::uint64_t(property.bytes);
        if (bytes > 0 && left / bytes < element.count) failCutOff(path, element, left / bytes);
        file.seekg(std::streamoff(bytes * element.count), std::ios::cur);
        return;
    }
    for (std::uint64_t i = 0; i < element.count; ++i)
        for (const PlyProperty& property : element.properties) {
            std::int64_t entries = 1;
            if (property.countBytes > 0) {
                const auto length = readCount(file, property.countBytes, bigEndian);
                if (!length) failCutOff(path, element, i);
                checkListLength(*length, element, path);
                entries = *length;
            }
            const std::streamsize bytes = std::streamsize(entries) * property.bytes;
            if (file.ignore(bytes).gcount() != bytes) failCutOff(path, element, i);
        }
}

void walkText(std::istream& file, const PlyElement& element, const std::string& path)
{
    std::string line, word;
    for (std::uint64_t i = 0; i < element.count; ++i) {
        if (!std::getline(file, line)) failCutOff(path, element, i);
        std::istringstream words(line);
        for (const PlyProperty& property : element.properties) {
            std::int64_t entries = 1;
            if (property.countBytes > 0) {
                if (!(words >> entries)) failCutOff(path, element, i);
                checkListLength(entries, element, path);
            }
            for (std::int64_t k = 0; k < entries; ++k)
                if (!(words >> word)) failCutOff(path, element, i);
        }
    }
}

}  // namespace

void checkPly(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    const PlyHeader header = readHeader(file, path);
    require(header, "vertex", {"x", "y", "z"}, false, path);
    require(header, "face", {"vertex_indices", "vertex_index"}, true, path);
    for (const PlyElement& element : header.elements) {
        if (header.format == PlyHeader::Format::text)
            walkText(file, element, path);
        else
            walkBinary(file, element, header.format == PlyHeader::Format::bigEndian, path);
    }
}

}  // namespace aeolic
