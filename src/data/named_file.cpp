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

const FileKind* namedKind(const std::string& path)
{
    std::error_code error;
    const bool folder = fs::path(path).filename() == "processor*" || fs::is_directory(path, error);
    return folder ? &folderKind : fileKindOf(path);
}

bool namedKindHas(const std::string& path, FileFact fact)
{
    const FileKind* kind = namedKind(path);
    return kind && kind->has(fact);
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
