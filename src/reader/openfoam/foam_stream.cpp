#include "reader/openfoam/foam_stream.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "aeolic/error.h"
#include "base/text.h"

namespace aeolic {
namespace {

constexpr unsigned kBufferBytes = 1 << 18;
constexpr std::size_t kLongestToken = 4096;
constexpr std::uint64_t kValuesAtOnce = 4096;
constexpr std::string_view kSigns = "(){}[];";

bool isBlank(int c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/// What a message can show of a token.
std::string shown(const std::string& token)
{
    if (token.empty()) return "the end of the file";
    std::string text = token.substr(0, 40);
    for (char& c : text)
        if (c < ' ' || c > '~') c = '?';
    return "'" + text + "'";
}

}  // namespace

std::string foamFileOf(const FoamPath& file)
{
    std::error_code error;
    for (const std::string& name : {file.path.string(), file.path.string() + ".gz"})
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

FoamStream::FoamStream(const FoamPath& file) : path_(foamFileOf(file))
{
    const std::string name = file.path.string();
    if (path_.empty()) throw InputError(name, "no such file, nor " + name + ".gz", "a file of an OpenFOAM case");
    file_.reset(gzopen(path_.c_str(), "rb"));
    if (!file_) throw InputError(path_, "it cannot be opened", "a file that can be read");
    gzbuffer(file_.get(), kBufferBytes);
    readHeader();
    if (class_ == "decomposedBlockData") enterBlock(std::max(file.block, 0));
}

FoamStream::~FoamStream() = default;

void FoamStream::Close::operator()(gzFile_s* file) const
{
    gzclose_r(file);
}

void FoamStream::fail(const std::string& found, const std::string& expected) const
{
    throw InputError(path_, found, expected);
}

/// zlib gives out the bytes in front of the place where a file is damaged first, because the header names the file.
void FoamStream::requireUndamaged() const
{
    int error = Z_OK;
    const char* message = gzerror(file_.get(), &error);
    if (error == Z_OK || error == Z_STREAM_END) return;
    if (error == Z_BUF_ERROR) fail("the gzip file is cut off", "a complete file");
    fail(fmt::format("it cannot be unpacked ({})", error == Z_ERRNO ? "error" : message), "a complete, undamaged file");
}

int FoamStream::peek()
{
    if (place_ >= end_) return -1;
    if (next_ == kNone) next_ = gzgetc(file_.get());
    if (next_ < 0) requireUndamaged();
    return next_;
}

int FoamStream::get()
{
    const int c = peek();
    if (c < 0) return c;
    next_ = kNone;
    ++place_;
    return c;
}

void FoamStream::bytes(void* to, std::size_t size)
{
    auto* out = static_cast<char*>(to);
    if (next_ >= 0 && size > 0) {
        *out++ = char(get());
        --size;
    }
    const bool within = size <= end_ - place_;
    const int read = within ? gzread(file_.get(), out, unsigned(size)) : 0;
    if (read != int(size)) {
        requireUndamaged();
        fail("the file is cut off within a list", "a complete file");
    }
    place_ += size;
}

/// `place` lies ahead. Bytes of a plain file are not read on the way.
void FoamStream::goToPlace(std::uint64_t place)
{
    if (place == place_) return;
    next_ = kNone;
    place_ = place;
    if (place > end_ || gzseek(file_.get(), z_off_t(place), SEEK_SET) < 0)
        fail("the file is cut off within a list", "a complete file");
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
            for (int last = 0, c = get(); last != '*' || c != '/'; last = c, c = get())
                if (c < 0) fail("a comment has no end", "*/");
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

template <class Number>
Number FoamStream::number(const std::string& item)
{
    const std::string text = token();
    const std::string_view plain = std::string_view(text).substr(text.starts_with('+') ? 1 : 0);
    std::optional<Number> value;
    if constexpr (std::is_same_v<Number, double>)
        value = realIn<double>(plain);
    else
        value = wholeTextAs<Number>(plain);
    if (!value)
        fail(fmt::format("{}: found {}", item, shown(text)),
             std::is_same_v<Number, double> ? "a number" : "a whole number");
    return *value;
}

double FoamStream::scalar(const std::string& item)
{
    return number<double>(item);
}

std::uint64_t FoamStream::count(const std::string& item)
{
    const auto value = number<std::int64_t>(item);
    if (value < 0) fail(fmt::format("{}: found {}", item, value), "a number that is not negative");
    return std::uint64_t(value);
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
    if (format != "ascii" && format != "binary") fail("format is " + shown(format), "ascii or binary");
    binary_ = format == "binary";
    const auto has = [&](const char* words) { return arch.find(words) != std::string::npos; };
    swapped_ = has("MSB");
    labelType_ = has("label=64") ? NumberType::int64 : NumberType::int32;
    scalarType_ = has("scalar=32") ? NumberType::float32 : NumberType::float64;
}

/// Blocks are lists of bytes, one for each processor. The first has the header of all.
void FoamStream::enterBlock(int block)
{
    for (int number = 0;; ++number) {
        const std::string item = fmt::format("the block of processor {}", number);
        const std::uint64_t size = count(item);
        expect("(", item);
        const std::uint64_t end = place_ + size;
        if (number == 0) readHeader();
        if (number == block) {
            end_ = end;
            return;
        }
        goToPlace(end);
        expect(")", item);
    }
}

template <class Number>
std::uint64_t FoamStream::list(NumberType type, std::size_t components, const std::string& item,
                               const std::function<void(std::uint64_t, std::span<const Number>)>& take)
{
    std::vector<Number> numbers(components);
    const auto readOne = [&] {
        if (components > 1) expect("(", item);
        for (Number& each : numbers) each = number<Number>(item);
        if (components > 1) expect(")", item);
    };
    const bool counted = peekToken() != "(";
    const std::uint64_t size = counted ? count(item) : 0;
    const std::string next = peekToken();
    if (counted && size == 0 && next != "(" && next != "{") return 0;  // An empty list may have no brackets.
    if (binary_ && counted && size > 0 && next == "(") {
        token();
        const std::size_t valueBytes = components * bytesOf(type);
        std::vector<std::uint8_t> raw;
        if (!take) goToPlace(place_ + size * valueBytes);
        for (std::uint64_t i = 0, some = 0; take && i < size; i += some) {
            some = std::min(size - i, kValuesAtOnce);
            raw.resize(std::size_t(some) * valueBytes);
            numbers.resize(std::size_t(some) * components);
            bytes(raw.data(), raw.size());
            convertNumbers<Number>(raw.data(), type, swapped_, numbers);
            take(i, numbers);
        }
        if (get() != ')')
            fail(fmt::format("{}: no ')' behind {} binary values", item, size), "as many values as the list says");
        return size;
    }
    if (counted && next == "{") {  // All the same.
        token();
        readOne();
        expect("}", item);
        for (std::uint64_t i = 0; take && i < size; ++i) take(i, numbers);
        return size;
    }
    expect("(", item);
    std::uint64_t found = 0;
    for (; peekToken() != ")"; ++found) {
        if (counted && found == size) fail(fmt::format("{}: more than {} values", item, size), "as many as it says");
        readOne();
        if (take) take(found, numbers);
    }
    token();
    if (counted && found != size) fail(fmt::format("{}: {} values", item, found), fmt::format("{}, as it says", size));
    return found;
}

std::uint64_t FoamStream::values(int components, const std::string& item, const TakeValues& take)
{
    return list<double>(scalarType_, std::size_t(components), item, take);
}

std::uint64_t FoamStream::labels(const std::string& item, const TakeLabels& take)
{
    return list<std::int64_t>(labelType_, 1, item, take);
}

void FoamStream::skipEntry(const std::string& item)
{
    int depth = 0;
    const bool isDictionary = peekToken() == "{";
    for (;;) {
        const std::string word = token();
        if (word.empty()) fail(fmt::format("the file is cut off within {}", item), "a complete file");
        if (word == ";" && depth == 0) return;
        if (word == "(" || word == "{" || word == "[") ++depth;
        if (word == ")" || word == "}" || word == "]") {
            if (--depth < 0) fail(fmt::format("{}: found '{}'", item, word), "an entry that ends with ';'");
            if (depth == 0 && isDictionary) return;
        }
        if (!word.starts_with("List<") || !word.ends_with('>')) continue;
        const std::string type = word.substr(5, word.size() - 6);  // Binary values are no tokens.
        if (type == "label")
            labels(item, nullptr);
        else if (const int components = foamComponents(type))
            values(components, item, nullptr);
    }
}

void FoamStream::goTo(const std::string& name, const std::string& expected)
{
    for (std::string key = token(); key != name; key = token()) {
        if (key.empty()) fail("it has no " + name, expected);
        skipEntry(key);
    }
}

void FoamStream::finish()
{
    std::vector<char> rest(kBufferBytes);
    while (peek() >= 0) {
        next_ = kNone;
        const int read = gzread(file_.get(), rest.data(), kBufferBytes);
        if (read < 0) requireUndamaged();
        place_ += 1 + std::uint64_t(std::max(read, 0));
    }
}

}  // namespace aeolic
