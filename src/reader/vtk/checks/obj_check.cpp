#include "reader/vtk/checks/obj_check.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>

#include "aeolic/error.h"

namespace aeolic {
namespace {

constexpr std::size_t longestObjLine = 50000;

/// The parts of a corner "v/t/n": which there are, as bits, and their numbers.
struct Corner {
    int kinds = 0;
    std::array<std::int64_t, 3> numbers{};
};

class ObjCheck {
public:
    ObjCheck(std::istream& file, const std::string& path) : lines_(file), path_(path) {}

    bool run()
    {
        while (lines_.next()) {
            if (lines_.isTooLong()) fail(fmt::format("lines of at most {} characters", longestObjLine));
            if (lines_.line().find('\0') != std::string::npos) fail("text");
            std::istringstream words(lines_.line());
            std::string word;
            words >> word;
            if (word == "v") takeNumbers(words, 3, 0);
            if (word == "vt") takeNumbers(words, 1, 1);
            if (word == "vn") takeNumbers(words, 3, 2);
            if (word == "f" || word == "l" || word == "p") takeCell(words, word);
        }
        static const char* const names[] = {"vertex", "texture coordinate", "normal"};
        for (std::size_t k = 0; k < 3; ++k)
            if (highest_[k] > counts_[k])
                throw InputError(path_, fmt::format("line {} refers to {} {}", highestLine_[k], names[k], highest_[k]),
                                 fmt::format("1 to {}", counts_[k]));
        // Where no face says so, VTK takes the first of them for the first vertex, and so on.
        const auto fits = [&](std::size_t k) { return counts_[k] == 0 || counts_[k] == counts_[0]; };
        return isIndexed_ ? counts_[2] == 0 || !anyWithoutNormals_ : fits(1) && fits(2);
    }

private:
    [[noreturn]] void fail(const std::string& expected) const
    {
        std::string shown;
        for (const char c : lines_.line().substr(0, 60)) shown += c >= ' ' && c <= '~' ? c : '?';
        throw InputError(path_, fmt::format("line {} is '{}'", lines_.number(), shown), expected);
    }

    void takeNumbers(std::istringstream& words, int least, std::size_t kind)
    {
        std::string word;
        for (int i = 0; i < least; ++i) {
            double value = 0;
            if (!(words >> word)) fail(fmt::format("{} numbers", least));
            const char* begin = word.data() + (word[0] == '+' ? 1 : 0);
            const auto [stop, error] = std::from_chars(begin, word.data() + word.size(), value);
            const bool fits = std::abs(value) <= double(std::numeric_limits<float>::max());
            const bool tiny = error == std::errc::result_out_of_range && word.find("e-") != std::string::npos;
            if ((error != std::errc{} && !tiny) || !fits || stop != word.data() + word.size())
                fail(fmt::format("{} finite numbers", least));
        }
        ++counts_[kind];
    }

    Corner cornerOf(const std::string& word) const
    {
        Corner corner;
        const char *at = word.data(), *const end = at + word.size();
        for (std::size_t k = 0; k < 3; ++k) {
            if (at != end && *at != '/') {
                const auto [stop, error] = std::from_chars(at, end, corner.numbers[k]);
                if (error != std::errc{} || corner.numbers[k] == 0) fail("corners like 1, 1/2, 1//3 or 1/2/3");
                corner.kinds |= 1 << k;
                at = stop;
            }
            if (at == end) break;
            if (*at++ != '/' || k == 2) fail("corners like 1, 1/2, 1//3 or 1/2/3");
        }
        if (!(corner.kinds & 1) || word.back() == '/') fail("corners like 1, 1/2, 1//3 or 1/2/3");
        return corner;
    }

    void takeCell(std::istringstream& words, const std::string& cell)
    {
        int corners = 0, kinds = 0;
        for (std::string word; words >> word; ++corners) {
            const Corner corner = cornerOf(word);
            if (corners > 0 && corner.kinds != kinds) fail("corners of the same kind");
            kinds = corner.kinds;
            for (std::size_t k = 0; k < 3; ++k) refer(corner.numbers[k], k);
        }
        if (cell == "f") {
            isIndexed_ = isIndexed_ || kinds > 1;
            anyWithoutNormals_ = anyWithoutNormals_ || !(kinds & 1 << 2);
        }
        const int least = cell == "f" ? 3 : cell == "l" ? 2 : 1;
        if (corners < least) fail(fmt::format("at least {} corners", least));
    }

    /// Numbers below zero count back from the line. Others may refer to what comes later.
    void refer(std::int64_t number, std::size_t kind)
    {
        if (number < -counts_[kind]) fail(fmt::format("a number from {}", -counts_[kind]));
        if (number <= highest_[kind]) return;
        highest_[kind] = number;
        highestLine_[kind] = lines_.number();
    }

    ObjLines lines_;
    std::string path_;
    bool isIndexed_ = false, anyWithoutNormals_ = false;  // Some face refers to more than vertices; has no normals.
    std::array<std::int64_t, 3> counts_{}, highest_{}, highestLine_{};
};

}  // namespace

bool ObjLines::next()
{
    line_.clear();
    bool any = false;
    for (std::string part; std::getline(file_, part);) {
        ++number_;
        any = true;
        while (!part.empty() && (part.back() == '\r' || part.back() == ' ')) part.pop_back();
        const bool joined = !part.empty() && part.back() == '\\';
        if (joined) part.back() = ' ';
        line_ += part;
        if (!joined || isTooLong()) break;
    }
    return any;
}

bool ObjLines::isTooLong() const
{
    return line_.size() > longestObjLine;
}

bool checkObj(std::istream& file, const std::string& path)
{
    return ObjCheck(file, path).run();
}

}  // namespace aeolic
