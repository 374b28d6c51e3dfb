#include "reader/vtk/xml/xml_header.h"

#include <fmt/format.h>
#include <vtkExtentSplitter.h>
#include <vtkNew.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "reader/vtk/xml/xml_tree.h"

namespace aeolic {
namespace {

/// Arrays as VTK tells them apart, in their order: those that the group of a piece has at a step of time.
std::vector<std::string> arraysAt(vtkXMLDataElement& piece, const char* group, int step, int steps)
{
    std::vector<std::string> arrays;
    for (vtkXMLDataElement* data : childrenOf(piece, group))
        for (int i = 0; i < data->GetNumberOfNestedElements(); ++i) {
            vtkXMLDataElement& array = *data->GetNestedElement(i);
            std::vector<int> own(std::size_t(steps) + 1);
            own.resize(std::size_t(array.GetVectorAttribute("TimeStep", steps, own.data())));
            if (!own.empty() && std::ranges::find(own, step) == own.end()) continue;
            int components = 1;
            array.GetScalarAttribute("NumberOfComponents", components);
            arrays.push_back(
                fmt::format("'{}' ({} x {})", attributeOf(array, "Name"), attributeOf(array, "type"), components));
        }
    return arrays;
}

/// How many points or cells a piece of a surface or of cells has; 1 for a piece of a grid.
vtkTypeInt64 tuplesOf(vtkXMLDataElement& piece, bool onCells)
{
    if (piece.GetAttribute("Extent")) return 1;
    vtkTypeInt64 sum = 0;
    const auto add = [&](const char* attribute) {
        vtkTypeInt64 count = 0;
        if (piece.GetScalarAttribute(attribute, count)) sum += count;
    };
    if (!onCells) add("NumberOfPoints");
    for (const char* cells : {"NumberOfCells", "NumberOfVerts", "NumberOfLines", "NumberOfStrips", "NumberOfPolys"})
        if (onCells) add(cells);
    return sum;
}

/// `found`: the arrays of a piece at a step of time, which must be those that VTK goes by.
std::string faultOf(const std::vector<std::string>& found, const std::vector<std::string>& expected, const char* group)
{
    for (const std::string& array : expected)
        if (std::ranges::find(found, array) == found.end())
            return fmt::format("a piece or a step of time lacks the {} array {}", group, array);
    const bool isNamed = std::string_view(group) != "Points";
    for (const std::string& array : found)
        if (isNamed && array.starts_with("''")) return fmt::format("one of the {} arrays has no Name", group);
    if (std::set(found.begin(), found.end()).size() < found.size())
        return fmt::format("one of the {} arrays is there twice", group);
    return found == expected ? "" : fmt::format("the {} of its pieces or steps of time differ", group);
}

std::string faultOfArrays(vtkXMLDataElement& primary)
{
    const auto pieces = childrenOf(primary, "Piece");
    if (pieces.empty()) return "it has no Piece";
    const int steps = int(numbersIn(attributeOf(primary, "TimeValues")).size());
    for (vtkXMLDataElement* piece : pieces)
        for (int step = 0; step < std::max(steps, 1); ++step) {
            for (const char* group : {"PointData", "CellData", "Points"}) {
                const auto found = arraysAt(*piece, group, step, steps);
                if (tuplesOf(*piece, group[0] == 'C') == 0) continue;
                std::string fault = faultOf(found, arraysAt(*pieces.front(), group, 0, steps), group);
                if (!fault.empty()) return fault;
            }
            for (const char* group : {"Cells", "Verts", "Lines", "Strips", "Polys"})
                if (arraysAt(*piece, group, step, steps) != arraysAt(*piece, group, 0, steps))
                    return fmt::format("the {} lack a step of time", group);
        }
    return "";
}

std::string faultOfExtents(vtkXMLDataElement& primary)
{
    std::array<int, 6> whole{}, extent{};
    if (primary.GetVectorAttribute("WholeExtent", 6, whole.data()) < 6) return "";  // VTK says it, where it needs one.
    vtkNew<vtkExtentSplitter> pieces;
    int number = 0;
    for (vtkXMLDataElement* piece : childrenOf(primary, "Piece"))
        if (piece->GetVectorAttribute("Extent", 6, extent.data()) == 6)
            pieces->AddExtentSource(number++, 0, extent.data());
    pieces->AddExtent(whole.data());
    const bool isEmpty = whole[1] < whole[0] || whole[3] < whole[2] || whole[5] < whole[4];
    if (number == 0 || isEmpty || pieces->ComputeSubExtents()) return "";
    return fmt::format("its pieces do not cover its WholeExtent '{}'", attributeOf(primary, "WholeExtent"));
}

}  // namespace

std::string faultOfPlace(vtkXMLDataElement& primary)
{
    const std::pair<const char*, std::size_t> attributes[] = {{"Origin", 3}, {"Spacing", 3}, {"Direction", 9}};
    for (const auto& [name, count] : attributes)
        if (primary.GetAttribute(name) && numbersIn(attributeOf(primary, name)).size() != count)
            return fmt::format("its {} is '{:.80}', and not {} finite numbers", name, attributeOf(primary, name),
                               count);
    return "";
}

std::string faultOf(vtkXMLDataElement& primary)
{
    std::string fault = faultOfPlace(primary);
    if (fault.empty()) fault = faultOfArrays(primary);
    return fault.empty() ? faultOfExtents(primary) : fault;
}

std::int64_t lastByte(vtkXMLDataElement& element, vtkDataArray& array, std::int64_t values)
{
    vtkXMLDataElement *group = element.GetParent(), *piece = group ? group->GetParent() : nullptr;
    std::array<int, 6> extent{};
    const std::string name = group ? group->GetName() : "";
    if (piece && name != "Coordinates" && piece->GetVectorAttribute("Extent", 6, extent.data()) == 6) {
        values = array.GetNumberOfComponents();
        for (std::size_t c = 0; c < 6; c += 2) {
            const int cells = extent[c + 1] - extent[c];
            values *= name == "CellData" ? std::max(cells, 1) : cells + 1;
        }
    }
    return array.GetDataType() == VTK_BIT ? -1 : values * array.GetDataTypeSize() - 1;
}

std::int64_t bytesWithin(vtkXMLDataElement& element, std::istream& file)
{
    std::string text;
    file.clear();
    file.seekg(std::streamoff(element.GetXMLByteIndex()));
    std::getline(file, text, '>');
    std::getline(file, text, '<');
    const auto digits = std::ranges::count_if(text, [](char c) {
        return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '+' || c == '/';
    });
    const char* const words = element.GetRoot()->GetAttribute("header_type");
    return digits * 6 / 8 - (words && std::string_view(words) == "UInt64" ? 8 : 4);
}

bool areCellTypes(vtkXMLDataElement& element, vtkDataArray& values)
{
    vtkXMLDataElement* parent = element.GetParent();
    if (attributeOf(element, "Name") != "types" || !parent || std::string(parent->GetName()) != "Cells") return true;
    double range[2] = {0, 0};
    if (values.GetDataType() != VTK_UNSIGNED_CHAR) values.GetRange(range, 0);
    return range[0] >= 0 && range[1] <= 255;
}

}  // namespace aeolic
