#include "data/vtk/checks/obj_check.h"

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
    ObjCheck(std::istream& file, const std::string& path) : file_(file), path_(path) {}

    void run()
    {
        while (nextLine()) {
            std::istringstream words(line_);
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
        // VTK would leave it out.
        if (counts_[2] > 0 && isIndexed_ && lineWithoutNormals_ > 0)
            throw InputError(path_, fmt::format("line {} is a face without normals", lineWithoutNormals_),
                             "corners like 1//3 in all faces, as the file has normals");
    }

private:
    [[noreturn]] void fail(const std::string& expected) const
    {
        std::string shown;
        for (const char c : line_.substr(0, 60)) shown += c >= ' ' && c <= '~' ? c : '?';
        throw InputError(path_, fmt::format("line {} is '{}'", number_, shown), expected);
    }

    /// With those that a backslash at its end joins to it.
    bool nextLine()
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
            if (line_.size() > longestObjLine) fail(fmt::format("lines of at most {} characters", longestObjLine));
            if (line_.find('\0') != std::string::npos) fail("text");
            if (!joined) break;
        }
        return any;
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
            if (!(kinds & 1 << 2) && lineWithoutNormals_ == 0) lineWithoutNormals_ = number_;
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
        highestLine_[kind] = number_;
    }

    std::istream& file_;
    std::string path_, line_;
    std::int64_t number_ = 0, lineWithoutNormals_ = 0;
    bool isIndexed_ = false;  // Some face refers to more than vertices.
    std::array<std::int64_t, 3> counts_{}, highest_{}, highestLine_{};
};

}  // namespace

void checkObj(std::istream& file, const std::string& path)
{
    ObjCheck(file, path).run();
}

}  // namespace aeolic
