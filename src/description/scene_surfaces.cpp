#include "description/scene_surfaces.h"

#include <filesystem>
#include <string_view>

#include "aeolic/error.h"
#include "base/text.h"
#include "description/file_kinds.h"

namespace aeolic {
namespace {

/// The colon behind the file's name. Names of parts may have colons, too, so it is the last one behind a file that is
/// there, else behind a name that ends like one, else the last of all.
std::size_t colonBehindFile(const std::string& spec)
{
    const auto find = [&](const auto& isFile) {
        std::size_t colon = spec.rfind(':');
        while (colon != std::string::npos && colon > 0 && !isFile(spec.substr(0, colon)))
            colon = spec.rfind(':', colon - 1);
        return colon == 0 ? std::string::npos : colon;
    };
    const auto isThere = [](const std::string& file) {
        std::error_code error;
        return std::filesystem::exists(file, error);
    };
    std::size_t colon = find(isThere);
    if (colon == std::string::npos) colon = find([](const std::string& file) { return fileKindOf(file) != nullptr; });
    return colon == std::string::npos ? spec.rfind(':') : colon;
}

}  // namespace

FileAndParts splitParts(const std::string& spec)
{
    std::error_code error;
    if (std::filesystem::exists(spec, error)) return {spec, {}};
    const std::size_t colon = colonBehindFile(spec);
    if (colon == std::string::npos || colon == 0) return {spec, {}};
    FileAndParts split{spec.substr(0, colon), {}};
    for (const std::string_view part : splitText(std::string_view(spec).substr(colon + 1), ','))
        if (!part.empty()) split.parts.emplace_back(part);
    if (split.parts.empty())
        throw InputError("surface '" + spec + "'", "no part is named behind ':'", "names, groups or patterns with *");
    return split;
}

std::vector<SurfaceItem> surfacesOf(const SceneDescription& scene)
{
    if (!scene.surfaces.empty()) return scene.surfaces;
    SurfaceItem only;
    only.spec = scene.surface.spec;
    return {only};
}

std::string surfacesText(const SceneDescription& scene)
{
    std::string text;
    for (const SurfaceItem& item : surfacesOf(scene)) text += (text.empty() ? "" : ", ") + item.spec;
    return text;
}

}  // namespace aeolic
