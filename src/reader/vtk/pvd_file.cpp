#include "reader/vtk/pvd_file.h"

#include <fmt/format.h>
#include <vtkXMLDataElement.h>

#include <cstring>

#include "aeolic/error.h"
#include "reader/vtk/xml/xml_tree.h"

namespace aeolic {

std::vector<SeriesEntry> readPvdFile(const std::string& path)
{
    constexpr const char* expected = "a ParaView collection: <VTKFile type=\"Collection\"><Collection><DataSet …/>";
    const auto root = parseXml(path, expected);
    vtkXMLDataElement* collection = nullptr;
    if (root->GetName() && std::strcmp(root->GetName(), "VTKFile") == 0)
        collection = root->FindNestedElementWithName("Collection");
    if (!collection) throw InputError(path, "it holds no Collection", expected);
    std::vector<SeriesEntry> entries;
    for (int i = 0; i < collection->GetNumberOfNestedElements(); ++i) {
        vtkXMLDataElement* element = collection->GetNestedElement(i);
        if (!element->GetName() || std::strcmp(element->GetName(), "DataSet") != 0) continue;
        const std::string where = fmt::format("{}: DataSet {}", path, entries.size() + 1);
        const char *file = element->GetAttribute("file"), *time = element->GetAttribute("timestep");
        if (!file || !*file) throw InputError(where, "it has no file", "file=\"NAME\"");
        if (!time) throw InputError(where, "it has no timestep", "timestep=\"NUMBER\"");
        const std::vector<double> numbers = numbersIn(time);
        if (numbers.size() != 1) throw InputError(where, fmt::format("its timestep is '{}'", time), "a number");
        int part = 0;
        if (element->GetAttribute("part") && !element->GetScalarAttribute("part", part))
            throw InputError(where, fmt::format("its part is '{}'", element->GetAttribute("part")), "a whole number");
        entries.push_back({file, numbers.front(), part});
    }
    return entries;
}

}  // namespace aeolic
