#include "pixels.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <string>
#include <utility>
#include <vector>

#include "errors.h"

namespace aeolic::python {
namespace {

namespace py = pybind11;

py::object vectorOrNone(const std::optional<Vec3>& v)
{
    return v ? py::object(py::make_tuple((*v)[0], (*v)[1], (*v)[2])) : py::none();
}

py::object nameOrNone(const std::string& name)
{
    return name.empty() ? py::object(py::none()) : py::object(textOf(name));
}

}  // namespace

py::object told(const std::optional<PickedPlace>& place)
{
    if (!place) return py::none();
    py::dict fields;
    fields["position"] = vectorOrNone(place->position);
    fields["depth"] = place->depth;
    fields["normal"] = vectorOrNone(place->normal);
    fields["triangle"] = place->triangle;
    fields["surface"] = textOf(place->surface);
    fields["vector_name"] = nameOrNone(place->vectorName);
    fields["vector"] = vectorOrNone(place->vector);
    fields["tangential"] = vectorOrNone(place->tangential);
    fields["scalar"] = place->scalar;
    fields["scalar_name"] = nameOrNone(place->scalarName);
    return fields;
}

py::dict arraysOf(PictureBuffers buffers)
{
    const auto array = [&]<class Number>(std::vector<Number>& numbers, py::ssize_t parts) {
        std::vector<py::ssize_t> shape{buffers.height, buffers.width};
        if (parts > 1) shape.push_back(parts);
        auto* const held = new std::vector<Number>(std::move(numbers));
        const py::capsule owner(held, [](void* memory) { delete static_cast<std::vector<Number>*>(memory); });
        return py::array_t<Number>(shape, held->data(), owner);
    };
    py::dict fields;
    fields["depth"] = array(buffers.depth, 1);
    fields["normal"] = array(buffers.normal, 3);
    fields["flow"] = array(buffers.flow, 2);
    fields["lic"] = array(buffers.lic, 1);
    fields["scalar"] = buffers.scalar.empty() ? py::object(py::none()) : py::object(array(buffers.scalar, 1));
    fields["surface"] = array(buffers.surface, 1);
    return fields;
}

}  // namespace aeolic::python
