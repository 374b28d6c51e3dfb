#include "reader/vtk/xml/xml_tree.h"

#include <fmt/format.h>
#include <vtkNew.h>
#include <vtkXMLDataParser.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "aeolic/error.h"
#include "base/text.h"
#include "data/vtk/messages.h"

namespace aeolic {

namespace fs = std::filesystem;

vtkSmartPointer<vtkXMLDataElement> parseXml(std::istream& text, const std::string& path, const std::string& expected)
{
    vtkNew<vtkXMLDataParser> parser;
    parser->SetStream(&text);
    const VtkMessages messages;
    const bool parsed = parser->Parse() != 0;
    if (!parsed || messages.failed() || !parser->GetRootElement())
        throw InputError(
            path,
            fmt::format("it is not well-formed XML ({})", messages.failed() ? messages.firstError() : "it ends early"),
            expected);
    return parser->GetRootElement();
}

vtkSmartPointer<vtkXMLDataElement> parseXml(const std::string& path, const std::string& expected)
{
    std::ifstream file(path, std::ios::binary);
    return parseXml(file, path, expected);
}

std::vector<vtkXMLDataElement*> childrenOf(vtkXMLDataElement& element, const std::string& name)
{
    std::vector<vtkXMLDataElement*> found;
    for (int i = 0; i < element.GetNumberOfNestedElements(); ++i)
        if (vtkXMLDataElement* child = element.GetNestedElement(i); child->GetName() && name == child->GetName())
            found.push_back(child);
    return found;
}

std::string attributeOf(vtkXMLDataElement& element, const char* name)
{
    const char* value = element.GetAttribute(name);
    return withoutControls(value ? value : "", '?');
}

std::vector<double> numbersIn(const std::string& text)
{
    std::istringstream stream(text);
    std::vector<double> numbers;
    for (double value; stream >> value;) numbers.push_back(value);
    if (!stream.eof()) numbers.clear();
    return numbers;
}

std::vector<std::string> pieceFilesOf(const std::string& path)
{
    const auto root = parseXml(path, "a VTK XML file");
    std::vector<std::string> pieces;
    for (int i = 0; i < root->GetNumberOfNestedElements(); ++i)
        for (vtkXMLDataElement* piece : childrenOf(*root->GetNestedElement(i), "Piece")) {
            pieces.push_back((fs::path(path).parent_path() / attributeOf(*piece, "Source")).string());
            std::error_code error;
            if (!fs::is_regular_file(pieces.back(), error))
                throw InputError(path, "its piece " + pieces.back() + " is not there", "a file for each piece");
        }
    return pieces;
}

}  // namespace aeolic
