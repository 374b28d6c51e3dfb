#pragma once

#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace aeolic {

/// A file of VTK's XML family with its elements, and what the headers of its arrays say. Every function throws
/// InputError, whose line begins with the file's name.
class XmlValues {
public:
    explicit XmlValues(const std::string& path);

    const std::string& path() const { return path_; }
    vtkXMLDataElement& root() const { return *parser_->GetRootElement(); }

    /// Throws unless the array holds `tuples` of its components: its own header, the blocks' sizes where it is
    /// compressed, and the bytes in the file agree. Reads no values.
    void requireTuples(vtkXMLDataElement& array, std::uint64_t tuples);

    /// Words of the array's type that are there.
    std::uint64_t wordsIn(vtkXMLDataElement& array);

    /// So many words as numbers, which must be there.
    std::vector<std::int64_t> integers(vtkXMLDataElement& array, std::uint64_t first, std::uint64_t count);

    /// Bytes of all arrays that were required, as they are in memory.
    std::uint64_t bytesInMemory() const { return bytesInMemory_; }

    [[noreturn]] void fail(vtkXMLDataElement& array, const std::string& found, const std::string& expected) const;

private:
    struct Place {
        std::uint64_t at = 0, end = 0;  // In the file.
        bool base64 = false;
    };
    Place placeOf(vtkXMLDataElement& array);
    std::vector<std::uint64_t> headerAt(const Place& place, std::uint64_t words, vtkXMLDataElement& array);
    std::uint64_t bytesIn(vtkXMLDataElement& array, const Place& place);
    std::uint64_t bytesInBlocks(vtkXMLDataElement& array, const Place& place);
    /// `odd`: becomes the word behind them that is not such a number.
    std::uint64_t wordsInText(const Place& place, int type, std::string* odd = nullptr);
    std::uint64_t inlineStart(vtkXMLDataElement& array);
    std::uint64_t inlineEnd(std::uint64_t start);
    std::size_t read(vtkXMLDataElement& array, void* values, std::uint64_t first, std::uint64_t count, int type);
    void requireStrings(vtkXMLDataElement& array, std::uint64_t bytes, std::uint64_t most);
    void findAppended();
    void setCompressor();

    std::string path_;
    std::ifstream file_;
    std::uint64_t fileBytes_ = 0, appendedAt_ = 0, bytesInMemory_ = 0;
    bool appendedBase64_ = true, bigEndian_ = false;
    unsigned headerWordBytes_ = 4;
    vtkNew<vtkXMLDataParser> parser_;
};

/// The children of that name.
std::vector<vtkXMLDataElement*> childrenOf(vtkXMLDataElement& element, const std::string& name);

/// "PointData array 'U'", or what else an element is called.
std::string labelOf(vtkXMLDataElement& array);

/// VTK's number of the type, or -1 where VTK has no such type. A string is VTK_STRING.
int typeOf(vtkXMLDataElement& array);

/// Values of a tuple: 1 to 1000. Throws InputError.
std::uint64_t componentsOf(vtkXMLDataElement& array, const std::string& path);

/// A count in an attribute, 0 where it is missing. Throws InputError where it is negative or no number.
std::uint64_t countIn(vtkXMLDataElement& element, const char* attribute, const std::string& path);

}  // namespace aeolic
