#pragma once

/// So that one source is right for the libraries 1.10, 1.12 and 1.14.
#define H5_USE_110_API
#include <hdf5.h>

#include <string>
#include <type_traits>
#include <utility>

#include "reader/hdf5/hdf5_lock.h"

namespace aeolic {

/// An identifier of the library, of any kind; closes it. A number below zero is not an identifier.
class Hdf5Handle {
public:
    explicit Hdf5Handle(hid_t id) : id_(id) {}
    Hdf5Handle(Hdf5Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)) {}
    Hdf5Handle& operator=(Hdf5Handle&& other) noexcept
    {
        std::swap(id_, other.id_);
        return *this;
    }
    ~Hdf5Handle()
    {
        if (id_ < 0) return;
        const Hdf5Lock lock;
        H5Idec_ref(id_);
    }

    operator hid_t() const { return id_; }

private:
    hid_t id_;
};

/// What the library says of its last call that failed, where the fault was found. Empty where it says nothing.
std::string lastHdf5Fault();

/// The library's type for a number of C++: float, double, std::int8_t, std::int32_t or std::int64_t.
template <class Number>
hid_t nativeHdf5Type()
{
    if constexpr (std::is_floating_point_v<Number>)
        return sizeof(Number) == 4 ? H5T_NATIVE_FLOAT : H5T_NATIVE_DOUBLE;
    else
        return sizeof(Number) == 1 ? H5T_NATIVE_INT8 : sizeof(Number) == 4 ? H5T_NATIVE_INT32 : H5T_NATIVE_INT64;
}

}  // namespace aeolic
