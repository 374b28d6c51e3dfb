#include "data/named_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <vector>

#include "aeolic/error.h"
#include "base/nearest_name.h"
#include "base/text.h"
#include "description/builtin_names.h"

namespace aeolic {
namespace {

namespace fs = std::filesystem;

/// For a name that was not meant to be a file: "; did you mean teapot?".
std::string nearestBuiltin(const std::string& path)
{
    std::vector<std::string_view> names(std::begin(builtinSurfaceNames), std::end(builtinSurfaceNames));
    names.insert(names.end(), std::begin(builtinFlowNames), std::end(builtinFlowNames));
    names.insert(names.end(), {"boundary", "slice:OX,OY,OZ:NX,NY,NZ", "isosurface:ARRAY=VALUE"});
    return didYouMean(nameInSpec(path), names);
}

}  // namespace

bool namesFoamCase(const std::string& path)
{
    const std::string extension = lowerExtension(path);
    std::error_code error;
    return extension == ".foam" || extension == ".openfoam" || fs::path(path).filename() == "processor*" ||
           fs::is_directory(path, error);
}

bool namesEnSightCase(const std::string& path)
{
    const std::string extension = lowerExtension(path);
    return extension == ".case" || extension == ".encas";
}

std::uint64_t checkReadableFile(const std::string& path)
{
    const std::string expected = "a file that can be read";
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status))
        throw InputError(path, error && error.value() != ENOENT ? error.message() : "no such file",
                         expected + nearestBuiltin(path));
    if (fs::is_directory(status)) throw InputError(path, "it is a folder", expected);
    if (!fs::is_regular_file(status)) throw InputError(path, "it is a device or a pipe", expected);
    errno = 0;
    if (!std::ifstream(path, std::ios::binary)) throw InputError(path, std::strerror(errno), expected);
    const std::uint64_t bytes = fs::file_size(path, error);
    if (error || bytes == 0) throw InputError(path, error ? error.message() : "it is empty", expected);
    return bytes;
}

}  // namespace aeolic
