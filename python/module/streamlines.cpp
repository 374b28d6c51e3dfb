#include "streamlines.h"

#include "errors.h"
#include "output/flow_files.h"
#include "place_arrays.h"

namespace aeolic::python {
namespace {

namespace py = pybind11;

py::tuple streamlinesOf(const EvenSurfaceLines& all)
{
    py::list lines;
    for (const SurfaceStreamline& line : all.lines)
        lines.append(py::make_tuple(
            line.length, line.closed, vectorsOf(line.places, [](const SurfaceValues& at) { return at.position; }),
            vectorsOf(line.places, [](const SurfaceValues& at) { return at.vector; }),
            scalarsOf(all.scalar, numbersOf(line.places, [](const SurfaceValues& at) { return at.scalar; }))));
    return py::tuple(lines);
}

void saveStreamlines(const EvenSurfaceLines& lines, const std::string& path, bool asCsv)
{
    saveText(path, [&] { return asCsv ? streamlinesCsv(lines) : streamlinesVtp(lines); });
}

py::object streamlineScalarName(const EvenSurfaceLines& lines)
{
    return lines.scalar.empty() ? py::object(py::none()) : py::object(textOf(lines.scalar));
}

}  // namespace

void addStreamlines(py::module_& module)
{
    py::class_<EvenSurfaceLines>(module, "EvenSurfaceLines")
        .def("lines", streamlinesOf)
        .def("save", saveStreamlines)
        .def_property_readonly("spacing", [](const EvenSurfaceLines& lines) { return lines.spacing; })
        .def_property_readonly("scalar_name", streamlineScalarName);
}

}  // namespace aeolic::python
