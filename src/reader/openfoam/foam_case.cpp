#include "reader/openfoam/foam_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>

#include "aeolic/error.h"
#include "description/color_by.h"
#include "reader/openfoam/foam_stream.h"

namespace aeolic {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kProcessor = "processor";

bool isFolder(const fs::path& path)
{
    std::error_code error;
    return fs::is_directory(path, error);
}

std::vector<std::string> namesIn(const fs::path& folder)
{
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
        names.push_back(at->path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

template <class Number>
std::optional<Number> wholeNumber(std::string_view text)
{
    Number number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (text.empty() || error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

std::optional<double> timeOf(const std::string& name)
{
    const auto time = wholeNumber<double>(name);
    return time && std::isfinite(*time) && name.front() != '-' ? time : std::nullopt;
}

/// What postProcess leaves of a time whose fields are gone holds nothing else than uniform/.
bool hasData(const fs::path& folder)
{
    std::error_code error;
    return std::any_of(fs::directory_iterator(folder, error), fs::directory_iterator(),
                       [](const fs::directory_entry& entry) { return entry.path().filename() != "uniform"; });
}

/// Folders whose name is a time and that hold data of it, by time.
std::map<double, std::string> timeFolders(const fs::path& folder)
{
    std::map<double, std::string> times;
    for (const std::string& name : namesIn(folder)) {
        const auto time = timeOf(name);
        if (time && isFolder(folder / name) && hasData(folder / name)) times.emplace(*time, name);
    }
    return times;
}

bool hasMesh(const fs::path& folder, const std::string& region)
{
    return !foamFileOf((folder / "constant" / region / "polyMesh" / "boundary").string()).empty();
}

std::vector<std::string> regionsOf(const fs::path& folder)
{
    if (hasMesh(folder, "")) return {""};
    std::vector<std::string> regions;
    for (const std::string& name : namesIn(folder / "constant"))
        if (hasMesh(folder, name)) regions.push_back(name);
    return regions;
}

/// processor0, processor1 … in the order of their numbers, of which none may be missing.
std::vector<std::string> processorFolders(const fs::path& root, const std::string& name)
{
    std::vector<int> numbers;
    for (const std::string& entry : namesIn(root)) {
        if (!entry.starts_with(kProcessor) || !isFolder(root / entry)) continue;
        if (const auto number = wholeNumber<int>(std::string_view(entry).substr(kProcessor.size())))
            numbers.push_back(*number);
        else if (entry.starts_with("processors"))
            throw InputError(name, fmt::format("'{}' holds all processors' data in one (collated)", entry),
                             "a folder for each processor, or a case put together by reconstructPar");
    }
    std::sort(numbers.begin(), numbers.end());
    std::vector<std::string> folders;
    for (const int number : numbers) {
        if (number != int(folders.size()))
            throw InputError(name, fmt::format("there is processor{}, but no processor{}", number, folders.size()),
                             "a folder for each processor");
        folders.push_back((root / fmt::format("{}{}", kProcessor, number)).string());
    }
    return folders;
}

/// Patches between processors tell which others there are.
void requireNeighbours(const FoamCase& foam)
{
    for (const std::string& folder : foam.folders)
        for (const std::string& region : foam.regions)
            for (const FoamPatch& patch : readFoamBoundary(foamMeshFile(folder, region, -1, "boundary"))) {
                const std::size_t to = patch.name.rfind("to");
                if (!patch.type.starts_with(kProcessor) || to == std::string::npos) continue;
                const auto number = wholeNumber<int>(std::string_view(patch.name).substr(to + 2));
                if (number && *number >= int(foam.folders.size()))
                    throw InputError(foam.name,
                                     fmt::format("there is no processor{}, which '{}' of {} names", *number, patch.name,
                                                 fs::path(folder).filename().string()),
                                     "a folder for each processor");
            }
}

std::vector<double> keysOf(const std::map<double, std::string>& folders)
{
    std::vector<double> times;
    for (const auto& [time, name] : folders) times.push_back(time);
    if (times.size() > 1 && times.front() == 0) times.erase(times.begin());
    return times;
}

void requireSameTimes(const FoamCase& foam)
{
    for (const std::string& folder : foam.folders) {
        const std::vector<double> times = keysOf(timeFolders(folder));
        std::vector<double> differ;
        std::set_symmetric_difference(times.begin(), times.end(), foam.times.begin(), foam.times.end(),
                                      std::back_inserter(differ));
        if (differ.empty()) continue;
        const bool missing = std::binary_search(foam.times.begin(), foam.times.end(), differ.front());
        const std::string name = fs::path(folder).filename().string();
        throw InputError(foam.name,
                         fmt::format("{} has time {}, {} has not", missing ? "processor0" : name, differ.front(),
                                     missing ? name : "processor0"),
                         "the same times in all processors' folders");
    }
}

/// Other files may lie beside the fields: theirs is empty.
std::string classOf(const std::string& path)
{
    try {
        return FoamStream(path).className();
    } catch (const InputError&) {
        return "";
    }
}

/// Notes the fields of a time's folder. The header of one that is known is not read again.
void addFields(const fs::path& folder, double time, std::vector<FoamField>& fields)
{
    for (const std::string& entry : namesIn(folder)) {
        const fs::path file = folder / entry;
        std::error_code error;
        if (!fs::is_regular_file(file, error) || entry.ends_with("~") || entry.ends_with(".orig")) continue;
        const std::string name = file.extension() == ".gz" ? file.stem().string() : entry;
        const auto same = [&](const FoamField& field) { return field.name == name; };
        auto known = std::find_if(fields.begin(), fields.end(), same);
        if (known == fields.end()) {
            const std::string type = classOf((folder / name).string());
            if (type != "volVectorField" && type != "volScalarField") continue;
            known = fields.insert(fields.end(), {name, type == "volVectorField" ? 3 : 1});
        }
        if (known->times.empty() || known->times.back() != time) known->times.push_back(time);
    }
}

/// The fields that an array like "U", "U:mag" or "cell:U" may be of.
std::array<std::string, 2> namesOf(const std::string& array)
{
    return {array, parseArray(array).name};
}

bool hasFile(const FoamCase& foam, const std::string& region, double time, const std::string& array)
{
    if (array.empty() || array.find('/') != std::string::npos) return true;  // Which no field's name has.
    const fs::path folder = fs::path(foamTimeFolder(foam.folders[0], time)) / region;
    const auto names = namesOf(array);
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& name) { return !foamFileOf((folder / name).string()).empty(); });
}

const FoamField* fieldOf(const std::vector<FoamField>& fields, const std::string& array)
{
    for (const std::string& name : namesOf(array))
        for (const FoamField& field : fields)
            if (field.name == name) return &field;
    return nullptr;
}

}  // namespace

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
    const std::vector<std::string> processors = processorFolders(root, path);
    const std::vector<std::string> regions = regionsOf(root);
    const std::vector<double> whole = keysOf(timeFolders(root));
    const std::vector<double> parts = processors.empty() ? std::vector<double>{} : keysOf(timeFolders(processors[0]));
    const double never = -1;
    const bool later = (parts.empty() ? never : parts.back()) > (whole.empty() ? never : whole.back());
    if (!processors.empty() && (demanded || regions.empty() || later)) {
        foam.folders = processors;
        foam.times = parts;
        foam.regions = regionsOf(processors[0]);
    } else {
        foam.folders = {root.string()};
        foam.times = whole;
        foam.regions = regions;
    }
    if (foam.regions.empty())
        throw InputError(path,
                         fmt::format("'{}' has no constant/polyMesh/boundary", fs::path(foam.folders[0]).string()),
                         "the folder of an OpenFOAM case with a mesh, or a file");
    if (!processors.empty() && foam.folders == processors) {
        for (const std::string& folder : processors)
            if (regionsOf(folder) != foam.regions)
                throw InputError(path, fmt::format("'{}' has other meshes than processor0", folder),
                                 "constant/polyMesh in each processor's folder");
        requireNeighbours(foam);
        requireSameTimes(foam);
    }
    return foam;
}

std::string foamTimeFolder(const std::string& folder, double time)
{
    const auto folders = timeFolders(folder);
    const auto found = folders.find(time);
    if (found == folders.end())
        throw InputError(folder, fmt::format("it has no time {}", time), "the times that 'aeolic info' lists");
    return (fs::path(folder) / found->second).string();
}

std::string foamMeshFile(const std::string& folder, const std::string& region, double time, const std::string& file)
{
    fs::path best = fs::path(folder) / "constant" / region / "polyMesh" / file;
    for (const auto& [at, name] : timeFolders(folder)) {
        if (at > time) break;
        const fs::path here = fs::path(folder) / name / region / "polyMesh" / file;
        if (!foamFileOf(here.string()).empty()) best = here;
    }
    return best.string();
}

std::vector<FoamPatch> readFoamBoundary(const std::string& path)
{
    FoamStream in(path);
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
                    if (word != "(" && word != ")" && !word.starts_with("List<") && !wholeNumber<int>(word))
                        patch.groups.push_back(word);
                }
            in.skipEntry(item);
        }
        if (std::find(patch.groups.begin(), patch.groups.end(), patch.type) == patch.groups.end())
            patch.groups.push_back(patch.type);
        if (!patches.empty() && patch.firstFace < patches.back().firstFace + patches.back().faces)
            in.fail(fmt::format("patch '{}' begins at face {}, within '{}'", patch.name, patch.firstFace,
                                patches.back().name),
                    "patches one behind the other");
        patches.push_back(std::move(patch));
    }
    if (patches.size() != count)
        in.fail(fmt::format("{} patches", patches.size()), fmt::format("{}, as it says", count));
    in.token();
    in.finish();
    return patches;
}

std::vector<FoamField> foamFields(const FoamCase& foam, const std::string& region, double time)
{
    std::vector<FoamField> fields;
    addFields(fs::path(foamTimeFolder(foam.folders[0], time)) / region, time, fields);
    return fields;
}

std::vector<FoamField> foamFieldsOfAllTimes(const FoamCase& foam, const std::string& region)
{
    std::vector<FoamField> fields;
    for (const auto& [time, name] : timeFolders(foam.folders[0]))
        if (std::binary_search(foam.times.begin(), foam.times.end(), time))
            addFields(fs::path(foam.folders[0]) / name / region, time, fields);
    return fields;
}

void requireFoamFieldAt(const FoamCase& foam, const std::string& region, double time, const std::string& array)
{
    if (foam.times.size() < 2 || hasFile(foam, region, time, array)) return;
    const std::vector<FoamField> fields = foamFieldsOfAllTimes(foam, region);
    const FoamField* field = fieldOf(fields, array);
    if (!field || std::find(field->times.begin(), field->times.end(), time) != field->times.end()) return;
    throw InputError(fmt::format("{}, time {}", foam.name, time), fmt::format("it has no '{}'", field->name),
                     field->times.size() == 1
                         ? fmt::format("time {}, the only one that has it", field->times.front())
                         : fmt::format("one of the {} times that have it, from {} to {}", field->times.size(),
                                       field->times.front(), field->times.back()));
}

std::size_t firstFoamStepWith(const FoamCase& foam, const std::vector<std::string>& arrays)
{
    const std::string& region = foam.regions.front();
    if (foam.times.size() < 2 || std::all_of(arrays.begin(), arrays.end(), [&](const std::string& array) {
            return hasFile(foam, region, foam.times.front(), array);
        }))
        return 0;
    const std::vector<FoamField> fields = foamFieldsOfAllTimes(foam, region);
    std::vector<double> times = foam.times;
    for (const std::string& array : arrays)
        if (const FoamField* field = fieldOf(fields, array))
            std::erase_if(times, [&](double time) {
                return std::find(field->times.begin(), field->times.end(), time) == field->times.end();
            });
    if (times.empty()) return 0;
    return std::size_t(std::find(foam.times.begin(), foam.times.end(), times.front()) - foam.times.begin());
}

}  // namespace aeolic
