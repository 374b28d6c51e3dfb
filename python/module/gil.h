#pragma once

#include <pybind11/pybind11.h>
#include <unistd.h>

namespace aeolic::python {

/// Does what may take the GIL, by Python's C functions alone. CPython before 3.14 ends a thread that takes it while the
/// interpreter ends, by unwinding its stack, which no destructor lets through. Such a thread sleeps until the process
/// is gone, as it does with later ones.
template <class Calls>
auto orSleep(const Calls& calls) noexcept
{
    try {
        return calls();
    } catch (...) {
        for (;;) pause();
    }
}

class WithoutGil {
public:
    WithoutGil() : state_(PyEval_SaveThread()) {}
    ~WithoutGil()
    {
        orSleep([&] { PyEval_RestoreThread(state_); });
    }
    WithoutGil(const WithoutGil&) = delete;
    WithoutGil& operator=(const WithoutGil&) = delete;

private:
    PyThreadState* const state_;
};

class WithGil {
public:
    WithGil() : state_(orSleep([] { return PyGILState_Ensure(); })) {}
    ~WithGil() { PyGILState_Release(state_); }
    WithGil(const WithGil&) = delete;
    WithGil& operator=(const WithGil&) = delete;

private:
    const PyGILState_STATE state_;
};

}  // namespace aeolic::python
