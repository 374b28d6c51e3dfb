#include "reader/ensight/ensight_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

#include "aeolic/error.h"
#include "base/text.h"
#include "reader/binary/numbers.h"
#include "reader/binary/whole_file.h"

namespace aeolic {
namespace {

constexpr std::size_t kRecord = 80;
constexpr std::size_t kMarker = 4;  // Before and behind each of Fortran's records: how many bytes it has.

bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\0';
}

}  // namespace

EnSightStream::EnSightStream(const EnSightPlace& place) : path_(place.path), data_(wholeFile(place.path))
{
    const auto beginsWith = [&](std::size_t at, const char* text) {
        return lowerCase(data_.substr(std::min(at, data_.size()), std::strlen(text))) == text;
    };
    if (beginsWith(0, "c binary")) {
        format_.encoding = EnSightEncoding::binary;
        at_ = kRecord;
    } else if (beginsWith(kMarker, "fortran binary")) {
        format_.encoding = EnSightEncoding::fortran;
        const std::int32_t marker = rawInteger();
        format_.swapped = marker != std::int32_t(kRecord);
        at_ = 0;
        if (rawInteger() != std::int32_t(kRecord)) fail(fmt::format("its first record has {} bytes", marker), "80");
        at_ = 0;
        line();
    } else if (data_.find('\0') < kRecord) {
        fail("it begins with bytes that are not text", "text, 'C Binary' or 'Fortran Binary'");
    }
    if (at_ > data_.size()) fail("the file is cut off", "an EnSight Gold geometry");
    if (format_.encoding == EnSightEncoding::binary) findByteOrder();
    if (place.step) keepStep(*place.step);
}

EnSightStream::EnSightStream(const EnSightPlace& place, const EnSightFormat& format)
    : path_(place.path), data_(wholeFile(place.path)), format_(format)
{
    if (place.step) keepStep(*place.step);
}

/// The rest of the data is that of one of the steps.
void EnSightStream::keepStep(std::size_t step)
{
    constexpr const char *kBegin = "BEGIN TIME STEP", *kEnd = "END TIME STEP";
    const std::size_t marker = format_.encoding == EnSightEncoding::fortran ? kMarker : 0;
    std::size_t begin = data_.find(kBegin);
    for (std::size_t i = 0; i < step && begin != std::string::npos; ++i) begin = data_.find(kBegin, begin + 1);
    const std::size_t end = begin == std::string::npos ? begin : data_.find(kEnd, begin);
    if (end == std::string::npos)
        fail(fmt::format("the step {} is not there", step + 1), fmt::format("'{}' … '{}' for each step", kBegin, kEnd));
    at_ = begin - std::min(begin, marker);
    line();
    data_.resize(std::max(at_, end - marker));
}

/// C's binary files do not say their byte order. The number of the first part is small in one order alone.
void EnSightStream::findByteOrder()
{
    for (std::size_t at = at_; at + kRecord + 4 <= data_.size(); at += kRecord) {
        if (trimmed(at, at + kRecord) != "part") {
            if (trimmed(at, at + kRecord) == "extents") at += 6 * 4;
            continue;
        }
        at_ = at + kRecord;
        const std::int32_t part = rawInteger();
        format_.swapped = part < 0 || part > 0xffff;
        break;
    }
    at_ = kRecord;
}

void EnSightStream::fail(const std::string& found, const std::string& expected) const
{
    throw InputError(path_, fmt::format("at byte {} {}", std::min(at_, data_.size()), found), expected);
}

std::string EnSightStream::trimmed(std::size_t begin, std::size_t end) const
{
    end = std::min(end, data_.size());
    const std::size_t zero = std::min(data_.find('\0', begin), end);
    std::string text = data_.substr(begin, zero - begin);
    while (!text.empty() && isBlank(text.back())) text.pop_back();
    text.erase(0, std::min(text.find_first_not_of(" \t"), text.size()));
    return withoutControls(withSpaces(std::move(text)), '?');
}

bool EnSightStream::atEnd()
{
    if (format_.encoding == EnSightEncoding::ascii) skipBlanks();
    return at_ >= data_.size();
}

std::string EnSightStream::line()
{
    if (format_.encoding == EnSightEncoding::ascii) {
        if (at_ >= data_.size()) fail("the file is cut off", "a line of text");
        const std::size_t begin = at_, end = std::min(data_.find('\n', begin), data_.size());
        at_ = std::min(end + 1, data_.size());
        return trimmed(begin, end);
    }
    if (format_.encoding == EnSightEncoding::fortran) requireMarker(kRecord, "a line of text");
    if (data_.size() - at_ < kRecord) fail("the file is cut off", "80 bytes of text");
    std::string text = trimmed(at_, at_ + kRecord);
    at_ += kRecord;
    if (format_.encoding == EnSightEncoding::fortran) requireMarker(kRecord, "a line of text");
    return text;
}

std::string EnSightStream::keyword()
{
    if (atEnd()) return {};
    std::string text = line();
    if (text.empty()) fail("80 blank bytes", "a word");  // Lines of text that are blank were passed over.
    return text;
}

void EnSightStream::skipBlanks()
{
    while (at_ < data_.size() && isBlank(data_[at_])) ++at_;
}

std::string EnSightStream::word(const char* item)
{
    skipBlanks();
    if (at_ >= data_.size()) fail("the file is cut off", fmt::format("more numbers for {}", item));
    const std::size_t begin = at_;
    while (at_ < data_.size() && !isBlank(data_[at_])) ++at_;
    return data_.substr(begin, at_ - begin);
}

std::int32_t EnSightStream::rawInteger()
{
    if (data_.size() < 4 || at_ > data_.size() - 4) fail("the file is cut off", "four bytes of a number");
    std::int32_t value = 0;
    convertNumbers<std::int32_t>(here(), NumberType::int32, format_.swapped, {&value, 1});
    at_ += 4;
    return value;
}

void EnSightStream::requireMarker(std::size_t bytes, const char* item)
{
    const std::int32_t marker = rawInteger();
    if (marker < 0 || std::size_t(marker) != bytes)
        fail(fmt::format("a record has {} bytes", marker), fmt::format("{} for {}", bytes, item));
}

bool EnSightStream::emptyRecordFollows() const
{
    constexpr char empty[2 * kMarker] = {};
    return data_.size() - at_ >= sizeof empty && std::memcmp(data_.data() + at_, empty, sizeof empty) == 0;
}

template <class Number>
std::vector<Number> EnSightStream::numbers(std::size_t count, const char* item)
{
    std::vector<Number> values;
    if (format_.encoding == EnSightEncoding::ascii) {
        while (values.size() < count) {
            const std::string text = word(item);
            const auto read = realIn<double>(text);
            const double number = read.value_or(0);
            const bool whole = number == std::floor(number) && std::abs(number) < 2147483648.0;
            if (!read || (std::is_integral_v<Number> && !whole))
                fail(fmt::format("{} has '{}'", item, text.substr(0, 40)), "a number");
            // What is too large for a float is no number, but no fault of the file.
            const bool tooFar = std::abs(number) > double(std::numeric_limits<float>::max());
            values.push_back(!std::is_integral_v<Number> && tooFar ? std::numeric_limits<Number>::quiet_NaN()
                                                                   : static_cast<Number>(number));
        }
        while (at_ < data_.size() && isBlank(data_[at_]) && data_[at_] != '\n') ++at_;
        if (at_ < data_.size() && data_[at_] == '\n') ++at_;
        return values;
    }
    const bool fortran = format_.encoding == EnSightEncoding::fortran;
    if (fortran && count == 0 && !emptyRecordFollows()) return values;  // Some programs write none.
    if (fortran) requireMarker(4 * count, item);
    if (count > (data_.size() - at_) / 4)
        fail(fmt::format("{} has {} numbers, but only {} bytes are left", item, count, data_.size() - at_),
             "a complete file");
    values.resize(count);
    convertNumbers<Number>(here(), std::is_integral_v<Number> ? NumberType::int32 : NumberType::float32,
                           format_.swapped, values);
    at_ += 4 * count;
    if (fortran) requireMarker(4 * count, item);
    return values;
}

void EnSightStream::skipExtents()
{
    if (format_.encoding == EnSightEncoding::ascii)
        for (int axis = 0; axis < 3; ++axis) line();
    else
        floats(6, "the extents");
}

std::int64_t EnSightStream::integer(const char* item)
{
    return integers(1, item).front();
}

std::size_t EnSightStream::count(const char* item)
{
    const std::int64_t value = integer(item);
    if (value < 0) fail(fmt::format("{} is {}", item, value), "a number from 0");
    return std::size_t(value);
}

std::vector<std::int64_t> EnSightStream::integers(std::size_t count, const char* item)
{
    return numbers<std::int64_t>(count, item);
}

std::vector<float> EnSightStream::floats(std::size_t count, const char* item)
{
    return numbers<float>(count, item);
}

}  // namespace aeolic
