#include "reader/openfoam/foam_stream.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <utility>

#include "aeolic/error.h"
#include "reader/binary/numbers.h"

namespace aeolic {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 18;
constexpr std::size_t kLongestToken = 4096;
constexpr std::uint64_t kMostUniform = std::uint64_t{1} << 31;
constexpr std::size_t kMostComponents = 9, kLargestValue = kMostComponents * sizeof(double);
constexpr std::string_view kSigns = "(){}[];";

bool isBlank(int c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f';
}

/// What a message can show of a token.
std::string shown(const std::string& token)
{
    if (token.empty()) return "the end of the file";
    std::string text = token.substr(0, 40);
    for (char& c : text)
        if (static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > '~') c = '?';
    return "'" + text + "'";
}

}  // namespace

struct FoamStream::File {
    gzFile file = nullptr;
    std::vector<char> buffer = std::vector<char>(kBufferBytes);
    std::size_t at = 0, end = 0;
    ~File()
    {
        if (file) gzclose_r(file);
    }
};

std::string foamFileOf(const std::string& path)
{
    std::error_code error;
    for (const std::string& name : {path, path + ".gz"})
        if (std::filesystem::is_regular_file(name, error)) return name;
    return "";
}

int foamComponents(std::string_view type)
{
    constexpr std::pair<std::string_view, int> types[] = {{"scalar", 1}, {"vector", 3},          {"symmTensor", 6},
                                                          {"tensor", 9}, {"sphericalTensor", 1}, {"vector2D", 2}};
    for (const auto& [name, components] : types)
        if (name == type) return components;
    return 0;
}

FoamStream::FoamStream(const std::string& path) : path_(foamFileOf(path)), file_(std::make_unique<File>())
{
    if (path_.empty()) throw InputError(path, "no such file, nor " + path + ".gz", "a file of an OpenFOAM case");
    file_->file = gzopen(path_.c_str(), "rb");
    if (!file_->file) throw InputError(path_, "it cannot be opened", "a file that can be read");
    gzbuffer(file_->file, unsigned(kBufferBytes));
    readHeader();
}

FoamStream::~FoamStream() = default;

void FoamStream::fail(const std::string& found, const std::string& expected) const
{
    throw InputError(path_, found, expected);
}

int FoamStream::peek()
{
    File& f = *file_;
    if (f.at < f.end) return static_cast<unsigned char>(f.buffer[f.at]);
    const int read = gzread(f.file, f.buffer.data(), unsigned(f.buffer.size()));
    int error = Z_OK;
    const char* message = gzerror(f.file, &error);
    // Bytes in front of the place where the file ends are given out first, because the header names the damaged file.
    if (read < 0 || (read == 0 && error != Z_OK && error != Z_STREAM_END))
        fail(error == Z_BUF_ERROR ? "the gzip file is cut off"
                                  : fmt::format("it cannot be unpacked ({})", error == Z_ERRNO ? "error" : message),
             "a complete, undamaged file");
    f.at = 0;
    f.end = std::size_t(read);
    return read == 0 ? -1 : static_cast<unsigned char>(f.buffer[0]);
}

int FoamStream::get()
{
    const int c = peek();
    if (c >= 0) ++file_->at;
    return c;
}

void FoamStream::bytes(void* to, std::size_t size)
{
    auto* out = static_cast<char*>(to);
    while (size > 0) {
        if (peek() < 0) fail("the file is cut off within a list", "a complete file");
        const std::size_t some = std::min(size, file_->end - file_->at);
        std::memcpy(out, file_->buffer.data() + file_->at, some);
        file_->at += some;
        out += some;
        size -= some;
    }
}

void FoamStream::skipBlank()
{
    for (;;) {
        while (isBlank(peek())) get();
        if (peek() != '/') return;
        get();
        if (peek() == '/') {
            while (peek() >= 0 && peek() != '\n') get();
        } else if (peek() == '*') {
            get();
            for (int last = 0, c = get();; last = c, c = get()) {
                if (c < 0) fail("a comment has no end", "*/");
                if (last == '*' && c == '/') break;
            }
        } else {
            fail("found '/'", "a comment, // or /*");
        }
    }
}

std::string FoamStream::peekToken()
{
    if (!hasKept_) kept_ = token();
    hasKept_ = true;
    return kept_;
}

std::string FoamStream::token()
{
    if (std::exchange(hasKept_, false)) return std::exchange(kept_, {});
    skipBlank();
    std::string text;
    const int first = get();
    if (first < 0) return text;
    text = char(first);
    if (kSigns.find(char(first)) != std::string_view::npos) return text;
    quoted_ = first == '"';
    if (quoted_) {
        text.clear();
        for (int c = get(); c != '"'; c = get()) {
            if (c < ' ' || text.size() > kLongestToken) fail("a quoted text has no end", "a closing quote");
            text += char(c);
        }
        return text;
    }
    if (first == '#' && peek() == '{') {  // A program, up to #}.
        for (int last = get(), c = get(); last != '#' || c != '}'; last = c, c = get())
            if (c < 0) fail("the text behind #{ has no end", "#}");
        return "#{}";
    }
    if (first < ' ' || first == 127) fail(fmt::format("found the byte {}", first), "words and numbers");
    // A word may have brackets, as div(phi,U) does; a number may not: a list follows at once, as in 3(0 1 2).
    const bool number = (first >= '0' && first <= '9') || first == '-' || first == '+' || first == '.';
    int depth = 0;
    for (int c = peek(); c >= 0 && !isBlank(c) && c != ';' && c != '{' && c != '}' && c != '"'; c = peek()) {
        if (c == '(' && number) break;
        if ((c == '[' || c == ']') && depth == 0) break;
        depth += c == '(';
        if (c == ')' && --depth < 0) break;
        if (c < ' ' || c == 127) fail(fmt::format("found the byte {} within a word", c), "words and numbers");
        if (text.size() > kLongestToken) fail("a word of more than 4096 letters", "words and numbers");
        text += char(get());
    }
    return text;
}

void FoamStream::expect(std::string_view sign, const std::string& item)
{
    const std::string found = token();
    if (found != sign) fail(fmt::format("{}: found {}", item, shown(found)), fmt::format("'{}'", sign));
}

std::int64_t FoamStream::label(const std::string& item)
{
    const std::string text = token();
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size())
        fail(fmt::format("{}: found {}", item, shown(text)), "a whole number");
    return value;
}

std::uint64_t FoamStream::count(const std::string& item)
{
    const std::int64_t value = label(item);
    if (value < 0) fail(fmt::format("{}: found {}", item, value), "a number that is not negative");
    return std::uint64_t(value);
}

double FoamStream::scalar(const std::string& item)
{
    const std::string text = token();
    double value = 0;
    const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const auto [end, error] = readReal(begin, text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size())
        fail(fmt::format("{}: found {}", item, shown(text)), "a number");
    return value;
}

void FoamStream::takeArch(const std::string& arch)
{
    const auto bits = [&](const char* what, std::size_t& bytes) {
        const std::size_t at = arch.find(what);
        if (at == std::string::npos) return;
        const std::string number = arch.substr(at + std::strlen(what), 2);
        if (number != "32" && number != "64")
            fail(fmt::format("arch is '{}'", arch), fmt::format("{}32 or {}64", what, what));
        bytes = number == "64" ? 8 : 4;
    };
    if (arch.find("MSB") != std::string::npos)
        fail(fmt::format("arch is '{}', of another kind of machine", arch), "LSB, or text");
    bits("label=", labelBytes_);
    bits("scalar=", scalarBytes_);
}

void FoamStream::readHeader()
{
    const char* expected = "an OpenFOAM file, which begins with FoamFile";
    if (token() != "FoamFile") fail("it has no FoamFile header", expected);
    expect("{", "header");
    std::string format, arch;
    for (std::string key = token(); key != "}"; key = token()) {
        if (key.empty()) fail("the header has no end", expected);
        std::string value = peekToken();
        if (key == "format") format = value;
        if (key == "class") class_ = value;
        if (key == "arch") arch = value;
        skipEntry("header");
    }
    if (format != "ascii" && format != "binary") fail("format is '" + format + "'", "ascii or binary");
    binary_ = format == "binary";
    if (binary_) takeArch(arch);
}

template <class Parse, class Take>
std::uint64_t FoamStream::list(std::size_t valueBytes, const std::string& item, const Parse& parse, const Take& take)
{
    const bool counted = peekToken() != "(";
    const std::uint64_t size = counted ? count(item) : 0;
    const std::string next = peekToken();
    if (counted && size == 0 && next != "(" && next != "{") return 0;  // An empty list may have no brackets.
    if (binary_ && counted && size > 0 && next == "(") {
        token();
        std::array<char, kLargestValue> raw{};
        for (std::uint64_t i = 0; i < size; ++i) {
            bytes(raw.data(), valueBytes);
            parse(raw.data());
            take(i);
        }
        if (get() != ')')
            fail(fmt::format("{}: no ')' behind {} binary values", item, size), "as many values as the list says");
        return size;
    }
    if (counted && next == "{") {  // All the same.
        if (size > kMostUniform) fail(fmt::format("{}: {} values", item, size), "at most 2^31");
        token();
        parse(nullptr);
        expect("}", item);
        for (std::uint64_t i = 0; i < size; ++i) take(i);
        return size;
    }
    expect("(", item);
    std::uint64_t found = 0;
    for (; peekToken() != ")"; ++found) {
        if (counted && found == size) fail(fmt::format("{}: more than {} values", item, size), "as many as it says");
        parse(nullptr);
        take(found);
    }
    token();
    if (counted && found != size) fail(fmt::format("{}: {} values", item, found), fmt::format("{}, as it says", size));
    return found;
}

std::uint64_t FoamStream::values(int components, const std::string& item, const TakeValues& take)
{
    std::array<double, kMostComponents> value{};
    const auto parse = [&](const char* raw) {
        if (!raw && components > 1) expect("(", item);
        for (int c = 0; c < components; ++c) {
            double& number = value[std::size_t(c)];
            float single = 0;
            if (!raw) {
                number = scalar(item);
            } else if (scalarBytes_ == 8) {
                std::memcpy(&number, raw + 8 * c, 8);
            } else {
                std::memcpy(&single, raw + 4 * c, 4);
                number = single;
            }
        }
        if (!raw && components > 1) expect(")", item);
    };
    return list(std::size_t(components) * scalarBytes_, item, parse, [&](std::uint64_t i) { take(i, value.data()); });
}

std::uint64_t FoamStream::labels(const std::string& item, const TakeLabel& take)
{
    std::int64_t value = 0;
    const auto parse = [&](const char* raw) {
        std::int32_t small = 0;
        if (!raw) {
            value = label(item);
        } else if (labelBytes_ == 8) {
            std::memcpy(&value, raw, 8);
        } else {
            std::memcpy(&small, raw, 4);
            value = small;
        }
    };
    return list(labelBytes_, item, parse, [&](std::uint64_t i) { take(i, value); });
}

void FoamStream::skipEntry(const std::string& item)
{
    int depth = 0;
    for (;;) {
        const std::string word = token();
        if (word.empty()) fail(fmt::format("the file is cut off within {}", item), "a complete file");
        if (word == ";" && depth == 0) return;
        if (word == "(" || word == "{" || word == "[") ++depth;
        if (word == ")" || word == "}" || word == "]") {
            if (--depth < 0) fail(fmt::format("{}: found '{}'", item, word), "an entry that ends with ';'");
            if (depth == 0 && word == "}") return;
        }
        if (!word.starts_with("List<") || !word.ends_with('>')) continue;
        const std::string type = word.substr(5, word.size() - 6);  // Binary values are no tokens.
        if (type == "label")
            labels(item, [](auto, auto) {});
        else if (const int components = foamComponents(type))
            values(components, item, [](auto, auto) {});
    }
}

void FoamStream::finish()
{
    while (peek() >= 0) file_->at = file_->end;
}

}  // namespace aeolic
