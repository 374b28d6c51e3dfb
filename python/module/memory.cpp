#include "memory.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <memory>
#include <stdexcept>
#include <string>

#include "gil.h"

namespace aeolic::python {

namespace py = pybind11;

namespace {

/// The interpreter may be at its end when the last view goes; its objects then go with the process.
void release(const void* object)
{
    if (!Py_IsInitialized()) return;
    const WithGil gil;
    delete static_cast<const py::object*>(object);
}

ValueType typeOf(const py::array& array)
{
    const char kind = array.dtype().kind();
    const auto bytes = array.itemsize();
    if (kind == 'f' && bytes == 4) return ValueType::float32;
    if (kind == 'f' && bytes == 8) return ValueType::float64;
    if (kind == 'i' && bytes == 4) return ValueType::int32;
    if (kind == 'i' && bytes == 8) return ValueType::int64;
    if (kind == 'u' && bytes == 4) return ValueType::uint32;
    if (kind == 'u' && bytes == 1) return ValueType::uint8;
    throw std::logic_error("an array of a type that _data.py does not let through");
}

ArrayView viewOf(const py::object& object)
{
    if (object.is_none()) return {};
    const auto array = py::reinterpret_borrow<py::array>(object);
    const bool tuples = array.ndim() == 2;
    const bool gaps = tuples && array.size() > 0 && array.shape(1) > 1 && array.strides(1) != array.itemsize();
    if ((array.ndim() != 1 && !tuples) || gaps)
        throw std::logic_error("an array of a shape that _data.py does not let through");
    ArrayView view;
    view.data = array.data();
    view.count = array.shape(0);
    view.components = tuples ? int(array.shape(1)) : 1;
    view.type = typeOf(array);
    const auto tight = array.itemsize() * view.components;
    view.strideBytes = view.count > 1 && array.strides(0) != tight ? array.strides(0) : 0;
    view.owner = std::shared_ptr<const void>(new py::object(array), release);
    return view;
}

/// `key`: "point_data" or "cell_data".
std::vector<NamedArray> namedArrays(const py::object& memory, const char* key)
{
    const auto isActive = [&](const char* what, const py::object& name) {
        return memory["active"].attr("get")(py::make_tuple(key, what)).equal(name);
    };
    std::vector<NamedArray> arrays;
    for (const py::handle pair : memory[key]) {
        const auto both = py::reinterpret_borrow<py::tuple>(pair);
        const py::object name = both[0];
        arrays.push_back(
            {name.cast<std::string>(), viewOf(both[1]), isActive("vectors", name), isActive("normals", name)});
    }
    return arrays;
}

}  // namespace

Data dataOf(const py::object& surface, const py::object& field)
{
    Data data;
    if (!surface.is_none()) {
        Surface& s = data.surface.emplace();
        s.points = viewOf(surface["points"]);
        s.triangles = viewOf(surface["triangles"]);
        s.offsets = viewOf(surface["offsets"]);
        s.connectivity = viewOf(surface["connectivity"]);
        s.pointArrays = namedArrays(surface, "point_data");
        s.cellArrays = namedArrays(surface, "cell_data");
    }
    if (field.is_none()) return data;
    if (field.contains("types")) {
        Volume& v = data.volume.emplace();
        v.points = viewOf(field["points"]);
        v.types = viewOf(field["types"]);
        v.offsets = viewOf(field["offsets"]);
        v.connectivity = viewOf(field["connectivity"]);
        v.faces = viewOf(field["faces"]);
        v.faceLocations = viewOf(field["face_locations"]);
        v.dims = field["dims"].cast<std::array<std::int64_t, 3>>();
        for (std::size_t c = 0; c < 3; ++c) v.axes[c] = viewOf(field["axes"][py::int_(c)]);
        v.pointArrays = namedArrays(field, "point_data");
        v.cellArrays = namedArrays(field, "cell_data");
    } else {
        Grid& g = data.grid.emplace();
        g.origin = field["origin"].cast<std::array<double, 3>>();
        g.spacing = field["spacing"].cast<std::array<double, 3>>();
        g.dims = field["dims"].cast<std::array<std::int64_t, 3>>();
        g.pointArrays = namedArrays(field, "point_data");
        g.cellArrays = namedArrays(field, "cell_data");
    }
    return data;
}

}  // namespace aeolic::python
