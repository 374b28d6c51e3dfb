#pragma once

#include <pybind11/numpy.h>

#include <string>
#include <utility>
#include <vector>

#include "aeolic/error.h"
#include "aeolic/topology.h"
#include "gil.h"
#include "output/output_check.h"

namespace aeolic::python {

/// One number of each item.
template <class Item, class ValueOf>
pybind11::array numbersOf(const std::vector<Item>& items, const ValueOf& valueOf)
{
    using Number = decltype(valueOf(items.front()));
    pybind11::array_t<Number> array{pybind11::ssize_t(items.size())};
    for (std::size_t i = 0; i < items.size(); ++i) array.mutable_data()[i] = valueOf(items[i]);
    return array;
}

/// Three numbers of each item: (items, 3).
template <class Item, class PlaceOf>
pybind11::array vectorsOf(const std::vector<Item>& items, const PlaceOf& placeOf)
{
    pybind11::array_t<double> array({pybind11::ssize_t(items.size()), pybind11::ssize_t(3)});
    double* out = array.mutable_data();
    for (const Item& item : items)
        for (const double number : placeOf(item)) *out++ = number;
    return array;
}

/// None where there is nothing to colour by.
inline pybind11::object scalarsOf(const std::string& scalarName, pybind11::array scalars)
{
    return scalarName.empty() ? pybind11::object(pybind11::none()) : pybind11::object(std::move(scalars));
}

/// Writes what `textOf` makes. What fails is an OSError.
template <class TextOf>
void saveText(const std::string& path, const TextOf& textOf)
{
    try {
        const WithoutGil free;
        writeTextFile(path, textOf());
    } catch (const InputError&) {
        throw;
    } catch (const std::runtime_error& error) {
        PyErr_SetString(PyExc_OSError, error.what());
        throw pybind11::error_already_set();
    }
}

}  // namespace aeolic::python
