#include "reader/vtk/pvd_file.h"

#include <fmt/format.h>
#include <vtkNew.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>

#include <charconv>
#include <cstring>
#include <filesystem>

#include "aeolic/error.h"
#include "data/vtk/messages.h"

namespace aeolic {

std::vector<SeriesEntry> readPvdFile(const std::string& path)
{
    constexpr const char* expected = "a ParaView collection: <VTKFile type=\"Collection\"><Collection><DataSet …/>";
    constexpr std::uintmax_t largestFileBytes = std::uintmax_t{64} << 20;  // Hundreds of thousands of steps.
    std::error_code error;
    if (std::filesystem::file_size(path, error) > largestFileBytes)
        throw InputError(path, "found more than 64 MiB", expected);
    vtkNew<vtkXMLDataParser> parser;
    parser->SetFileName(path.c_str());
    const VtkMessages messages;
    const bool parsed = parser->Parse() != 0;
    if (!parsed || messages.failed())
        throw InputError(
            path,
            fmt::format("it is not well-formed XML ({})", messages.failed() ? messages.firstError() : "it ends early"),
            expected);
    vtkXMLDataElement* root = parser->GetRootElement();
    vtkXMLDataElement* collection = nullptr;
    if (root && root->GetName() && std::strcmp(root->GetName(), "VTKFile") == 0)
        collection = root->FindNestedElementWithName("Collection");
    if (!collection) throw InputError(path, "it holds no Collection", expected);
    std::vector<SeriesEntry> entries;
    for (int i = 0; i < collection->GetNumberOfNestedElements(); ++i) {
        vtkXMLDataElement* element = collection->GetNestedElement(i);
        if (!element->GetName() || std::strcmp(element->GetName(), "DataSet") != 0) continue;
        const std::string where = fmt::format("{}: DataSet {}", path, entries.size() + 1);
        const char *file = element->GetAttribute("file"), *time = element->GetAttribute("timestep");
        if (!file || !*file) throw InputError(where, "it has no file", "file=\"NAME\"");
        double value = 0;  // As ParaView takes it where a file says none.
        if (time) {
            const char* const end = time + std::strlen(time);
            const auto [stop, fault] = std::from_chars(time, end, value);
            if (fault != std::errc{} || stop != end)
                throw InputError(where, fmt::format("its timestep is '{}'", time), "a number");
        }
        int part = 0;
        if (element->GetAttribute("part") && !element->GetScalarAttribute("part", part))
            throw InputError(where, fmt::format("its part is '{}'", element->GetAttribute("part")), "a whole number");
        entries.push_back({file, value, part});
    }
    return entries;
}

}  // namespace aeolic
