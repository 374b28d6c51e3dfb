#include "reader/parts/open_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <utility>

#include "aeolic/error.h"
#include "data/vector_names.h"
#include "reader/fluent/fluent_mesh.h"

namespace aeolic {
namespace {

constexpr int kBetweenCells = 2;

/// What the numbers of data mean, as VTK names them.
std::string nameOfData(int number)
{
    static constexpr std::pair<int, const char*> kNames[] = {
        {1, "PRESSURE"},     {3, "TEMPERATURE"},  {4, "ENTHALPY"},    {5, "TKE"},
        {6, "TED"},          {18, "MASS_FLUX"},   {19, "WALL_SHEAR"}, {20, "BOUNDARY_HEAT_FLUX"},
        {35, "YPLUS"},       {59, "MACH"},        {63, "SDR"},        {96, "WALL_DIST"},
        {101, "DENSITY"},    {102, "MU_LAM"},     {103, "MU_TURB"},   {111, "X_VELOCITY"},
        {112, "Y_VELOCITY"}, {113, "Z_VELOCITY"}, {150, "VOF"}};
    for (const auto& [known, name] : kNames)
        if (known == number) return name;
    return fmt::format("data {}", number);
}

/// Values of one kind on the cells or faces of a zone.
struct FluentValues {
    int number = 0, zone = 0;
    std::size_t width = 1;
    std::int64_t first = 1, last = 0;
    const FluentSection* section = nullptr;
};

/// Other programs write files that end in .dat, too.
bool beginsLikeFluent(const std::string& path)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return false;
    std::ifstream file(path, std::ios::binary);
    char first = ' ';
    file >> first;                           // Passes over blanks.
    return first == '(' || first == '\x1f';  // Files packed by gzip are refused later.
}

class FluentParts : public PartSource {
public:
    explicit FluentParts(const std::string& path) : mesh_(path)
    {
        findParts();
        const std::string beside = std::filesystem::path(path).replace_extension(".dat").string();
        if (std::filesystem::path(path).extension() != ".msh" && beginsLikeFluent(beside)) {
            data_ = std::make_unique<FluentText>(beside);
            swapped_ = mesh_.swapped();
            for (const FluentSection& section : data_->sections()) readHead(section);
        }
        addArrays();
    }

    PartMesh read(std::size_t part, const std::vector<std::size_t>& wanted) override
    {
        const int zone = zoneIds_[part];
        PartMesh mesh;
        mesh.shared = true;
        mesh.points = mesh_.points();
        MeshFaces faces;
        if (parts_[part].derived) {
            for (const FluentRange& range : mesh_.faces())
                if (range.zone == zone) mesh_.read(range, faces);
            std::vector<std::uint32_t> behind;
            for (std::size_t i = 0; i < faces.count(); ++i) {
                if (faces.face(i).size() < 3) mesh_.text().fail("a face has two corners", "three or more, in space");
                // Where the first side has no cell, the face belongs to the other.
                behind.push_back(faces.inside[i] > 0 ? faces.inside[i] : faces.outside[i]);
            }
            mesh.cells.push_back(faces.asPolygons());
            faces.inside = std::move(behind);
        } else {
            mesh.cells = mesh_.cellsOf(zone);
        }
        for (const std::size_t array : wanted) mesh.values.push_back(values(part, faces, array));
        return mesh;
    }

private:
    void findParts()
    {
        std::set<int> seen;
        for (const FluentRange& range : mesh_.cells()) {
            if (!seen.insert(range.zone).second) continue;
            add(range.zone, mesh_.dimensions() == 3 ? "volume" : "faces", mesh_.dimensions(), false);
        }
        bool walls = false;
        for (const FluentRange& range : mesh_.faces()) {
            if (mesh_.dimensions() == 2 || range.kind == kBetweenCells || !seen.insert(range.zone).second) continue;
            const auto zone = mesh_.zones().find(range.zone);
            const std::string type = zone != mesh_.zones().end() ? zone->second.type
                                     : range.kind == 3           ? "wall"
                                                                 : "faces";
            if (type == "interior") continue;
            add(range.zone, type, 2, true);
            walls = walls || type == "wall";
        }
        for (PartInfo& part : parts_)
            if (part.derived && walls) part.usual = part.type == "wall";
        if (parts_.empty()) mesh_.text().fail("it has no cells and no faces at its edge", "a mesh");
    }

    void add(int zone, const std::string& type, int dimension, bool derived)
    {
        const auto known = mesh_.zones().find(zone);
        PartInfo part{
            known != mesh_.zones().end() ? known->second.name : fmt::format("zone_{}", zone), type, {type}, dimension};
        if (known != mesh_.zones().end()) part.groups.push_back(fmt::format("zone_{}", zone));
        part.derived = derived;
        parts_.push_back(std::move(part));
        zoneIds_.push_back(zone);
    }

    void readHead(const FluentSection& section)
    {
        const std::vector<std::string> words =
            section.index == 4 || section.index == 300 ? data_->words(section) : std::vector<std::string>();
        if (section.index == 4 && !words.empty()) swapped_ = fluentIsSwapped(words);
        if (section.index != 300) return;
        std::vector<std::int64_t> numbers;
        numbers.reserve(words.size());
        for (const std::string& word : words) numbers.push_back(data_->number(word, 10));
        if (numbers.size() < 7) data_->fail(fmt::format("values have {} words in their head", numbers.size()), "7");
        const FluentValues values{int(numbers[0]), int(numbers[1]), std::size_t(numbers[2]),
                                  numbers[5],      numbers[6],      &section};
        if (values.width != 1 && values.width != 3 && values.width != std::size_t(mesh_.dimensions()))
            return;  // Of several phases or species.
        if (values.first < 1 || values.last < values.first - 1)
            data_->fail(fmt::format("values go from {} to {}", values.first, values.last), "numbers of cells or faces");
        values_.push_back(values);
    }

    void addArrays()
    {
        std::vector<std::string> names;
        std::vector<std::size_t> widths;
        std::vector<int> numbers;
        for (const FluentValues& values : values_) {
            if (std::ranges::find(numbers, values.number) != numbers.end()) continue;
            numbers.push_back(values.number);
            names.push_back(nameOfData(values.number));
            widths.push_back(values.width);
        }
        for (const NamedComponents& each : joinComponents(names, mesh_.dimensions() == 2)) {
            std::vector<int> of;
            for (const std::size_t component : each.of) of.push_back(numbers[component]);
            const bool vectors = of.size() > 1 || widths[each.of.front()] > 1;
            arrays_.push_back({each.name, false, vectors ? 3 : 1, NumberType::float64});
            of_.push_back(std::move(of));
        }
    }

    /// The values of a kind by the number of a cell or face; `to` has one more for each component.
    void take(int number, int zone, std::int64_t first, std::size_t component, std::size_t width,
              std::vector<float>& to, bool& any) const
    {
        for (const FluentValues& values : values_) {
            if (values.number != number || values.zone != zone) continue;
            FluentNumbers numbers(*data_, *values.section, swapped_);
            const auto count = std::size_t(values.last - values.first + 1);
            for (std::size_t i = 0; i < count; ++i)
                for (std::size_t c = 0; c < values.width; ++c) {
                    const auto value = float(numbers.real());
                    const std::int64_t at =
                        (values.first + std::int64_t(i) - first) * std::int64_t(width) + std::int64_t(component + c);
                    if (at >= 0 && at < std::int64_t(to.size())) to[std::size_t(at)] = value;
                }
            any = true;
        }
    }

    PartValues values(std::size_t part, const MeshFaces& faces, std::size_t array) const
    {
        const auto width = std::size_t(arrays_[array].components);
        bool any = false;
        const auto missing = [&](std::size_t count) {
            std::vector<float> all(count * width, kMissing);
            for (std::size_t i = 2; width == 3 && mesh_.dimensions() == 2 && i < all.size(); i += 3) all[i] = 0;
            return all;
        };
        std::vector<float> found;
        for (const FluentRange& range : parts_[part].derived ? mesh_.faces() : mesh_.cells()) {
            if (range.zone != zoneIds_[part]) continue;
            std::vector<float> own = missing(range.count());
            for (std::size_t c = 0; c < of_[array].size(); ++c)
                take(of_[array][c], range.zone, range.first, c, width, own, any);
            found.insert(found.end(), own.begin(), own.end());
        }
        if (any || !parts_[part].derived)
            return any ? std::make_shared<const std::vector<float>>(std::move(found)) : nullptr;
        // The faces have no values of their own, so the cells behind them give theirs.
        const auto last = mesh_.cells().empty() ? 0 : mesh_.cells().back().last;
        std::vector<float> all = missing(std::size_t(last));
        for (const FluentRange& range : mesh_.cells())
            for (std::size_t c = 0; c < of_[array].size(); ++c) take(of_[array][c], range.zone, 1, c, width, all, any);
        if (!any) return nullptr;
        found.clear();
        for (const std::uint32_t cell : faces.inside)
            for (std::size_t c = 0; c < width; ++c)
                found.push_back(cell > 0 ? all[std::size_t(cell - 1) * width + c] : kMissing);
        return std::make_shared<const std::vector<float>>(std::move(found));
    }

    FluentMesh mesh_;
    std::unique_ptr<FluentText> data_;
    bool swapped_ = false;      // The numbers of data_.
    std::vector<int> zoneIds_;  // Of each part.
    std::vector<FluentValues> values_;
    std::vector<std::vector<int>> of_;  // Of each array: the numbers of the values that it is made of.
};

}  // namespace

std::unique_ptr<PartSource> openFluentFile(const std::string& path, std::optional<double>)
{
    return std::make_unique<FluentParts>(path);
}

}  // namespace aeolic
