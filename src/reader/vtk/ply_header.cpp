#include "reader/vtk/ply_header.h"

#include <algorithm>
#include <map>
#include <sstream>

#include "aeolic/error.h"

namespace aeolic {

namespace {

[[noreturn]] void fail(const std::string& path, const std::string& line, const std::string& expected)
{
    std::string shown;  // One line of readable characters, whatever the file begins with.
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
    fail(path, line, "'format ascii 1.0', 'format binary_little_endian 1.0' or 'format binary_big_endian 1.0'");
}

NumberType readType(std::istringstream& words, const std::string& path, const std::string& line)
{
    using enum NumberType;
    static const std::map<std::string, NumberType> types{
        {"char", int8},     {"int8", int8},       {"uchar", uint8},    {"uint8", uint8},
        {"short", int16},   {"int16", int16},     {"ushort", uint16},  {"uint16", uint16},
        {"int", int32},     {"int32", int32},     {"uint", uint32},    {"uint32", uint32},
        {"float", float32}, {"float32", float32}, {"double", float64}, {"float64", float64}};
    std::string name;
    words >> name;
    const auto type = types.find(name);
    if (type == types.end()) fail(path, line, "a type that PLY has");
    return type->second;
}

PlyProperty readProperty(std::istringstream& words, const std::string& path, const std::string& line)
{
    PlyProperty property;
    const auto afterProperty = words.tellg();
    std::string first;
    words >> first;
    property.isList = first == "list";
    if (property.isList)
        property.countType = readType(words, path, line);
    else
        words.seekg(afterProperty);
    property.type = readType(words, path, line);
    if (!(words >> property.name)) fail(path, line, "a property with a type and a name");
    return property;
}

/// A second element of the same name would add to the first, and then arrays had not as many values as there are
/// points.
template <class Item>
void add(std::vector<Item>& items, Item item, const std::string& path, const std::string& line)
{
    const auto same = [&](const Item& other) { return other.name == item.name; };
    if (std::ranges::any_of(items, same)) fail(path, line, "each name once");
    items.push_back(std::move(item));
}

}  // namespace

PlyHeader readPlyHeader(std::istream& file, const std::string& path)
{
    PlyHeader header;
    std::string line, word;
    bool formatKnown = false;
    for (int number = 0; std::getline(file, line); ++number) {
        std::istringstream words(line);
        word.clear();
        words >> word;
        if ((word == "ply") != (number == 0)) throw InputError(path, "no 'ply' in the first line", "a PLY file");
        if (word == "ply" || word == "comment" || word == "obj_info") continue;
        if (word == "end_header") {
            if (!formatKnown) fail(path, line, "a format first");
            return header;
        }
        if (word == "format") {
            header.format = readFormat(words, path, line);
            formatKnown = true;
        } else if (word == "element") {
            PlyElement element;
            if (!(words >> element.name >> element.count)) fail(path, line, "an element with a name and a count");
            add(header.elements, std::move(element), path, line);
        } else if (word == "property" && !header.elements.empty()) {
            add(header.elements.back().properties, readProperty(words, path, line), path, line);
        } else {
            fail(path, line, "format, comment, element, property or end_header");
        }
    }
    throw InputError(path, "the file is cut off within its header", "a header up to 'end_header'");
}

}  // namespace aeolic
