#include "reader/vtk/format_readers.h"

#include <vtkCharArray.h>
#include <vtkNrrdReader.h>
#include <vtkObjectFactory.h>

#include <cmath>
#include <cstring>
#include <iterator>
#include <sstream>
#include <string>
#include <string_view>

namespace aeolic {
namespace {

class NrrdReader : public vtkNrrdReader {
public:
    static NrrdReader* New() { VTK_STANDARD_NEW_BODY(NrrdReader); }

protected:
    using vtkNrrdReader::ReadHeader;

    int ReadHeader(vtkCharArray* header) override
    {
        const bool isTurned = turnsAxes(*header), isLeftHanded = hideSpace(*header);
        if (namesByPattern(*header)) {
            vtkErrorMacro(<< "its data files are named by a pattern");
            return 0;
        }
        const vtkIdType end = header->GetNumberOfTuples() - 1;
        if (std::memchr(header->GetPointer(0), 0, std::size_t(end))) {  // VTK would look for the next line for ever.
            vtkErrorMacro(<< "its header is not all text");
            return 0;
        }
        header->SetValue(end, '\n');
        header->InsertNextValue('\n');
        header->InsertNextValue('\0');
        DataScalarType = VTK_VOID;
        if (vtkNrrdReader::ReadHeader(header) == 0) return 0;
        if (HeaderSize > 0) HeaderSize -= 2;
        if (isLeftHanded) FileLowerLeft = 0;
        const char* fault = isTurned ? "its axes are turned or run backwards (space directions)" : nullptr;
        if (DataScalarType == VTK_VOID) fault = "its header has no type";
        if (Encoding != ENCODING_RAW) fault = "its encoding is not raw";
        for (int axis = 0; axis < 3; ++axis) {
            if (DataExtent[2 * axis + 1] < 0) fault = "its sizes are not numbers from 1";
            if (!std::isfinite(DataSpacing[axis]) || DataSpacing[axis] == 0) fault = "its spacings are not finite";
        }
        if (fault) vtkErrorMacro(<< fault);
        return fault ? 0 : 1;
    }

private:
    /// VTK gives the pattern to printf() as it is, and does not end where its step is 0.
    static bool namesByPattern(vtkCharArray& header)
    {
        std::istringstream lines(header.GetPointer(0));
        for (std::string line; std::getline(lines, line);) {
            std::istringstream words(line);
            const auto count = std::distance(std::istream_iterator<std::string>(words), {});
            if (line.starts_with("data file: ") || line.starts_with("datafile: "))
                return line.find(": LIST") == std::string::npos && count >= (line[4] == ' ' ? 6 : 5);
        }
        return false;
    }

    /// VTK takes the lengths of the axes alone, and draws them along x, y and z.
    static bool turnsAxes(vtkCharArray& header)
    {
        constexpr std::string_view key = "space directions:";
        std::istringstream lines(header.GetPointer(0));
        for (std::string line; std::getline(lines, line);) {
            if (!line.starts_with(key)) continue;
            for (char& c : line)
                if (c == '(' || c == ')' || c == ',') c = c == '(' ? '|' : ' ';
            std::istringstream vectors(line.substr(key.size()));
            std::string vector;
            std::getline(vectors, vector, '|');  // What stands before the first one, such as 'none'.
            for (int axis = 0; std::getline(vectors, vector, '|'); ++axis) {
                std::istringstream components(vector);
                double component = 0;
                for (int c = 0; components >> component; ++c)
                    if (c == axis ? component < 0 : component != 0) return true;
            }
        }
        return false;
    }

    /// Makes the lines comments that VTK takes for the number of axes. Whether y goes the other way, which is all else
    /// that VTK takes from them.
    static bool hideSpace(vtkCharArray& header)
    {
        bool isLeftHanded = false;
        std::istringstream lines(header.GetPointer(0));
        vtkIdType at = 0;
        for (std::string line; std::getline(lines, line); at += vtkIdType(line.size()) + 1) {
            const bool isSpace = line.starts_with("space: ");
            if (!isSpace && !line.starts_with("space dimension: ")) continue;
            if (line.find("time") == std::string::npos) header.SetValue(at, '#');
            if (isSpace)
                for (const char* name : {"left-anterior-superior", "LAS", "3D-left-handed"})
                    isLeftHanded = isLeftHanded || line.find(name, 7) != std::string::npos;
        }
        return isLeftHanded;
    }
};

}  // namespace

vtkSmartPointer<vtkAlgorithm> makeNrrdReader()
{
    return vtkSmartPointer<NrrdReader>::New();
}

}  // namespace aeolic
