#include "reader/vtk/checks/xml_cells.h"

#include <fmt/format.h>

#include "aeolic/error.h"
#include "data/vtk/checks/cell_checks.h"

namespace aeolic {
namespace {

/// Arrays of that name: one, or one for every step of time.
std::vector<vtkXMLDataElement*> arraysNamed(vtkXMLDataElement& element, const std::string& name)
{
    std::vector<vtkXMLDataElement*> found;
    for (vtkXMLDataElement* array : childrenOf(element, "DataArray"))
        if (const char* own = array->GetAttribute("Name"); own && name == own) found.push_back(array);
    return found;
}

void requireScalars(XmlValues& values, vtkXMLDataElement& array)
{
    if (componentsOf(array, values.path()) != 1) values.fail(array, "has several components", "one");
}

/// VTK puts every number into a byte. Those that are bytes in the file are judged when they were read.
void requireCellTypes(XmlValues& values, vtkXMLDataElement& array, std::uint64_t count)
{
    if (count == 0 || typeOf(array) == VTK_UNSIGNED_CHAR) return;
    const std::vector<std::int64_t> types = values.integers(array, 0, count);
    for (std::uint64_t cell = 0; cell < count; ++cell) cellTypeOf(types[cell], std::int64_t(cell), values.path());
}

}  // namespace

void checkXmlCells(XmlValues& values, vtkXMLDataElement& piece, const std::string& group, std::uint64_t count,
                   std::uint64_t points)
{
    bool any = false;
    for (vtkXMLDataElement* element : childrenOf(piece, group)) {
        const auto offsets = arraysNamed(*element, "offsets"), corners = arraysNamed(*element, "connectivity"),
                   types = arraysNamed(*element, "types");
        const bool typed = group == "Cells";
        if (count > 0 && (offsets.empty() || offsets.size() != corners.size() || (typed && types.empty())))
            throw InputError(values.path(), fmt::format("its {} lack offsets, connectivity or types", group),
                             fmt::format("those of {} cells", count));
        for (std::size_t i = 0; count > 0 && i < offsets.size(); ++i) {
            requireScalars(values, *offsets[i]);
            requireScalars(values, *corners[i]);
            values.requireTuples(*offsets[i], count);
            const std::int64_t last = values.integers(*offsets[i], count - 1, 1).front();
            if (last < 0 || (last > 0 && points == 0))
                values.fail(*offsets[i], fmt::format("ends with {}", last), "the number of corners of all cells");
            values.requireTuples(*corners[i], std::uint64_t(last));
        }
        for (vtkXMLDataElement* array : types) {
            requireScalars(values, *array);
            values.requireTuples(*array, count);
            requireCellTypes(values, *array, count);
        }
        any = true;
    }
    if (!any && count > 0)
        throw InputError(values.path(), fmt::format("it has no {}", group), fmt::format("{} cells", count));
}

void checkXmlPolyhedra(XmlValues& values, vtkXMLDataElement& piece, std::uint64_t cells, std::uint64_t points)
{
    for (vtkXMLDataElement* element : childrenOf(piece, "Cells")) {
        const auto faces = arraysNamed(*element, "faces"), offsets = arraysNamed(*element, "faceoffsets");
        if (faces.size() != offsets.size())
            throw InputError(values.path(), "its Cells have faces without faceoffsets", "both or none");
        for (std::size_t i = 0; cells > 0 && i < faces.size(); ++i) {
            requireScalars(values, *faces[i]);
            requireScalars(values, *offsets[i]);
            values.requireTuples(*offsets[i], cells);
            const auto ends = values.integers(*offsets[i], 0, cells);
            std::int64_t size = 0;
            for (const std::int64_t end : ends) {
                if (end < -1 || (end >= 0 && end < size))
                    values.fail(*offsets[i], fmt::format("has {} after {}", end, size), "-1, or no less than before");
                if (end >= 0) size = end;
            }
            values.requireTuples(*faces[i], std::uint64_t(size));
            const auto numbers =
                size > 0 ? values.integers(*faces[i], 0, std::uint64_t(size)) : std::vector<std::int64_t>{};
            std::int64_t begin = 0;
            for (const std::int64_t end : ends) {
                if (end < 0) continue;
                if (!facesAreSound({numbers.data() + begin, std::size_t(end - begin)}, points))
                    values.fail(*faces[i], fmt::format("has no valid polyhedron at value {}", begin),
                                "the number of faces, and for each face its corners' number and the corners");
                begin = end;
            }
        }
    }
}

}  // namespace aeolic
