#include "reader/openfoam/foam_folders.h"

#include <algorithm>
#include <cmath>

namespace aeolic {

namespace fs = std::filesystem;

namespace {

/// What postProcess leaves of a time whose fields are gone holds nothing else than uniform/.
bool hasData(const fs::path& folder)
{
    std::error_code error;
    return std::any_of(fs::directory_iterator(folder, error), fs::directory_iterator(),
                       [](const fs::directory_entry& entry) { return entry.path().filename() != "uniform"; });
}

}  // namespace

bool isFoamFolder(const fs::path& path)
{
    std::error_code error;
    return fs::is_directory(path, error);
}

std::vector<std::string> namesInFolder(const fs::path& folder)
{
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
        names.push_back(at->path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::map<double, std::string> foamTimeFolders(const fs::path& folder)
{
    std::map<double, std::string> times;
    for (const std::string& name : namesInFolder(folder)) {
        const auto time = foamNumber<double>(name);
        const bool isTime = time && std::isfinite(*time) && name.front() != '-';
        if (isTime && isFoamFolder(folder / name) && hasData(folder / name)) times.emplace(*time, name);
    }
    return times;
}

}  // namespace aeolic
