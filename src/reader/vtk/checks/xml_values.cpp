#include "reader/vtk/checks/xml_values.h"

#include <fmt/format.h>
#include <vtkBase64Utilities.h>
#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkZLibDataCompressor.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>

#include "aeolic/error.h"
#include "data/vtk/messages.h"
#include "description/option_rules.h"

namespace aeolic {
namespace {

/// No compressor makes less than one byte of so many. A header that claims more lies.
constexpr std::uint64_t mostFromOneByte = 20000;
constexpr std::uint64_t largestBlockBytes = std::uint64_t{1} << 31;

bool isSpace(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

/// Whether a stream takes the whole word for a value of the type.
bool isNumber(std::string_view word, int type)
{
    if (word.starts_with('+')) word.remove_prefix(1);
    const char* const end = word.data() + word.size();
    if (type == VTK_FLOAT || type == VTK_DOUBLE) {
        double value = 0;
        const auto [stop, error] = std::from_chars(word.data(), end, value);
        const bool tiny = error == std::errc::result_out_of_range && word.find("e-") != std::string_view::npos;
        const double most =
            type == VTK_FLOAT ? double(std::numeric_limits<float>::max()) : std::numeric_limits<double>::max();
        const bool fits = error == std::errc{} && !(std::isfinite(value) && std::abs(value) > most);
        return stop == end && (tiny || fits);
    }
    if (type == VTK_TYPE_UINT64) {
        std::uint64_t value = 0;
        const auto [stop, error] = std::from_chars(word.data(), end, value);
        return error == std::errc{} && stop == end;
    }
    std::int64_t value = 0;
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    return error == std::errc{} && stop == end && double(value) >= vtkDataArray::GetDataTypeMin(type) &&
           double(value) <= vtkDataArray::GetDataTypeMax(type);
}

std::string attributeOf(vtkXMLDataElement& element, const char* name)
{
    const char* value = element.GetAttribute(name);
    return value ? value : "";
}

}  // namespace

std::vector<vtkXMLDataElement*> childrenOf(vtkXMLDataElement& element, const std::string& name)
{
    std::vector<vtkXMLDataElement*> found;
    for (int i = 0; i < element.GetNumberOfNestedElements(); ++i)
        if (vtkXMLDataElement* child = element.GetNestedElement(i); child->GetName() && name == child->GetName())
            found.push_back(child);
    return found;
}

std::string labelOf(vtkXMLDataElement& array)
{
    vtkXMLDataElement* parent = array.GetParent();
    std::string label = parent && parent->GetName() ? std::string(parent->GetName()) + " array" : "array";
    const std::string name = attributeOf(array, "Name");
    return name.empty() ? label : label + " '" + name + "'";
}

int typeOf(vtkXMLDataElement& array)
{
    static const std::pair<const char*, int> types[] = {
        {"Int8", VTK_TYPE_INT8},       {"UInt8", VTK_TYPE_UINT8},   {"Int16", VTK_TYPE_INT16},
        {"UInt16", VTK_TYPE_UINT16},   {"Int32", VTK_TYPE_INT32},   {"UInt32", VTK_TYPE_UINT32},
        {"Int64", VTK_TYPE_INT64},     {"UInt64", VTK_TYPE_UINT64}, {"Float32", VTK_TYPE_FLOAT32},
        {"Float64", VTK_TYPE_FLOAT64}, {"String", VTK_STRING}};
    const std::string type = attributeOf(array, "type");
    for (const auto& [name, number] : types)
        if (type == name) return number;
    return -1;
}

std::uint64_t countIn(vtkXMLDataElement& element, const char* attribute, const std::string& path)
{
    const char* text = element.GetAttribute(attribute);
    if (!text) return 0;
    constexpr std::uint64_t most = std::uint64_t{1} << 60;
    std::uint64_t count = 0;
    const char* const end = text + std::strlen(text);
    const auto [stop, error] = std::from_chars(text, end, count);
    if (error != std::errc{} || stop != end || count > most)
        throw InputError(path, fmt::format("its {} is '{:.40}'", attribute, text), "a count from 0");
    return count;
}

std::uint64_t componentsOf(vtkXMLDataElement& array, const std::string& path)
{
    constexpr std::uint64_t most = 1000;
    if (!array.GetAttribute("NumberOfComponents")) return 1;
    const std::uint64_t components = countIn(array, "NumberOfComponents", path);
    if (components < 1 || components > most)
        throw InputError(path, fmt::format("{} has {} components", labelOf(array), components),
                         fmt::format("1 to {}", most));
    return components;
}

XmlValues::XmlValues(const std::string& path) : path_(path), file_(path, std::ios::binary)
{
    file_.seekg(0, std::ios::end);
    fileBytes_ = std::uint64_t(file_.tellg());
    file_.seekg(0);
    parser_->SetStream(&file_);
    const VtkMessages messages;
    if (!parser_->Parse() || messages.failed() || !parser_->GetRootElement())
        throw InputError(
            path,
            fmt::format("it is not well-formed XML ({})", messages.failed() ? messages.firstError() : "it ends early"),
            "a VTK XML file");
    if (std::string(root().GetName()) != "VTKFile")
        throw InputError(path, fmt::format("its first element is '{:.40}'", root().GetName()), "VTKFile");
    headerWordBytes_ = attributeOf(root(), "header_type") == "UInt64" ? 8 : 4;
    bigEndian_ = attributeOf(root(), "byte_order") == "BigEndian";
    setCompressor();
    for (vtkXMLDataElement* appended : childrenOf(root(), "AppendedData"))
        appendedBase64_ = attributeOf(*appended, "encoding") != "raw";
    findAppended();
}

void XmlValues::setCompressor()
{
    const std::string name = attributeOf(root(), "compressor");
    if (name.empty()) return;
    if (name == "vtkZLibDataCompressor")
        parser_->SetCompressor(vtkNew<vtkZLibDataCompressor>());
    else if (name == "vtkLZ4DataCompressor")
        parser_->SetCompressor(vtkNew<vtkLZ4DataCompressor>());
    else if (name == "vtkLZMADataCompressor")
        parser_->SetCompressor(vtkNew<vtkLZMADataCompressor>());
    else
        throw InputError(path_, fmt::format("its compressor is '{:.40}'", name),
                         "vtkZLibDataCompressor, vtkLZ4DataCompressor or vtkLZMADataCompressor");
}

void XmlValues::fail(vtkXMLDataElement& array, const std::string& found, const std::string& expected) const
{
    throw InputError(path_, labelOf(array) + " " + found, expected);
}

/// Behind the '>' that ends the element's tag, and behind the blanks that follow, as VTK finds it.
std::uint64_t XmlValues::inlineStart(vtkXMLDataElement& array)
{
    file_.clear();
    file_.seekg(std::streamoff(array.GetXMLByteIndex()));
    char c = 0;
    while (file_.get(c) && c != '>') {
    }
    while (file_.get(c) && isSpace(c)) {
    }
    return file_ ? std::uint64_t(file_.tellg()) - 1 : fileBytes_;
}

std::uint64_t XmlValues::inlineEnd(std::uint64_t start)
{
    file_.clear();
    file_.seekg(std::streamoff(start));
    std::vector<char> buffer(1 << 16);
    for (std::uint64_t at = start; at < fileBytes_;) {
        file_.read(buffer.data(), std::streamsize(buffer.size()));
        const auto count = std::size_t(file_.gcount());
        if (count == 0) break;
        if (const void* found = std::memchr(buffer.data(), '<', count))
            return at + std::uint64_t(static_cast<const char*>(found) - buffer.data());
        at += count;
    }
    return fileBytes_;
}

void XmlValues::findAppended()
{
    for (vtkXMLDataElement* appended : childrenOf(root(), "AppendedData")) {
        const std::uint64_t start = inlineStart(*appended);
        file_.clear();
        file_.seekg(std::streamoff(start));
        char c = 0;
        appendedAt_ = start + (file_.get(c) && c == '_' ? 1 : 0);
    }
}

XmlValues::Place XmlValues::placeOf(vtkXMLDataElement& array)
{
    const std::string format = attributeOf(array, "format");
    if (format == "appended") {
        if (!array.GetAttribute("offset") || appendedAt_ == 0)
            fail(array, "has no offset, or the file no AppendedData", "appended values at an offset");
        const std::uint64_t offset = countIn(array, "offset", path_);
        if (offset >= fileBytes_ || appendedAt_ + offset > fileBytes_)
            fail(array, fmt::format("begins at byte {} of the appended data", offset),
                 fmt::format("a place within the {} bytes of the file", fileBytes_));
        return {appendedAt_ + offset, fileBytes_, appendedBase64_};
    }
    if (format != "ascii" && format != "binary")
        fail(array, "has the format '" + format + "'", "ascii, binary or appended");
    const std::uint64_t start = inlineStart(array);
    return {start, inlineEnd(start), true};
}

/// The first words of a header.
std::vector<std::uint64_t> XmlValues::headerAt(const Place& place, std::uint64_t words, vtkXMLDataElement& array)
{
    const std::uint64_t bytes = words * headerWordBytes_, stored = place.base64 ? (bytes + 2) / 3 * 4 : bytes;
    if (place.end - place.at < stored)
        fail(array, fmt::format("ends within its header, {} bytes long", place.end - place.at),
             fmt::format("at least {}", stored));
    std::vector<unsigned char> text(stored), raw(stored + 3);
    file_.clear();
    file_.seekg(std::streamoff(place.at));
    file_.read(reinterpret_cast<char*>(text.data()), std::streamsize(stored));
    std::uint64_t decoded = std::uint64_t(file_.gcount());
    if (place.base64)
        decoded = vtkBase64Utilities::DecodeSafely(text.data(), stored, raw.data(), raw.size());
    else
        raw = text;
    if (decoded < bytes) fail(array, "has a header that is not base64", "the size of its values");
    std::vector<std::uint64_t> header(words, 0);
    for (std::uint64_t w = 0; w < words; ++w)
        for (unsigned i = 0; i < headerWordBytes_; ++i) {
            const unsigned at = bigEndian_ ? headerWordBytes_ - 1 - i : i;
            header[w] |= std::uint64_t(raw[w * headerWordBytes_ + at]) << (8 * i);
        }
    return header;
}

std::uint64_t XmlValues::bytesIn(vtkXMLDataElement& array, const Place& place)
{
    if (parser_->GetCompressor()) return bytesInBlocks(array, place);
    const std::uint64_t bytes = headerAt(place, 1, array).front(), stored = place.end - place.at;
    const std::uint64_t there = (place.base64 ? stored / 4 * 3 : stored) - headerWordBytes_;
    if (bytes > there)
        fail(array, fmt::format("is cut off: its header says {} bytes", bytes),
             fmt::format("at most the {} there are", there));
    return bytes;
}

std::uint64_t XmlValues::bytesInBlocks(vtkXMLDataElement& array, const Place& place)
{
    const auto start = headerAt(place, 3, array);
    const std::uint64_t blocks = start[0], size = start[1], last = start[2];
    if (blocks == 0) return 0;
    const std::uint64_t stored = place.end - place.at, there = place.base64 ? stored / 4 * 3 : stored;
    if (blocks > there / headerWordBytes_ || size == 0 || size > largestBlockBytes || last > size)
        fail(array, fmt::format("has {} compressed blocks of {} bytes, the last of {}", blocks, size, last),
             fmt::format("blocks that fit into {} bytes", there));
    const auto header = headerAt(place, 3 + blocks, array);
    const std::uint64_t headerBytes = (3 + blocks) * headerWordBytes_,
                        headerStored = place.base64 ? (headerBytes + 2) / 3 * 4 : headerBytes;
    const std::uint64_t rest = place.base64 ? (stored - headerStored) / 4 * 3 : stored - headerStored;
    std::uint64_t sum = 0, bytes = 0;
    for (std::uint64_t b = 0; b < blocks; ++b) {
        const std::uint64_t packed = header[3 + b], unpacked = b + 1 == blocks && last > 0 ? last : size;
        if (packed > rest - sum || unpacked / mostFromOneByte > packed)
            fail(array, fmt::format("has block {} of {} bytes, packed into {}", b, unpacked, packed),
                 fmt::format("a block within the {} bytes that are left", rest - sum));
        sum += packed;
        bytes += unpacked;
    }
    return bytes;
}

/// VTK reads numbers up to the first word that is not one, and takes an array that ends early for an unreadable one.
std::uint64_t XmlValues::wordsInText(const Place& place, int type, std::string* odd)
{
    std::string text(place.end - place.at, ' ');
    file_.clear();
    file_.seekg(std::streamoff(place.at));
    file_.read(text.data(), std::streamsize(text.size()));
    std::uint64_t words = 0;
    for (std::size_t at = 0, end = 0; at < text.size(); at = end) {
        while (at < text.size() && isSpace(text[at])) ++at;
        for (end = at; end < text.size() && !isSpace(text[end]);) ++end;
        if (at == end || !isNumber({text.data() + at, end - at}, type)) {
            if (odd) *odd = text.substr(at, end - at);
            break;
        }
        ++words;
    }
    return words;
}

std::uint64_t XmlValues::wordsIn(vtkXMLDataElement& array)
{
    const int type = typeOf(array);
    if (type < 0)
        fail(array, "has the type '" + attributeOf(array, "type") + "'", "Int8 to UInt64, Float32 or Float64");
    const Place place = placeOf(array);
    if (attributeOf(array, "format") == "ascii") return wordsInText(place, type == VTK_STRING ? VTK_TYPE_UINT8 : type);
    return bytesIn(array, place) / std::uint64_t(type == VTK_STRING ? 1 : vtkDataArray::GetDataTypeSize(type));
}

void XmlValues::requireTuples(vtkXMLDataElement& array, std::uint64_t tuples)
{
    const std::uint64_t components = componentsOf(array, path_), words = wordsIn(array);
    const int type = typeOf(array);
    if (tuples > words / components && attributeOf(array, "format") == "ascii") {
        std::string odd;
        wordsInText(placeOf(array), type, &odd);
        if (!odd.empty())
            fail(array, fmt::format("has the value {}", inQuotes(odd)),
                 "one of its type " + attributeOf(array, "type"));
    }
    if (tuples > words / components)
        fail(array, fmt::format("has {} values", words), fmt::format("{} x {}", tuples, components));
    if (type == VTK_STRING) requireStrings(array, words, tuples * components);
    bytesInMemory_ += tuples * components * std::uint64_t(type == VTK_STRING ? 1 : vtkDataArray::GetDataTypeSize(type));
}

std::size_t XmlValues::read(vtkXMLDataElement& array, void* values, std::uint64_t first, std::uint64_t count, int type)
{
    const Place place = placeOf(array);
    const std::string format = attributeOf(array, "format");
    file_.clear();
    if (format == "appended")
        return parser_->ReadAppendedData(vtkTypeInt64(place.at) - vtkTypeInt64(appendedAt_), values, first, count,
                                         type);
    return parser_->ReadInlineData(&array, format == "ascii", values, first, count, type);
}

/// VTK writes all strings that it finds into the array, beyond its end, too.
void XmlValues::requireStrings(vtkXMLDataElement& array, std::uint64_t bytes, std::uint64_t most)
{
    std::vector<char> text(std::min<std::uint64_t>(bytes, 1 << 20));
    std::uint64_t strings = 0;
    char last = 0;
    for (std::uint64_t at = 0; at < bytes;) {
        const std::size_t found =
            read(array, text.data(), at, std::min<std::uint64_t>(bytes - at, text.size()), VTK_CHAR);
        if (found == 0) break;
        strings += std::uint64_t(std::count(text.begin(), text.begin() + std::ptrdiff_t(found), '\0'));
        last = text[found - 1];
        at += found;
    }
    if (last != 0) ++strings;
    if (strings > most) fail(array, fmt::format("has {} strings", strings), fmt::format("at most {}", most));
}

std::vector<std::int64_t> XmlValues::integers(vtkXMLDataElement& array, std::uint64_t first, std::uint64_t count)
{
    const int type = typeOf(array);
    if (type == VTK_STRING || type < 0) fail(array, "is text", "whole numbers");
    const auto values = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
    values->SetNumberOfValues(vtkIdType(count));
    const VtkMessages messages;
    const std::size_t found = read(array, values->GetVoidPointer(0), first, count, type);
    if (found < count || messages.failed())
        fail(array, fmt::format("ends at value {}", first + found), fmt::format("{} values", first + count));
    std::vector<std::int64_t> numbers(count);
    for (std::uint64_t i = 0; i < count; ++i) {
        const double value = values->GetComponent(vtkIdType(i), 0);
        constexpr double most = 1e15;  // A double holds whole numbers exactly up to more than this.
        if (!(value >= -most && value <= most))
            fail(array, fmt::format("has the value {}", value), "a number of points");
        numbers[i] = std::int64_t(value);
    }
    return numbers;
}

}  // namespace aeolic
