#include "reader/vtk/checks/nrrd_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "aeolic/error.h"

namespace aeolic {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longestLine = 1 << 16;
constexpr std::uint64_t longestHeader = 1 << 20;  // VTK looks no further than 4 MiB.
constexpr std::uint64_t mostValues = std::uint64_t{1} << 60;

std::string shown(const std::string& line)
{
    std::string text;  // Readable characters, whatever the file holds.
    for (const char c : line.substr(0, 60)) text += c >= ' ' && c <= '~' ? c : '?';
    return text;
}

std::string trimmed(const std::string& text)
{
    const auto begin = text.find_first_not_of(" \t\r");
    return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

unsigned bytesOfType(const std::string& type)
{
    static const std::map<std::string, unsigned> types = [] {
        std::map<std::string, unsigned> all{{"float", 4}, {"double", 8}};
        for (const char* name : {"signed char", "int8", "int8_t", "uchar", "unsigned char", "uint8", "uint8_t"})
            all[name] = 1;
        for (const char* name : {"short", "short int", "signed short", "signed short int", "int16", "int16_t", "ushort",
                                 "unsigned short", "unsigned short int", "uint16", "uint16_t"})
            all[name] = 2;
        for (const char* name : {"int", "signed int", "int32", "int32_t", "uint", "unsigned int", "uint32", "uint32_t"})
            all[name] = 4;
        for (const char* name :
             {"longlong", "long long", "long long int", "signed long long", "signed long long int", "int64", "int64_t",
              "ulonglong", "unsigned long long", "unsigned long long int", "uint64", "uint64_t"})
            all[name] = 8;
        return all;
    }();
    const auto found = types.find(type);
    return found == types.end() ? 0 : found->second;
}

class HeaderReader {
public:
    HeaderReader(std::istream& file, const std::string& path) : file_(file), path_(path) {}

    NrrdHeader read()
    {
        if (!nextLine() || !line_.starts_with("NRRD000") || line_.size() < 8 || line_[7] < '1' || line_[7] > '5')
            throw InputError(path_, "it does not begin like an NRRD file", "NRRD0001 to NRRD0005");
        while (!listed_ && nextLine() && !line_.empty() && line_ != "\r") takeLine();
        finish();
        return header_;
    }

private:
    [[noreturn]] void fail(const std::string& expected) const
    {
        throw InputError(path_, "its header has the line '" + shown(line_) + "'", expected);
    }

    /// VTK waits for ever for a line end that does not come.
    bool nextLine()
    {
        line_.clear();
        for (char c = 0; file_.get(c);) {
            if (++header_.headerBytes > longestHeader || line_.size() > longestLine)
                throw InputError(path_, "its header does not end",
                                 fmt::format("a blank line within {} bytes", longestHeader));
            if (c == '\n') return true;
            if (c == '\0') fail("text without control characters");
            line_ += c;
        }
        atEnd_ = true;
        if (!line_.empty())
            throw InputError(path_, fmt::format("the file is cut off within its header, after '{}'", shown(line_)),
                             "a line end and a blank line after the header");
        return false;
    }

    void takeLine()
    {
        const auto colon = line_.find(": ");
        if (line_[0] == '#' || colon == std::string::npos) return;
        const std::string field = line_.substr(0, colon), text = trimmed(line_.substr(colon + 2));
        if (field == "dimension" || field == "space dimension")
            axes_ = wholeNumber(text, 16);
        else if (field == "space")
            takeSpace(text);
        else if (field == "sizes")
            takeSizes(text);
        else if (field == "spacings")
            requireWords(text);
        else if (field == "type")
            takeType(text);
        else if (field == "encoding")
            raw_ = text == "raw" ? true : (fail("encoding: raw"), false);
        else if (field == "data file" || field == "datafile")
            takeFiles(text);
        else if (field == "space directions")
            takeDirections(text);
        else if (field.starts_with("byte skip") || field.starts_with("byteskip") || field.starts_with("line skip") ||
                 field.starts_with("lineskip"))
            if (text != "0") fail("no bytes or lines to skip");
    }

    std::uint64_t wholeNumber(const std::string& text, std::uint64_t most) const
    {
        std::uint64_t number = 0;
        const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (error != std::errc{} || stop != text.data() + text.size() || number < 1 || number > most)
            fail(fmt::format("a number from 1 to {}", most));
        return number;
    }

    /// A vector may have as many numbers as there are axes: VTK would take zeros for the others.
    std::vector<std::string> requireWords(const std::string& text) const
    {
        std::istringstream stream(text);
        std::vector<std::string> words;
        for (std::string word; stream >> word;) words.push_back(word);
        if (axes_ == 0 || words.size() != axes_)
            fail(fmt::format("{} numbers, and 'dimension' before them", axes_ == 0 ? "some" : std::to_string(axes_)));
        return words;
    }

    /// VTK takes it for the number of axes, whatever the dimension was, and applies that to what follows.
    void takeSpace(const std::string& text)
    {
        if (text.find("time") != std::string::npos) fail("a space without time");
        axes_ = 3;
    }

    void takeSizes(const std::string& text)
    {
        header_.sizes.clear();
        double product = 1;
        for (const std::string& word : requireWords(text)) {
            header_.sizes.push_back(wholeNumber(word, std::uint64_t{1} << 30));
            product *= double(header_.sizes.back());
        }
        if (header_.sizes.size() > 4) fail("three axes of space and one for components");
        if (product > double(mostValues)) fail("fewer values");
    }

    void takeType(const std::string& text)
    {
        header_.valueBytes = bytesOfType(text);
        if (header_.valueBytes == 0) fail("a type of numbers: float, double, short …");
    }

    void takeDirections(const std::string& text)
    {
        if (text.find("none") != std::string::npos)
            throw InputError(path_, "its 'space directions' have a 'none' for the components",
                             "'spacings' instead, with nan for the components");
        std::istringstream stream(text);
        for (std::string word; stream >> word;)
            if (word.size() < 3 || word.front() != '(' || word.back() != ')') fail("vectors like (1,0,0)");
    }

    void takeFiles(const std::string& text)
    {
        std::istringstream words(text);
        std::string first;
        words >> first;
        if (first.empty()) fail("the name of a file");
        if (first == "LIST") {
            while (nextLine() && !line_.empty() && line_ != "\r") header_.dataFiles.push_back(line_);
            listed_ = true;  // Nothing follows it.
            return;
        }
        int count = 1;
        for (std::string word; words >> word;) ++count;
        if (count >= 4) fail("one file, or LIST");  // VTK gives the pattern to printf() as it is.
        header_.dataFiles.push_back(text);
    }

    void finish()
    {
        if (header_.valueBytes == 0 || header_.sizes.empty())
            throw InputError(path_, header_.sizes.empty() ? "its header has no 'sizes'" : "its header has no 'type'",
                             "type, dimension, sizes and encoding");
        if (!raw_) throw InputError(path_, "its header has no 'encoding'", "encoding: raw");
        if (atEnd_ && header_.dataFiles.empty())
            throw InputError(path_, "the file is cut off: its header has no end and names no data file",
                             "a blank line after the header");
        const bool vectors = header_.sizes.size() > 3 || header_.sizes[0] <= 9;
        const std::size_t space = header_.sizes.size() - (vectors ? 1 : 0);
        if (space < 3) throw InputError(path_, "its header gives no size in x, y and z", "three axes of kind domain");
        if (header_.dataFiles.size() > 1 && header_.dataFiles.size() != header_.sizes.back())
            throw InputError(path_, fmt::format("its header lists {} data files", header_.dataFiles.size()),
                             fmt::format("one, or one for each of the {} layers", header_.sizes.back()));
        if (listed_ && header_.dataFiles.empty())
            throw InputError(path_, "its LIST of data files is empty", "their names");
    }

    std::istream& file_;
    std::string path_, line_;
    NrrdHeader header_;
    std::uint64_t axes_ = 0;
    bool raw_ = false, atEnd_ = false, listed_ = false;
};

}  // namespace

std::uint64_t NrrdHeader::valueCount() const
{
    std::uint64_t count = 1;
    for (const std::uint64_t size : sizes) count *= size;
    return count;
}

NrrdHeader readNrrdHeader(std::istream& file, const std::string& path)
{
    return HeaderReader(file, path).read();
}

void checkNrrdFile(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    const NrrdHeader header = readNrrdHeader(file, path);
    const std::uint64_t all = header.valueCount() * header.valueBytes;
    const auto require = [&](const std::string& name, std::uint64_t skipped, std::uint64_t bytes) {
        std::error_code error;
        const std::uint64_t found = fs::is_regular_file(name, error) ? fs::file_size(name, error) : 0;
        if (error || (found == 0 && !fs::exists(name, error)))
            throw InputError(path, "its data file " + name + " is not there", "a file of raw values");
        if (found < skipped || found - skipped < bytes)
            throw InputError(path, fmt::format("{} holds {} bytes of values", name, found - std::min(found, skipped)),
                             fmt::format("the {} that its sizes and type need", bytes));
    };
    if (header.dataFiles.empty()) return require(path, header.headerBytes, all);
    for (const std::string& name : header.dataFiles)
        require((fs::path(path).parent_path() / name).string(), 0, all / header.dataFiles.size());
}

}  // namespace aeolic
