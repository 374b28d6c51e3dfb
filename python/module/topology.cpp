#include "topology.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "aeolic/error.h"
#include "errors.h"
#include "gil.h"
#include "output/output_check.h"
#include "output/topology_files.h"

namespace aeolic::python {
namespace {

namespace py = pybind11;

template <class Item, class ValueOf>
py::array numbersOf(const std::vector<Item>& items, const ValueOf& valueOf)
{
    using Number = decltype(valueOf(items.front()));
    py::array_t<Number> array{py::ssize_t(items.size())};
    for (std::size_t i = 0; i < items.size(); ++i) array.mutable_data()[i] = valueOf(items[i]);
    return array;
}

template <class Item, class PlaceOf>
py::array vectorsOf(const std::vector<Item>& items, const PlaceOf& placeOf)
{
    py::array_t<double> array({py::ssize_t(items.size()), py::ssize_t(3)});
    double* out = array.mutable_data();
    for (const Item& item : items)
        for (const double number : placeOf(item)) *out++ = number;
    return array;
}

py::object scalarsOf(const FlowTopology& topology, py::array scalars)
{
    return topology.scalar.empty() ? py::object(py::none()) : py::object(std::move(scalars));
}

py::tuple linesOf(const FlowTopology& topology)
{
    py::list lines;
    for (const FlowLine& line : topology.lines)
        lines.append(py::make_tuple(
            line.separates ? "separation" : "attachment", line.saddle, line.end, line.length,
            vectorsOf(line.places, [](const SurfaceValues& at) { return at.position; }),
            vectorsOf(line.places, [](const SurfaceValues& at) { return at.vector; }),
            scalarsOf(topology, numbersOf(line.places, [](const SurfaceValues& at) { return at.scalar; }))));
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
    told["scalars"] = scalarsOf(topology, numbersOf(points, [](const FlowPoint& p) { return p.at.scalar; }));
    told["scalar_name"] = topology.scalar.empty() ? py::object(py::none()) : py::object(textOf(topology.scalar));
    return told;
}

void save(const FlowTopology& topology, const std::string& path, bool asCsv)
{
    try {
        const WithoutGil free;
        writeTextFile(path, asCsv ? topologyCsv(topology) : topologyVtp(topology));
    } catch (const InputError&) {
        throw;
    } catch (const std::runtime_error& error) {
        PyErr_SetString(PyExc_OSError, error.what());
        throw py::error_already_set();
    }
}

}  // namespace

void addTopology(py::module_& module)
{
    py::class_<FlowTopology>(module, "FlowTopology").def("points", pointsOf).def("lines", linesOf).def("save", save);
}

}  // namespace aeolic::python
