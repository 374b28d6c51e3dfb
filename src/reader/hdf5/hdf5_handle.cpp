#include "reader/hdf5/hdf5_handle.h"

#include "base/text.h"

namespace aeolic {
namespace {

std::recursive_mutex& mutex()
{
    static auto* const mutex = new std::recursive_mutex;  // Objects that live until the program ends use it, too.
    return *mutex;
}

}  // namespace

Hdf5Lock::Hdf5Lock() : held_(mutex())
{
    // The library prints no faults of its own. It keeps that for each thread.
    thread_local const bool silent = H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr) >= 0;
    static_cast<void>(silent);
}

std::string lastHdf5Fault()
{
    std::string fault;
    H5Ewalk2(
        H5E_DEFAULT, H5E_WALK_UPWARD,
        [](unsigned, const H5E_error2_t* error, void* to) -> herr_t {
            auto& text = *static_cast<std::string*>(to);
            if (text.empty() && error->desc) text = error->desc;
            return 0;
        },
        &fault);
    return withoutControls(std::move(fault));
}

}  // namespace aeolic
