#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reader/ensight/ensight_case.h"

namespace aeolic {

/// How the numbers of a case stand in its files. The geometry says it, and holds for the variables.
enum class EnSightEncoding { ascii, binary, fortran };

struct EnSightFormat {
    EnSightEncoding encoding = EnSightEncoding::ascii;
    bool swapped = false;  ///< The file's byte order is not this machine's.
};

/// Reads a geometry or variable file from front to back, all of it in memory. Throws InputError, which begins with the
/// file's name.
class EnSightStream {
public:
    /// Finds the format of a geometry file out.
    explicit EnSightStream(const EnSightPlace& place);
    EnSightStream(const EnSightPlace& place, const EnSightFormat& format);

    const std::string& path() const { return path_; }
    const EnSightFormat& format() const { return format_; }
    bool atEnd();

    /// A line of text or 80 bytes, without blanks around it. It may be empty.
    std::string line();
    /// The next one that is not empty; empty at the end of the file alone.
    std::string keyword();

    std::int64_t integer(const char* item);
    std::size_t count(const char* item);  ///< An integer from 0.
    std::vector<std::int64_t> integers(std::size_t count, const char* item);
    std::vector<float> floats(std::size_t count, const char* item);
    /// The six numbers behind "extents". In text they may touch each other.
    void skipExtents();

    [[noreturn]] void fail(const std::string& found, const std::string& expected) const;

private:
    std::string trimmed(std::size_t begin, std::size_t end) const;
    void findByteOrder();
    void keepStep(std::size_t step);
    void requireMarker(std::size_t bytes, const char* item);
    bool emptyRecordFollows() const;
    const std::uint8_t* here() const { return reinterpret_cast<const std::uint8_t*>(data_.data()) + at_; }
    std::int32_t rawInteger();
    template <class Number>
    std::vector<Number> numbers(std::size_t count, const char* item);
    std::string word(const char* item);
    void skipBlanks();

    std::string path_, data_;
    std::size_t at_ = 0;
    EnSightFormat format_;
};

}  // namespace aeolic
