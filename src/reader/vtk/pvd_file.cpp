#include "reader/lists/series_files.h"

#include <fmt/format.h>
#include <vtkXMLDataElement.h>

#include "aeolic/error.h"
#include "reader/vtk/xml/xml_tree.h"

namespace aeolic {

std::vector<SeriesEntry> readPvdFile(const std::string& path)
{
    constexpr const char* expected = "a ParaView collection: <VTKFile type=\"Collection\"><Collection><DataSet …/>";
    const auto root = parseXml(path, expected);
    std::vector<vtkXMLDataElement*> collections;
    if (std::string(root->GetName()) == "VTKFile") collections = childrenOf(*root, "Collection");
    if (collections.empty()) throw InputError(path, "it holds no Collection", expected);
    std::vector<SeriesEntry> entries;
    for (vtkXMLDataElement* element : childrenOf(*collections.front(), "DataSet")) {
        const std::string where = fmt::format("{}: DataSet {}", path, entries.size() + 1);
        const char *file = element->GetAttribute("file"), *time = element->GetAttribute("timestep");
        if (!file || !*file) throw InputError(where, "it has no file", "file=\"NAME\"");
        double value = 0;  // As ParaView takes it where a file says none.
        if (time) {
            const std::vector<double> numbers = numbersIn(time);
            if (numbers.size() != 1) throw InputError(where, fmt::format("its timestep is '{}'", time), "a number");
            value = numbers.front();
        }
        int part = 0;
        if (element->GetAttribute("part") && !element->GetScalarAttribute("part", part))
            throw InputError(where, fmt::format("its part is '{}'", element->GetAttribute("part")), "a whole number");
        entries.push_back({file, value, part});
    }
    return entries;
}

}  // namespace aeolic
