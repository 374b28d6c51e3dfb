#include "reader/fluent/fluent_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "aeolic/error.h"
#include "base/text.h"
#include "reader/binary/whole_file.h"

namespace aeolic {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";
constexpr std::string_view kEnd = "End of Binary Section";
constexpr const char* kFromGmsh =
    "a Fluent mesh ('gmsh NAME.msh -save -o NAME.vtk' or 'meshio convert NAME.msh NAME.vtu' make one of VTK's of it)";

/// For messages, which are one line.
std::string plain(std::string_view text)
{
    std::string out(text.substr(0, 40));
    for (char& c : out)
        if (static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > 126) c = '?';
    return out;
}

}  // namespace

FluentText::FluentText(const std::string& path) : path_(path), data_(wholeFile(path))
{
    if (data_.starts_with("\x1f\x8b"))
        throw InputError(path, "it is packed by gzip", "a Fluent file as it is (gunzip FILE)");
    refuseGmsh();
    skipBlank();
    if (at_ >= data_.size() || data_[at_] != '(') throw InputError(path, "it does not begin like a Fluent file", "'('");
    for (; at_ < data_.size(); skipBlank()) readSection();
}

/// Gmsh gives its meshes the same ending.
void FluentText::refuseGmsh() const
{
    const std::size_t at = data_.find_first_not_of(kBlanks);
    if (at == std::string::npos) return;
    const std::string_view text = std::string_view(data_).substr(at);
    if (text.starts_with("$NOD")) fail("it is a mesh of Gmsh, not of Fluent", kFromGmsh);
    constexpr std::string_view head = "$MeshFormat";
    if (!text.starts_with(head)) return;
    const std::size_t begin = std::min(text.find_first_not_of(kBlanks, head.size()), text.size());
    const std::string_view version = text.substr(begin, text.find_first_of(kBlanks, begin) - begin);
    const std::string format = version.empty() ? "" : fmt::format(" (format {})", plain(version));
    fail(fmt::format("it is a mesh of Gmsh{}, not of Fluent", format), kFromGmsh);
}

void FluentText::fail(const std::string& found, const std::string& expected) const
{
    throw InputError(path_, found, expected);
}

void FluentText::skipBlank()
{
    at_ = std::min(data_.find_first_not_of(kBlanks, at_), data_.size());
}

/// The text between the parenthesis here and the one that closes it; text in quotes is passed over.
std::string_view FluentText::parentheses()
{
    const std::size_t begin = ++at_;
    for (int depth = 1; at_ < data_.size(); ++at_) {
        at_ = std::min(data_.find_first_of("()\"", at_), data_.size());
        if (at_ == data_.size()) break;
        if (data_[at_] == '"') {
            for (++at_; at_ < data_.size() && data_[at_] != '"'; ++at_)
                if (data_[at_] == '\\') ++at_;  // What stands behind it is not the end.
            if (at_ >= data_.size()) break;
        } else if (data_[at_] == '(') {
            ++depth;
        } else if (--depth == 0) {
            return std::string_view(data_).substr(begin, at_++ - begin);
        }
    }
    fail(fmt::format("the file is cut off within the section at byte {}", begin - 1), "')'");
}

void FluentText::readSection()
{
    if (data_[at_] != '(')
        fail(fmt::format("found '{}' at byte {}", plain(std::string_view(data_).substr(at_, 10)), at_), "'('");
    const std::size_t begin = at_++;
    skipBlank();
    int index = -1;
    const auto [end, error] = std::from_chars(data_.data() + at_, data_.data() + data_.size(), index);
    if (error != std::errc{} || index < 0)
        fail(fmt::format("the section at byte {} has no index", begin), "a whole number");
    at_ = std::size_t(end - data_.data());
    FluentSection section;
    section.binary = index >= 2000 && index < 4000;
    section.doubles = index >= 3000;
    section.index = section.binary ? index % 1000 : index;
    if (!section.binary) {
        at_ = begin;
        std::string_view all = parentheses();
        all.remove_prefix(std::size_t(end - data_.data()) - begin - 1);
        all.remove_prefix(std::min(all.find_first_not_of(kBlanks), all.size()));
        section.head = all;
        if (all.starts_with('(')) {
            const std::size_t close = std::min(all.find(')'), all.size() - 1), open = all.find('(', close);
            section.head = all.substr(1, close - 1);
            if (open != std::string_view::npos)
                section.body = all.substr(open + 1, std::min(all.rfind(')'), all.size()) - open - 1);
        }
        sections_.push_back(section);
        return;
    }
    skipBlank();
    if (at_ >= data_.size() || data_[at_] != '(') fail(fmt::format("the section at byte {} has no head", begin), "'('");
    section.head = parentheses();
    skipBlank();
    const std::size_t body = at_ < data_.size() && data_[at_] == '(' ? at_ + 1 : at_;
    // Bytes may look like anything. The words behind them do not stand in numbers by chance.
    at_ = std::min(data_.find(kEnd, at_), data_.size());
    section.body = std::string_view(data_).substr(body, at_ - body);
    at_ = std::min(data_.find(')', at_), data_.size());
    if (at_ == data_.size())
        fail(fmt::format("the file is cut off within the section at byte {}", begin), std::string(kEnd));
    ++at_;
    sections_.push_back(section);
}

std::vector<std::string> FluentText::words(const FluentSection& section) const
{
    std::vector<std::string> words;
    for (std::size_t at = section.head.find_first_not_of(kBlanks); at != std::string_view::npos;) {
        const std::size_t end = std::min(section.head.find_first_of(kBlanks, at), section.head.size());
        words.push_back(withoutControls(std::string(section.head.substr(at, end - at)), '?'));  // Names of zones, too.
        at = section.head.find_first_not_of(kBlanks, end);
    }
    return words;
}

std::int64_t FluentText::number(const std::string& word, int base) const
{
    const auto value = wholeTextAs<std::int64_t>(word, base);
    if (!value || *value < 0) fail(fmt::format("found '{:.40}' in a section's head", word), "a whole number from 0");
    return *value;
}

void FluentNumbers::endsTooEarly() const
{
    text_.fail(fmt::format("a section ({} ({}) ends too early", section_.index, plain(section_.head)), "more numbers");
}

std::string_view FluentNumbers::word()
{
    const std::string_view body = section_.body;
    at_ = std::min(body.find_first_not_of(" \t\r\n(", at_), body.size());
    const std::size_t begin = at_;
    at_ = std::min(body.find_first_of(" \t\r\n()", at_), body.size());
    if (begin == at_) endsTooEarly();
    return body.substr(begin, at_ - begin);
}

void FluentNumbers::isNone(std::string_view word, const char* expected) const
{
    text_.fail(fmt::format("found '{}' in a section ({} ({})", plain(word), section_.index, plain(section_.head)),
               expected);
}

template <class Number>
Number FluentNumbers::fromBytes(NumberType type)
{
    if (section_.body.size() - at_ < bytesOf(type)) endsTooEarly();
    Number value = 0;
    convertNumbers<Number>(reinterpret_cast<const std::uint8_t*>(section_.body.data()) + at_, type, swapped_,
                           {&value, 1});
    at_ += bytesOf(type);
    return value;
}

std::int64_t FluentNumbers::whole()
{
    if (section_.binary) return fromBytes<std::int64_t>(NumberType::int32);
    const std::string_view text = word();
    const auto value = wholeTextAs<std::int64_t>(text, 16);
    if (!value) isNone(text, "a whole number to the base 16");
    return *value;
}

double FluentNumbers::real()
{
    if (section_.binary) return fromBytes<double>(section_.doubles ? NumberType::float64 : NumberType::float32);
    const std::string_view text = word();
    const auto value = realIn<double>(text);
    if (!value) isNone(text, "a number");
    return *value;
}

}  // namespace aeolic
