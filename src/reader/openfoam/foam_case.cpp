#include "reader/openfoam/foam_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>

#include "aeolic/error.h"
#include "base/text.h"

namespace aeolic {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kProcessor = "processor";

bool isFolder(const fs::path& path)
{
    std::error_code error;
    return fs::is_directory(path, error);
}

/// What postProcess leaves of a time whose fields are gone holds nothing else than uniform/.
bool hasData(const fs::path& folder)
{
    std::error_code error;
    return std::any_of(fs::directory_iterator(folder, error), fs::directory_iterator(),
                       [](const fs::directory_entry& entry) { return entry.path().filename() != "uniform"; });
}

/// The folders whose name is a time and that hold data of it, by time.
std::map<double, std::string> timeFolders(const fs::path& folder)
{
    std::map<double, std::string> times;
    for (const std::string& name : namesInFolder(folder)) {
        const auto time = wholeTextAs<double>(name);
        const bool isTime = time && std::isfinite(*time) && name.front() != '-';
        if (isTime && isFolder(folder / name) && hasData(folder / name)) times.emplace(*time, name);
    }
    return times;
}

std::vector<std::string> regionsOf(const fs::path& folder)
{
    const auto hasMesh = [&](const std::string& region) {
        return !foamFileOf({folder / "constant" / region / "polyMesh" / "boundary"}).empty();
    };
    if (hasMesh("")) return {""};
    std::vector<std::string> regions;
    for (const std::string& name : namesInFolder(folder / "constant"))
        if (hasMesh(name)) regions.push_back(name);
    return regions;
}

/// A folder of a processor, processor2, or of several: processors4_2-3 has the files of the processors 2 and 3 of 4,
/// processors4 those of all.
struct ProcessorFolder {
    std::string name;
    int first = 0, last = 0;
    std::optional<int> all;  ///< How many processors the case has, where the folder is of several.
};

std::optional<ProcessorFolder> processorFolder(const std::string& name)
{
    if (!name.starts_with(kProcessor)) return std::nullopt;
    std::string_view rest = std::string_view(name).substr(kProcessor.size());
    if (const auto number = wholeTextAs<int>(rest)) return ProcessorFolder{name, *number, *number, {}};
    if (!rest.starts_with('s')) return std::nullopt;
    rest.remove_prefix(1);
    const std::size_t under = std::min(rest.find('_'), rest.size());
    const auto all = wholeTextAs<int>(rest.substr(0, under));
    if (!all || *all < 1) return std::nullopt;
    if (under == rest.size()) return ProcessorFolder{name, 0, *all - 1, all};
    const std::string_view run = rest.substr(under + 1);
    const std::size_t dash = std::min(run.find('-'), run.size());
    const auto first = wholeTextAs<int>(run.substr(0, dash));
    const auto last = dash == run.size() ? first : wholeTextAs<int>(run.substr(dash + 1));
    if (!first || !last || *first < 0 || *last < *first) return std::nullopt;
    return ProcessorFolder{name, *first, *last, all};
}

/// processor0, processor1 … in the order of their numbers, of which none may be missing. Where there are none of these,
/// the folders of collated files in the order of their processors, of which none may be missing either.
std::vector<FoamPath> processorFolders(const fs::path& root, const std::string& name)
{
    std::vector<ProcessorFolder> found;
    for (const std::string& entry : namesInFolder(root))
        if (auto folder = processorFolder(entry); folder && isFolder(root / entry)) found.push_back(std::move(*folder));
    const auto isCollated = [](const ProcessorFolder& folder) { return folder.all.has_value(); };
    if (!std::ranges::all_of(found, isCollated)) std::erase_if(found, isCollated);
    std::ranges::sort(found, [](const ProcessorFolder& a, const ProcessorFolder& b) { return a.first < b.first; });
    std::vector<FoamPath> folders;
    for (const ProcessorFolder& folder : found) {
        if (folder.first != int(folders.size()))
            throw InputError(name, fmt::format("there is {}, but no processor{}", folder.name, folders.size()),
                             "the data of each processor");
        for (int block = 0; block <= folder.last - folder.first; ++block)
            folders.push_back({root / folder.name, folder.all ? block : -1});
    }
    if (!found.empty() && int(folders.size()) != found.front().all.value_or(int(folders.size())))
        throw InputError(name, fmt::format("there are {} processors in {}", folders.size(), found.back().name),
                         std::to_string(*found.front().all));
    return folders;
}

/// Patches between processors tell which others there are.
void requireNeighbours(const FoamCase& foam)
{
    for (const FoamPath& folder : foam.folders)
        for (const std::string& region : foam.regions)
            for (const FoamPatch& patch : readFoamBoundary(foamMeshFile(folder, region, -1, "boundary"))) {
                const std::size_t to = patch.name.rfind("to");
                if (!patch.type.starts_with(kProcessor) || to == std::string::npos) continue;
                const auto number = wholeTextAs<int>(std::string_view(patch.name).substr(to + 2));
                if (number && *number >= int(foam.folders.size()))
                    throw InputError(foam.name,
                                     fmt::format("there is no processor{}, which '{}' of {} names", *number, patch.name,
                                                 folder.path.filename().string()),
                                     "the data of each processor");
            }
}

std::vector<double> timesOf(const fs::path& folder)
{
    std::vector<double> times;
    for (const auto& [time, name] : timeFolders(folder)) times.push_back(time);
    if (times.size() > 1 && times.front() == 0) times.erase(times.begin());
    return times;
}

void requireSameTimes(const FoamCase& foam)
{
    const std::string first = foam.folders.front().path.filename().string();
    for (const FoamPath& folder : foam.folders) {
        const std::vector<double> times = timesOf(folder.path);
        std::vector<double> differ;
        std::set_symmetric_difference(times.begin(), times.end(), foam.times.begin(), foam.times.end(),
                                      std::back_inserter(differ));
        if (differ.empty()) continue;
        const bool missing = std::binary_search(foam.times.begin(), foam.times.end(), differ.front());
        const std::string name = folder.path.filename().string();
        throw InputError(
            foam.name,
            fmt::format("{} has time {}, {} has not", missing ? first : name, differ.front(), missing ? name : first),
            "the same times in all processors' folders");
    }
}

}  // namespace

std::vector<std::string> namesInFolder(const fs::path& folder)
{
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
        names.push_back(at->path().filename().string());
    std::ranges::sort(names);
    return names;
}

FoamCase findFoamCase(const std::string& path)
{
    FoamCase foam;
    foam.name = path;
    fs::path root(path);
    const bool demanded = root.filename() == "processor*";
    if (demanded || !isFolder(root)) {
        std::error_code error;
        if (!demanded && !fs::exists(root, error)) throw InputError(path, "no such file", "a file that can be read");
        root = root.parent_path().empty() ? fs::path(".") : root.parent_path();
    }
    const std::vector<FoamPath> processors = processorFolders(root, path);
    foam.regions = regionsOf(root);
    foam.times = timesOf(root);
    const std::vector<double> parts = processors.empty() ? std::vector<double>() : timesOf(processors[0].path);
    const bool later = !parts.empty() && (foam.times.empty() || parts.back() > foam.times.back());
    const bool decomposed = !processors.empty() && (demanded || foam.regions.empty() || later);
    foam.folders = {{root}};
    if (decomposed) {
        foam.folders = processors;
        foam.times = parts;
        foam.regions = regionsOf(processors[0].path);
    }
    if (foam.regions.empty())
        throw InputError(path, fmt::format("'{}' has no constant/polyMesh/boundary", foam.folders[0].path.string()),
                         "the folder of an OpenFOAM case with a mesh, or a file");
    if (!decomposed) return foam;
    for (const FoamPath& folder : processors)
        if (regionsOf(folder.path) != foam.regions)
            throw InputError(path, fmt::format("'{}' has other meshes than the first", folder.path.string()),
                             "constant/polyMesh in each processor's folder");
    requireNeighbours(foam);
    requireSameTimes(foam);
    return foam;
}

FoamPath foamFieldFile(const FoamPath& folder, const std::string& region, double time, const std::string& field)
{
    const auto folders = timeFolders(folder.path);
    const auto found = folders.find(time);
    if (found == folders.end())
        throw InputError(folder.path.string(), fmt::format("it has no time {}", time),
                         "the times that 'aeolic info' lists");
    return folder / found->second / region / field;
}

FoamPath foamMeshFile(const FoamPath& folder, const std::string& region, double time, const std::string& file)
{
    FoamPath best = folder / "constant" / region / "polyMesh" / file;
    for (const auto& [at, name] : timeFolders(folder.path)) {
        if (at > time) break;
        const FoamPath here = folder / name / region / "polyMesh" / file;
        if (!foamFileOf(here).empty()) best = here;
    }
    return best;
}

std::vector<FoamPatch> readFoamBoundary(const FoamPath& file)
{
    FoamStream in(file);
    const std::uint64_t count = in.count("number of patches");
    in.expect("(", "patches");
    std::vector<FoamPatch> patches;
    while (in.peekToken() != ")") {
        FoamPatch patch;
        patch.name = in.token();
        in.expect("{", "patch '" + patch.name + "'");
        for (std::string key = in.token(); key != "}"; key = in.token()) {
            if (key.empty()) in.fail("the file is cut off", "a complete file");
            const std::string item = fmt::format("patch '{}', {}", patch.name, key);
            if (key == "type") patch.type = in.peekToken();
            if (key == "nFaces") patch.faces = in.count(item);
            if (key == "startFace") patch.firstFace = in.count(item);
            if (key == "inGroups")
                while (in.peekToken() != ";" && !in.peekToken().empty()) {
                    const std::string word = in.token();
                    if (word != "(" && word != ")" && !word.starts_with("List<") && !wholeTextAs<int>(word))
                        patch.groups.push_back(word);
                }
            in.skipEntry(item);
        }
        if (std::ranges::find(patch.groups, patch.type) == patch.groups.end()) patch.groups.push_back(patch.type);
        if (!patches.empty() && patch.firstFace < patches.back().firstFace + patches.back().faces)
            in.fail(fmt::format("patch '{}' begins at face {}, within '{}'", patch.name, patch.firstFace,
                                patches.back().name),
                    "patches one behind the other");
        patches.push_back(std::move(patch));
    }
    if (patches.size() != count)
        in.fail(fmt::format("{} patches", patches.size()), fmt::format("{}, as it says", count));
    return patches;
}

}  // namespace aeolic
