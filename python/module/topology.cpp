#include "topology.h"

#include <pybind11/stl.h>

#include "errors.h"
#include "output/flow_files.h"
#include "place_arrays.h"

namespace aeolic::python {
namespace {

namespace py = pybind11;

py::tuple linesOf(const FlowTopology& topology)
{
    py::list lines;
    for (const FlowLine& line : topology.lines)
        lines.append(py::make_tuple(
            line.separates ? "separation" : "attachment", line.saddle, line.end, line.length, line.strength,
            vectorsOf(line.places, [](const SurfaceValues& at) { return at.position; }),
            vectorsOf(line.places, [](const SurfaceValues& at) { return at.vector; }),
            scalarsOf(topology.scalar, numbersOf(line.places, [](const SurfaceValues& at) { return at.scalar; }))));
    return py::tuple(lines);
}

py::dict pointsOf(const FlowTopology& topology)
{
    const std::vector<FlowPoint>& points = topology.points;
    py::dict told;
    py::list kinds;
    for (const FlowPoint& point : points) kinds.append(nameOf(point.kind));
    told["positions"] = vectorsOf(points, [](const FlowPoint& p) { return p.at.position; });
    told["kinds"] = py::tuple(kinds);
    told["attracts"] = numbersOf(points, [](const FlowPoint& p) { return std::int64_t(attraction(p)); });
    told["indices"] = numbersOf(points, [](const FlowPoint& p) { return std::int64_t(p.index); });
    told["strengths"] = numbersOf(points, [](const FlowPoint& p) { return p.strength; });
    told["vectors"] = vectorsOf(points, [](const FlowPoint& p) { return p.at.vector; });
    told["scalars"] = scalarsOf(topology.scalar, numbersOf(points, [](const FlowPoint& p) { return p.at.scalar; }));
    told["scalar_name"] = topology.scalar.empty() ? py::object(py::none()) : py::object(textOf(topology.scalar));
    return told;
}

void save(const FlowTopology& topology, const std::string& path, bool asCsv)
{
    saveText(path, [&] { return asCsv ? topologyCsv(topology) : topologyVtp(topology); });
}

}  // namespace

void addTopology(py::module_& module)
{
    py::class_<FlowTopology>(module, "FlowTopology").def("points", pointsOf).def("lines", linesOf).def("save", save);
}

}  // namespace aeolic::python
