#include "errors.h"

#include <stdexcept>

#include "aeolic/error.h"
#include "description/option_names.h"

namespace aeolic::python {

namespace py = pybind11;

py::str textOf(const std::string& told)
{
    PyObject* const text = PyUnicode_DecodeUTF8(told.data(), py::ssize_t(told.size()), "replace");
    if (!text) throw py::error_already_set();
    return py::reinterpret_steal<py::str>(text);
}

void raise(py::handle type, std::string message)
{
    for (char& c : message)
        if (static_cast<unsigned char>(c) < 0x20) c = ' ';
    PyErr_SetObject(type.ptr(), textOf(message).ptr());
}

void addErrors(py::module_& module)
{
    py::exception<InputError> inputError(module, "InputError", PyExc_ValueError);
    inputError.attr("__module__") = "aeolic";
    static const py::handle raised = inputError.release();  // It lives as long as the process does.
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) std::rethrow_exception(thrown);
        } catch (const InputError& error) {
            raise(raised, inPythonsWords(error.what()));
        } catch (const py::builtin_exception&) {
            throw;
        } catch (const std::runtime_error& error) {
            raise(PyExc_RuntimeError, error.what());
        }
    });
}

}  // namespace aeolic::python
