#include "reader/vtk/legacy/legacy_text.h"

#include <fmt/format.h>
#include <vtkBitArray.h>
#include <vtkByteSwap.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>

#include "aeolic/error.h"
#include "base/memory.h"
#include "reader/binary/numbers.h"

namespace aeolic {
namespace {

std::string upper(std::string_view text)
{
    std::string result(text);
    for (char& c : result)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return result;
}

bool isBlank(char c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/// -1: no such type.
int typeNamed(const std::string& name)
{
    static const std::map<std::string, int> types{{"BIT", VTK_BIT},
                                                  {"CHAR", VTK_CHAR},
                                                  {"SIGNED_CHAR", VTK_SIGNED_CHAR},
                                                  {"UNSIGNED_CHAR", VTK_UNSIGNED_CHAR},
                                                  {"SHORT", VTK_SHORT},
                                                  {"UNSIGNED_SHORT", VTK_UNSIGNED_SHORT},
                                                  {"INT", VTK_INT},
                                                  {"UNSIGNED_INT", VTK_UNSIGNED_INT},
                                                  {"LONG", VTK_LONG},
                                                  {"UNSIGNED_LONG", VTK_UNSIGNED_LONG},
                                                  {"VTKTYPEINT64", VTK_TYPE_INT64},
                                                  {"VTKTYPEUINT64", VTK_TYPE_UINT64},
                                                  {"VTKIDTYPE", VTK_INT},  // So VTK writes it.
                                                  {"FLOAT", VTK_FLOAT},
                                                  {"DOUBLE", VTK_DOUBLE},
                                                  {"STRING", VTK_STRING},
                                                  {"UTF8_STRING", VTK_STRING},
                                                  {"VARIANT", VTK_VARIANT}};
    const auto found = types.find(upper(name));
    return found == types.end() ? -1 : found->second;
}

template <class Value>
bool parse(std::string_view word, Value& value)
{
    if (word.starts_with('+')) word.remove_prefix(1);
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc{} && stop == word.data() + word.size();
}

/// A number that is too large or too small for its type becomes infinite or zero, as strtod() has it.
bool parseReal(std::string_view word, double& value)
{
    if (word.starts_with('+')) word.remove_prefix(1);
    const auto [stop, error] = readReal(word.data(), word.data() + word.size(), value);
    return error == std::errc{} && stop == word.data() + word.size();
}

template <class Value>
bool parseValue(std::string_view word, Value& value)
{
    if constexpr (std::is_floating_point_v<Value>) {
        double real = 0;
        const bool parsed = parseReal(word, real);
        value = static_cast<Value>(real);
        return parsed;
    } else if constexpr (sizeof(Value) == 1) {
        int number = 0;  // Not a letter.
        const bool parsed = parse(word, number);
        value = static_cast<Value>(number);
        return parsed;
    } else {
        return parse(word, value);
    }
}

}  // namespace

LegacyText::LegacyText(const std::string& path) : path_(path)
{
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    const auto bytes = std::uint64_t(std::max<std::streamoff>(0, file.tellg()));
    requireMemory(path, "reading it", 2 * bytes);
    file.seekg(0);
    text_.resize(bytes);
    file.read(text_.data(), std::streamsize(bytes));
    text_.resize(std::size_t(file.gcount()));

    const auto line = [&] {
        const std::size_t begin = at_;
        skipLine();
        return std::string_view(text_).substr(begin, at_ - begin);
    };
    const std::string version(line().substr(0, 64));
    line();  // The title.
    const std::string encoding = upper(next().substr(0, 16));
    const bool hasVersion = version.starts_with("# vtk DataFile Version ") && version.find('.') != std::string::npos;
    if (!hasVersion || (encoding != "ASCII" && encoding != "BINARY"))
        throw InputError(path_, "it does not begin like a legacy VTK file",
                         "'# vtk DataFile Version N.N', a title, and ASCII or BINARY in the first three lines");
    binary_ = encoding == "BINARY";
}

std::string_view LegacyText::next()
{
    while (at_ < text_.size() && isBlank(text_[at_])) ++at_;
    const std::size_t begin = at_;
    while (at_ < text_.size() && !isBlank(text_[at_])) ++at_;
    return std::string_view(text_).substr(begin, at_ - begin);
}

bool LegacyText::atEnd()
{
    while (at_ < text_.size() && isBlank(text_[at_])) ++at_;
    return at_ == text_.size();
}

void LegacyText::failWord(std::string_view found, const std::string& expected) const
{
    if (found.empty()) throw InputError(path_, "the file is cut off: it ends early", expected);
    std::string shown;
    for (const char c : found.substr(0, 40)) shown += c >= ' ' && c <= '~' ? c : '?';
    throw InputError(path_, fmt::format("'{}' at byte {}", shown, at_ - found.size()), expected);
}

std::string LegacyText::keyword()
{
    return upper(next().substr(0, 64));
}

std::string LegacyText::word(const char* what)
{
    const std::string_view found = next();
    if (found.empty() || found.size() > 1000) failWord(found, what);
    return std::string(found);
}

std::string LegacyText::name()
{
    const std::string encoded = word("a name");
    std::string decoded;
    for (std::size_t i = 0; i < encoded.size(); ++i) {
        unsigned code = 0;
        const char* hex = encoded.data() + i + 1;
        if (encoded[i] == '%' && i + 2 < encoded.size() && std::from_chars(hex, hex + 2, code, 16).ptr == hex + 2 &&
            code != 0) {
            decoded += static_cast<char>(code);
            i += 2;
        } else {
            decoded += encoded[i];
        }
    }
    return decoded;
}

std::int64_t LegacyText::wholeNumber(const char* what)
{
    const std::string_view found = next();
    std::int64_t value = 0;
    if (!parse(found, value)) failWord(found, what);
    return value;
}

std::int64_t LegacyText::count(const char* what, std::int64_t most)
{
    const std::string_view found = next();
    std::int64_t value = 0;
    if (!parse(found, value) || value < 0 || value > most) failWord(found, fmt::format("{} from 0 to {}", what, most));
    return value;
}

double LegacyText::number(const char* what)
{
    const std::string_view found = next();
    double value = 0;
    if (!parseReal(found, value)) failWord(found, what);
    return value;
}

bool LegacyText::takes(const std::string& expected)
{
    const std::size_t before = at_;
    if (keyword() == expected) return true;
    at_ = before;
    return false;
}

void LegacyText::skipLine()
{
    const std::size_t end = text_.find('\n', at_);
    at_ = end == std::string::npos ? text_.size() : end + 1;
}

void LegacyText::skipToBlankLine()
{
    skipLine();
    while (at_ < text_.size()) {
        const std::size_t begin = at_;
        skipLine();
        if (std::all_of(text_.begin() + std::ptrdiff_t(begin), text_.begin() + std::ptrdiff_t(at_), isBlank)) return;
    }
}

void LegacyText::requireBytes(double bytes, const std::string& label, std::int64_t values) const
{
    const auto left = double(text_.size() - at_);
    if (bytes > left)
        throw InputError(path_, fmt::format("the file is cut off: {:.0f} bytes are left for {}", left, label),
                         fmt::format("{} values", values));
}

vtkSmartPointer<vtkDataArray> LegacyText::array(const std::string& type, std::int64_t tuples, std::int64_t components,
                                                const std::string& label)
{
    const int number = typeNamed(type);
    if (number < 0) failWord(type, "a type of values: float, double, int …");
    const std::int64_t values = tuples * components;  // Both are bounded: at most 2^40 of at most 1000.
    const bool isText = number == VTK_STRING || number == VTK_VARIANT;
    const int bits = isText || !binary_ ? 8 : number == VTK_BIT ? 1 : 8 * vtkDataArray::GetDataTypeSize(number);
    requireBytes(binary_ || values == 0 ? double(values) * bits / 8 : 2 * double(values) - 1, label, values);
    if (binary_ || isText) skipLine();
    if (binary_) requireBytes(double(values) * bits / 8, label, values);
    if (isText) {
        skipStrings(values, label);
        return nullptr;
    }
    auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(number));
    array->SetNumberOfComponents(int(components));
    array->SetNumberOfTuples(tuples);
    binary_ ? readBinary(*array) : readText(*array, label);
    return array;
}

vtkSmartPointer<vtkDataArray> LegacyText::colors(std::int64_t tuples, std::int64_t components, const std::string& label)
{
    if (binary_) return array("unsigned_char", tuples, components, label);
    const auto shares = array("float", tuples, components, label);
    auto bytes = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(VTK_UNSIGNED_CHAR));
    bytes->SetNumberOfComponents(int(components));
    bytes->SetNumberOfTuples(tuples);
    for (vtkIdType i = 0; i < tuples; ++i)
        for (int c = 0; c < int(components); ++c) {
            const double share = shares->GetComponent(i, c);
            bytes->SetComponent(i, c, share > 0 ? double(int(std::min(share, 1.0) * 255 + 0.5)) : 0);
        }
    return bytes;
}

void LegacyText::readText(vtkDataArray& values, const std::string& label)
{
    const vtkIdType count = values.GetNumberOfValues();
    const auto fill = [&](auto* target) {
        for (vtkIdType i = 0; i < count; ++i) {
            const std::string_view found = next();
            if (!parseValue(found, target[i])) failWord(found, fmt::format("value {} of {} for {}", i, count, label));
        }
    };
    if (auto* bits = vtkBitArray::SafeDownCast(&values)) {
        for (vtkIdType i = 0; i < count; ++i) bits->SetValue(i, count > 0 && wholeNumber("0 or 1") != 0);
        return;
    }
    switch (values.GetDataType()) {
        vtkTemplateMacro(fill(static_cast<VTK_TT*>(values.GetVoidPointer(0))));
        default:
            break;
    }
}

void LegacyText::readBinary(vtkDataArray& values)
{
    const vtkIdType count = values.GetNumberOfValues();
    if (count == 0) return;
    const bool bits = values.GetDataType() == VTK_BIT;
    const auto size = std::size_t(bits ? 1 : values.GetDataTypeSize());
    const std::size_t bytes = bits ? std::size_t(count + 7) / 8 : std::size_t(count) * size;
    requireBytes(double(bytes), "bits", count);
    void* target = values.GetVoidPointer(0);
    std::memcpy(target, text_.data() + at_, bytes);
    at_ += bytes;
    if (size == 2) vtkByteSwap::Swap2BERange(target, std::size_t(count));
    if (size == 4) vtkByteSwap::Swap4BERange(target, std::size_t(count));
    if (size == 8) vtkByteSwap::Swap8BERange(target, std::size_t(count));
}

/// In text each stands on a line. In binary files the first two bits say how many bytes hold its length.
void LegacyText::skipStrings(std::int64_t count, const std::string& label)
{
    for (std::int64_t i = 0; i < count; ++i) {
        if (at_ >= text_.size()) requireBytes(1, label, count);
        if (!binary_) {
            skipLine();
            continue;
        }
        const auto first = static_cast<unsigned char>(text_[at_]);
        const std::size_t lengthBytes = first >> 6 == 3 ? 1 : first >> 6 == 2 ? 2 : first >> 6 == 1 ? 4 : 8;
        requireBytes(double(lengthBytes), label, count);
        std::uint64_t length = first & 0x3f;
        for (std::size_t k = 1; k < lengthBytes; ++k) length = length << 8 | static_cast<unsigned char>(text_[at_ + k]);
        at_ += lengthBytes;
        requireBytes(double(length), label, count);
        at_ += length;
    }
}

}  // namespace aeolic
