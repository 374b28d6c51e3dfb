#include "reader/vtk/color_map_xml.h"

#include <fmt/format.h>
#include <vtkXMLDataElement.h>

#include <sstream>

#include "aeolic/error.h"
#include "description/option_rules.h"
#include "reader/vtk/xml/xml_tree.h"

namespace aeolic {
namespace {

constexpr const char* expectedMap = "a colour map as ParaView exports it: <ColorMap><Point x= r= g= b=/>…</ColorMap>";

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

}  // namespace

ColorPoints colorPointsInXml(const std::string& text, const std::string& path)
{
    std::istringstream stream(text);
    const auto root = parseXml(stream, path, expectedMap);
    const std::string name = root->GetName();
    vtkXMLDataElement* element = name == "ColorMap" ? root.Get() : nullptr;
    if (name == "ColorMaps" || name == "doc") element = root->FindNestedElementWithName("ColorMap");
    if (!element) throw InputError(path, "it holds no ColorMap", expectedMap);
    const std::string indexed = attributeOf(*element, "indexedLookup");
    if (indexed == "true" || indexed == "1")
        throw InputError(path + ": ColorMap", "found colours for categories (indexedLookup)", "colours at values");
    ColorPoints map;
    if (const char* const space = element->GetAttribute("space"))
        map.space = colorSpaceNamed(path + ": ColorMap: space", space);
    for (vtkXMLDataElement* point : childrenOf(*element, "Point")) {
        const std::string where = fmt::format("{}: Point {}", path, map.points.size() + 1);
        map.points.push_back({numberOf(point, "x", where), colorOf(point, where)});
    }
    for (vtkXMLDataElement* nan : childrenOf(*element, "NaN"))
        map.nan = colorOfParts(path + ": NaN", colorOf(nan, path + ": NaN"));
    return map;
}

}  // namespace aeolic
