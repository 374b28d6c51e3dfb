#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace aeolic::python {

/// A str of what the library tells. Names in files may be in other bytes than UTF-8, which become U+FFFD.
pybind11::str textOf(const std::string& told);

/// Lets Python raise `type` with the message on one line, whatever names it holds.
void raise(pybind11::handle type, std::string message);

/// Adds InputError, and lets what the library throws become exceptions of one line.
void addErrors(pybind11::module_& module);

}  // namespace aeolic::python
