#include <dlfcn.h>

#include <filesystem>

#include "aeolic/error.h"
#include "reader/vtk/modules/modules.h"

namespace aeolic {
namespace {

template <class Module>
const Module& loaded(const char* file, const char* symbol)
{
    std::error_code error;
    const auto path = std::filesystem::read_symlink("/proc/self/exe", error).parent_path() / file;
    void* const library = dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);  // Until the program ends.
    const void* const module = library ? dlsym(library, symbol) : nullptr;
    if (!module) {
        const char* reason = dlerror();
        throw InputError(file, reason ? reason : "it cannot be loaded", "it beside aeolic-reader, as installed");
    }
    return *static_cast<const Module*>(module);
}

}  // namespace

const Hdf5Module& hdf5Module()
{
    static const Hdf5Module& module = loaded<Hdf5Module>("aeolic-reader-hdf5.so", "aeolicHdf5Module");
    return module;
}

const VtkModule& vtkModule()
{
    static const VtkModule& module = loaded<VtkModule>("aeolic-reader-vtk.so", "aeolicVtkModule");
    return module;
}

}  // namespace aeolic
