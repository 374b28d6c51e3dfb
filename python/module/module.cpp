#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <chrono>
#include <exception>
#include <future>
#include <optional>
#include <stop_token>
#include <string>

#include "aeolic/aeolic.h"
#include "aeolic/plane.h"
#include "base/nearest_name.h"
#include "data/load/file_info.h"
#include "errors.h"
#include "gil.h"
#include "loaded.h"
#include "options.h"
#include "streamlines.h"
#include "topology.h"
#include "version.h"

/// aeolic._core: what aeolic/*.py is made of. Nothing here checks Python's types twice: aeolic/_data.py and _options.py
/// do.
namespace aeolic::python {
namespace {

namespace py = pybind11;

/// Instead of a picture of memory that nothing was written to.
PyObject* refuseNew(PyTypeObject*, PyObject*, PyObject*)
{
    PyErr_SetString(PyExc_TypeError, "Picture: found none drawn; expected what render() gives");
    return nullptr;
}

void addPicture(py::module_& module)
{
    py::class_<Picture> picture(
        module, "Picture", py::buffer_protocol(),
        "A picture: (height, width, 3 or 4) bytes, sRGB, rows from the top; 4 where the background is "
        "transparent (alpha is not premultiplied). numpy.asarray(picture) is the picture's own memory. "
        "In a notebook it shows itself.");
    reinterpret_cast<PyTypeObject*>(picture.ptr())->tp_new = refuseNew;
    picture
        .def_buffer([](Picture& p) {
            const auto channels = py::ssize_t(p.channels), width = py::ssize_t(p.width), height = py::ssize_t(p.height);
            return py::buffer_info(p.pixels.data(), 1, py::format_descriptor<std::uint8_t>::format(), 3,
                                   {height, width, channels}, {width * channels, channels, py::ssize_t(1)});
        })
        .def_readonly("width", &Picture::width, "Pixels.")
        .def_readonly("height", &Picture::height, "Pixels.")
        .def_readonly("channels", &Picture::channels, "3: RGB, 4: RGBA.")
        .def_property_readonly(
            "shape", [](const Picture& p) { return py::make_tuple(p.height, p.width, p.channels); },
            "(height, width, channels)")
        .def_property_readonly("__array_interface__",
                               [](Picture& p) {
                                   py::dict told;
                                   told["version"] = 3;
                                   told["shape"] = py::make_tuple(p.height, p.width, p.channels);
                                   told["typestr"] = "|u1";
                                   told["data"] =
                                       py::make_tuple(reinterpret_cast<std::uintptr_t>(p.pixels.data()), false);
                                   return told;
                               })
        .def("_repr_png_",
             [](const Picture& p) {
                 std::string file;
                 {
                     const WithoutGil free;
                     file = pngOf(p);
                 }
                 return py::bytes(file);
             })
        .def("_save",
             [](const Picture& p, const std::string& path) {
                 try {
                     const WithoutGil free;
                     writePicture(p, path);
                 } catch (const InputError&) {
                     throw;
                 } catch (const std::runtime_error& error) {
                     raise(PyExc_OSError, error.what());
                     throw py::error_already_set();
                 }
             })
        .def("__repr__", [](const Picture& p) {
            return "<aeolic.Picture of " + std::to_string(p.width) + " x " + std::to_string(p.height) + " pixels, " +
                   (p.channels == 4 ? "RGBA" : "RGB") + ">";
        });
}

void addLoaded(py::module_& module)
{
    py::class_<Loaded>(module, "Loaded")
        .def(py::init([](const std::optional<std::string>& sceneFile, const std::optional<std::string>& sceneText,
                         const Texts& given, const std::string& items, const std::vector<std::string>& contexts,
                         const py::object& surface, const py::object& field, const py::object& progress) {
            return std::make_unique<Loaded>(GivenScene{sceneFile, sceneText}, given, Surfaces{items, contexts}, surface,
                                            field, progress);
        }))
        .def("require_free", &Loaded::requireFree)
        .def("render", &Loaded::render)
        .def("render_frame", &Loaded::renderFrame)
        .def("save_animation", &Loaded::saveAnimation)
        .def("set", &Loaded::set)
        .def("set_time", &Loaded::setTime)
        .def("set_shown", &Loaded::setShown)
        .def("set_data", &Loaded::setData)
        .def("show", &Loaded::show)
        .def("hide", &Loaded::hide)
        .def("control", &Loaded::control)
        .def("set_control", &Loaded::setControl)
        .def("info", &Loaded::info)
        .def("warnings", &Loaded::warnings)
        .def("stats", &Loaded::stats)
        .def("topology", &Loaded::topology)
        .def("separation", &Loaded::separation)
        .def("streamlines", &Loaded::streamlines)
        .def("pick", &Loaded::pick)
        .def("buffers", &Loaded::buffers)
        .def("scene", &Loaded::scene);
}

/// Does `work` in a thread of its own, while Python handles signals in this one. What a handler raises stops it.
template <class Work>
void interruptibly(const Work& work)
{
    constexpr auto kLookAgain = std::chrono::milliseconds(50);
    std::stop_source stop;
    std::exception_ptr raised;
    auto done = std::async(std::launch::async, [&] { work(stop.get_token()); });
    const auto isDone = [&] {
        const WithoutGil free;
        return done.wait_for(kLookAgain) == std::future_status::ready;
    };
    while (!isDone()) {
        if (raised || PyErr_CheckSignals() == 0) continue;
        raised = std::make_exception_ptr(py::error_already_set());
        stop.request_stop();
    }
    if (raised) std::rethrow_exception(raised);
    done.get();
}

py::list textsOf(const std::vector<std::string>& texts)
{
    py::list all;
    for (const std::string& text : texts) all.append(textOf(text));
    return all;
}

py::dict fileInfo(const std::string& path)
{
    const FileInfo info = [&] {
        const WithoutGil free;
        return aeolic::fileInfo(path);
    }();
    const FileSummary& summary = info.summary;
    py::list arrays, parts;
    for (const ArraySummary& array : summary.arrays)
        arrays.append(py::make_tuple(textOf(array.name), textOf(array.association), textOf(array.type),
                                     array.components, array.range));
    for (const PartSummary& part : summary.parts)
        parts.append(py::make_tuple(textOf(part.name), textOf(part.type), part.polygons, part.fillsSpace));
    py::dict told;
    told["text"] = textOf(info.text);
    told["kind"] = textOf(summary.kind);
    told["points"] = summary.points;
    told["cells"] = summary.cells;
    told["bounds"] = py::none();
    if (const Bounds& bounds = summary.boundsWorld; !bounds.empty())
        told["bounds"] = py::make_tuple(bounds.lo.x, bounds.hi.x, bounds.lo.y, bounds.hi.y, bounds.lo.z, bounds.hi.z);
    told["times"] = py::tuple(py::cast(summary.timeSteps));
    told["arrays"] = arrays;
    told["parts"] = parts;
    told["vectors"] = py::none();
    if (const std::string name = summary.vectors.value_or(summary.firstVectors); !name.empty())
        told["vectors"] = textOf(name);
    told["suggestions"] = py::tuple(textsOf(info.suggestions));
    return told;
}

using Floats = py::array_t<float, py::array::c_style>;

py::array lic2d(const Floats& u, const Floats& v, const std::optional<Floats>& texture, bool periodic, bool axial,
                const Texts& options)
{
    const LicOptions lic = changed({}, options).lic;
    const PlaneFlow flow{
        int(u.shape(1)), int(u.shape(0)), u.data(), v.data(), texture ? texture->data() : nullptr, periodic, axial};
    Floats values({u.shape(0), u.shape(1)});
    float* const memory = values.mutable_data();
    interruptibly([&](const std::stop_token& stop) { licOfPlane(flow, lic, memory, stop); });
    return values;
}

}  // namespace
}  // namespace aeolic::python

PYBIND11_MODULE(_core, module)
{
    namespace py = pybind11;
    using namespace aeolic::python;
    module.attr("__version__") = aeolic::versionText;
    addErrors(module);
    addPicture(module);
    addLoaded(module);
    addTopology(module);
    addStreamlines(module);
    module.def("option_table", optionTable);
    module.def("lic2d", lic2d);
    module.def("nearest", [](const std::string& typed, const std::vector<std::string>& names) {
        return aeolic::didYouMean(typed, names);
    });
    module.def("file_info", fileInfo);
}
