#include "reader/vtk/color_map_xml.h"

#include <fmt/format.h>
#include <vtkXMLDataElement.h>

#include <cstring>
#include <sstream>

#include "aeolic/error.h"
#include "description/option_rules.h"
#include "reader/vtk/xml/xml_tree.h"

namespace aeolic {
namespace {

constexpr const char* expectedMap = "a colour map as ParaView exports it: <ColorMap><Point x= r= g= b=/>…</ColorMap>";

bool isNamed(vtkXMLDataElement* element, const char* name)
{
    return element && element->GetName() && std::strcmp(element->GetName(), name) == 0;
}

double numberOf(vtkXMLDataElement* element, const char* attribute, const std::string& where)
{
    const char* const text = element->GetAttribute(attribute);
    if (!text) throw InputError(where, fmt::format("it has no {}", attribute), fmt::format("{}=\"NUMBER\"", attribute));
    const auto number = parseNumber(text);
    if (!number) throw InputError(where, fmt::format("its {} is {}", attribute, inQuotes(text)), "a number");
    return *number;
}

std::array<double, 3> colorOf(vtkXMLDataElement* element, const std::string& where)
{
    return {numberOf(element, "r", where), numberOf(element, "g", where), numberOf(element, "b", where)};
}

vtkXMLDataElement* mapIn(vtkXMLDataElement* root)
{
    if (isNamed(root, "ColorMap")) return root;
    if (isNamed(root, "ColorMaps") || isNamed(root, "doc")) return root->FindNestedElementWithName("ColorMap");
    return nullptr;
}

}  // namespace

ColorPoints colorPointsInXml(const std::string& text, const std::string& path)
{
    std::istringstream stream(text);
    const auto root = parseXml(stream, path, expectedMap);
    vtkXMLDataElement* const element = mapIn(root);
    if (!element) throw InputError(path, "it holds no ColorMap", expectedMap);
    const char* const indexed = element->GetAttribute("indexedLookup");
    if (indexed && (std::strcmp(indexed, "true") == 0 || std::strcmp(indexed, "1") == 0))
        throw InputError(path + ": ColorMap", "found colours for categories (indexedLookup)", "colours at values");
    ColorPoints map;
    if (const char* const space = element->GetAttribute("space"))
        map.space = colorSpaceNamed(path + ": ColorMap: space", space);
    for (int i = 0; i < element->GetNumberOfNestedElements(); ++i) {
        vtkXMLDataElement* const child = element->GetNestedElement(i);
        if (isNamed(child, "Point")) {
            const std::string where = fmt::format("{}: Point {}", path, map.points.size() + 1);
            map.points.push_back({numberOf(child, "x", where), colorOf(child, where)});
        } else if (isNamed(child, "NaN")) {
            map.nan = colorOfParts(path + ": NaN", colorOf(child, path + ": NaN"));
        }
    }
    return map;
}

}  // namespace aeolic
