#include "reader/parts/open_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "reader/ensight/ensight_case.h"
#include "reader/ensight/ensight_geometry.h"

namespace aeolic {
namespace {

PartPoints pointsOf(const EnSightPart& part)
{
    auto points = std::make_shared<std::vector<glm::dvec3>>(part.pointCount());
    for (std::size_t i = 0; i < points->size(); ++i)
        (*points)[i] = {part.points[0][i], part.points[1][i], part.points[2][i]};
    return points;
}

/// A variable's values: for each part as many as it has points, or cells that are kept, each of the variable's number
/// of components. NaN where the file says that a value is undefined, or has none.
class ValuesText {
public:
    ValuesText(const EnSightPlace& place, const EnSightVariable& variable, const EnSightGeometry& geometry)
        : stream_(place, geometry.format), variable_(variable), geometry_(geometry)
    {
    }

    std::vector<std::vector<float>> read()
    {
        for (const EnSightPart& part : geometry_.parts)
            all_.emplace_back((variable_.onPoints ? part.pointCount() : part.cells()) * components(), kMissing);
        if (stream_.line() == "BEGIN TIME STEP")
            stream_.fail("the file holds several steps", "a file for each step ('*' in its name), or a file set");
        for (std::string word = stream_.keyword(); !word.empty();) {
            if (word != "part") stream_.fail(fmt::format("found '{}'", word), "'part'");
            word = readPart();
        }
        return std::move(all_);
    }

private:
    std::size_t components() const { return std::size_t(variable_.components); }

    /// Returns the word behind the part.
    std::string readPart()
    {
        const auto number = int(stream_.integer("the number of a part"));
        const auto index = geometry_.indices.find(number);
        if (index == geometry_.indices.end())
            stream_.fail(fmt::format("part {} is not in the geometry", number),
                         "its parts' numbers, in the byte order of the geometry");
        if (!seen_.insert(number).second)
            stream_.fail(fmt::format("part {} comes once more", number), "each part once");
        const EnSightPart& part = geometry_.parts[index->second];
        std::vector<float>& values = all_[index->second];
        std::set<std::string> kinds;
        std::string word = stream_.keyword();
        for (; !word.empty() && word != "part"; word = stream_.keyword()) {
            const std::vector<std::string> words = ensightWords(word);
            if (words.empty()) stream_.fail("found nothing but blanks", "a kind of elements, or 'part'");
            if (!kinds.insert(words[0]).second)
                stream_.fail(fmt::format("part {} has '{}' once more", number, words[0]), "each kind once");
            readSection(part, words, values);
        }
        return word;
    }

    void readSection(const EnSightPart& part, const std::vector<std::string>& words, std::vector<float>& values)
    {
        std::size_t count = part.pointCount(), first = 0;
        bool kept = true;
        if (variable_.onPoints) {
            if (words[0] != (part.block ? "block" : "coordinates"))
                stream_.fail(fmt::format("found '{}'", words[0]), "'coordinates', or 'block' for a part that is one");
        } else {
            const auto section =
                std::ranges::find_if(part.sections, [&](const EnSightSection& s) { return s.name == words[0]; });
            if (section == part.sections.end())
                stream_.fail(fmt::format("part {} has no '{}'", part.number, words[0]), "a kind of its elements");
            count = section->count;
            kept = section->kept;
            for (auto before = part.sections.begin(); before != section; ++before)
                first += before->kept ? before->count : 0;
        }
        const bool partial = words.size() > 1 && words[1] == "partial", undef = words.size() > 1 && words[1] == "undef";
        if (words.size() > 2 || (words.size() == 2 && !partial && !undef))
            stream_.fail(fmt::format("found '{}' behind '{}'", words[1], words[0]), "undef, partial or nothing");
        const float undefined = undef ? stream_.floats(1, "the undefined value").front() : kMissing;
        std::vector<std::int64_t> places;
        if (partial) places = readPlaces(count);
        for (std::size_t c = 0; c < components(); ++c) {
            const std::vector<float> read = stream_.floats(partial ? places.size() : count, variable_.name.c_str());
            if (!kept) continue;
            for (std::size_t i = 0; i < read.size(); ++i) {
                const std::size_t place = partial ? std::size_t(places[i] - 1) : i;
                values[(first + place) * components() + c] = read[i] == undefined ? kMissing : read[i];
            }
        }
    }

    std::vector<std::int64_t> readPlaces(std::size_t count)
    {
        std::vector<std::int64_t> places =
            stream_.integers(stream_.count("the number of values"), "the places of values");
        for (const std::int64_t place : places)
            if (place < 1 || std::size_t(place) > count)
                stream_.fail(fmt::format("a value belongs to {}", place), fmt::format("1 to {}", count));
        return places;
    }

    EnSightStream stream_;
    const EnSightVariable& variable_;
    const EnSightGeometry& geometry_;
    std::vector<std::vector<float>> all_;
    std::set<int> seen_;
};

class EnSightParts : public PartSource {
public:
    EnSightParts(const std::string& path, std::optional<double> time) : case_(readEnSightCase(path)), time_(time)
    {
        times_ = case_.times();
        for (const EnSightVariable& variable : case_.variables)
            arrays_.push_back({variable.name, variable.onPoints, variable.components, NumberType::float32});
    }

    const std::vector<PartInfo>& parts() override
    {
        if (geometry_) return parts_;
        geometry_ = readEnSightGeometry(case_.placeAt(case_.geometry, time_));
        for (const EnSightPart& part : geometry_->parts)
            parts_.push_back(
                {part.name, part.fillsSpace() ? "volume" : "faces", {}, part.fillsSpace() ? 3 : 2, part.cells() > 0});
        return parts_;
    }

    PartMesh read(std::size_t number, const std::vector<std::size_t>& wanted) override
    {
        parts();
        EnSightPart& part = geometry_->parts[number];
        PartMesh mesh;
        mesh.points = pointsOf(part);
        for (EnSightSection& section : part.sections)
            if (section.kept) mesh.cells.push_back(std::move(section.cells));  // A part is read once.
        for (const std::size_t array : wanted) {
            const EnSightVariable& variable = case_.variables[array];
            auto& all = values_[array];
            if (all.empty()) all = ValuesText(case_.placeAt(variable.file, time_), variable, *geometry_).read();
            mesh.values.push_back(std::make_shared<const std::vector<float>>(std::move(all[number])));
        }
        return mesh;
    }

private:
    EnSightCase case_;
    std::optional<double> time_;
    std::optional<EnSightGeometry> geometry_;                        // Once it was asked for.
    std::map<std::size_t, std::vector<std::vector<float>>> values_;  // Of an array: of each part that was not yet read.
};

}  // namespace

std::unique_ptr<PartSource> openEnSightCase(const std::string& path, std::optional<double> time)
{
    return std::make_unique<EnSightParts>(path, time);
}

}  // namespace aeolic
