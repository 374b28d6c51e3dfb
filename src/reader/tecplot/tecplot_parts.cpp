#include "reader/parts/open_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "aeolic/error.h"
#include "base/text.h"
#include "data/vector_names.h"
#include "reader/tecplot/tecplot_text.h"

namespace aeolic {
namespace {

/// Whether a variable is the coordinate of an axis: "x", "X [m]", "CoordinateX", "X Coordinate".
bool isCoordinate(std::string name, char axis)
{
    name = lowerCase(std::move(name));
    while (!name.empty() && name.back() == ' ') name.pop_back();
    const std::string letter(1, axis);
    return name == letter || name == "coordinate" + letter || name == letter + " coordinate" ||
           name == letter + "-coordinate" ||
           (name.size() > 1 && name[0] == axis && (name[1] == '(' || name[1] == '[')) ||
           (name.size() > 2 && name[0] == axis && name[1] == ' ' && (name[2] == '(' || name[2] == '['));
}

/// "x, y, p", or the first of many.
std::string firstOf(const std::vector<std::string>& names)
{
    constexpr std::size_t kShown = 10, kLongestShown = 40;
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), kShown); ++i)
        text += (i > 0 ? ", " : "") + names[i].substr(0, kLongestShown);
    return names.size() > kShown ? fmt::format("{} and {} more", text, names.size() - kShown) : text;
}

/// A ring of corners without those that are the same as the one before.
std::vector<std::int64_t> withoutRepeats(const std::int64_t* ring, std::size_t count)
{
    std::vector<std::int64_t> corners;
    for (std::size_t i = 0; i < count; ++i)
        if (ring[i] != ring[(i + count - 1) % count]) corners.push_back(ring[i]);
    return corners;
}

/// Bricks whose corners come twice are simpler cells, wherever in a ring that is.
void addBrick(const std::int64_t* c, std::vector<PartCells>& cells)
{
    CellShape shape = CellShape::hexahedron;
    std::vector<std::int64_t> corners(c, c + 8);
    const std::vector<std::int64_t> lower = withoutRepeats(c, 4), upper = withoutRepeats(c + 4, 4);
    const bool apex = c[4] == c[5] && c[5] == c[6] && c[6] == c[7];
    bool alike = true;  // The same corners of both rings are repeated.
    for (std::size_t i = 0; i < 4; ++i) alike = alike && (c[i] == c[(i + 3) % 4]) == (c[4 + i] == c[4 + (i + 3) % 4]);
    if (apex && lower.size() >= 3) {
        shape = lower.size() == 3 ? CellShape::tetra : CellShape::pyramid;
        corners = lower;
        corners.push_back(c[4]);
    } else if (lower.size() == 3 && upper.size() == 3 && alike) {
        shape = CellShape::wedge;
        corners = lower;
        corners.insert(corners.end(), upper.begin(), upper.end());
    }
    if (cells.empty() || cells.back().shape != shape) cells.push_back({shape, 0, {}, {}, {}});
    cells.back().corners.insert(cells.back().corners.end(), corners.begin(), corners.end());
    ++cells.back().count;
}

class TecplotParts : public PartSource {
public:
    TecplotParts(const std::string& path, std::optional<double> time) : text_(path)
    {
        const auto& variables = text_.variables();
        for (std::size_t v = 0; v < variables.size(); ++v)
            for (int c = 0; c < 3; ++c)
                if (!axes_[c] && isCoordinate(variables[v], "xyz"[c])) axes_[c] = v;
        const auto missing = std::count(std::begin(axes_), std::end(axes_), std::nullopt);
        if (missing > 1)
            throw InputError(path, "it has not two variables called x, y or z: " + firstOf(variables),
                             "variables x, y and z, of flat data two of them");
        if (missing == 1)
            across_ = std::size_t(std::find(std::begin(axes_), std::end(axes_), std::nullopt) - std::begin(axes_));
        std::set<double> times;
        for (const TecplotZone& zone : text_.zones())
            if (zone.strand > 0) times.insert(zone.time);
        if (times.size() > 1) times_.assign(times.begin(), times.end());
        findParts(time.value_or(times_.empty() ? 0 : times_.front()));
        addArrays();
    }

    PartMesh read(std::size_t number, const std::vector<std::size_t>& wanted) override
    {
        const std::size_t at = zones_[number];
        const TecplotZone& zone = text_.zones()[at];
        std::vector<std::size_t> columns;
        std::map<std::size_t, std::size_t> places;  // Of a variable among the columns.
        const auto want = [&](std::size_t variable) {
            if (places.emplace(variable, columns.size()).second) columns.push_back(variable);
        };
        for (const auto& axis : axes_)
            if (axis) want(*axis);
        for (const std::size_t array : wanted)
            for (const std::size_t variable : of_[array])
                if (zone.inCells[variable] != arrays_[array].onPoints) want(variable);
        const auto values = text_.read(at, columns);
        PartMesh mesh;
        auto points = std::make_shared<std::vector<glm::dvec3>>(std::size_t(zone.points()));
        for (int c = 0; c < 3; ++c) {
            if (!axes_[c]) continue;
            const auto& axis = values[places[*axes_[c]]];
            if (axis.size() != points->size())
                text_.fail(zone, fmt::format("it has {} coordinates in {}", axis.size(), "xyz"[c]),
                           fmt::format("{}", points->size()));
            for (std::size_t i = 0; i < axis.size(); ++i) (*points)[i][c] = axis[i];
        }
        mesh.points = points;
        mesh.cells = cellsOf(at, points->size());
        for (const std::size_t array : wanted) {
            auto joined = std::make_shared<std::vector<float>>();
            const std::size_t width = arrays_[array].components == 3 ? 3 : 1;
            for (std::size_t c = 0; c < of_[array].size(); ++c) {
                const auto place = places.find(of_[array][c]);
                const bool own = place != places.end() && zone.inCells[of_[array][c]] != arrays_[array].onPoints;
                if (!own || values[place->second].empty()) continue;
                const auto& column = values[place->second];
                const std::size_t axis = axisOfComponent(c, of_[array].size(), across_);
                if (joined->empty()) joined->assign(column.size() * width, of_[array].size() == 2 ? 0 : kMissing);
                for (std::size_t i = 0; i < column.size(); ++i) (*joined)[i * width + axis] = float(column[i]);
            }
            mesh.values.push_back(joined->empty() ? nullptr : joined);
        }
        return mesh;
    }

private:
    /// Zones that stay, and of each strand those that hold at the time: it may have several at every time.
    void findParts(double time)
    {
        std::map<std::pair<std::int64_t, double>, std::size_t> found;         // Of a strand, at a time.
        std::map<std::pair<std::int64_t, std::size_t>, std::size_t> strands;  // Where each stands among the parts.
        const auto& zones = text_.zones();
        for (std::size_t i = 0; i < zones.size(); ++i) {
            const TecplotZone& zone = zones[i];
            if (zone.dimension() < 2) continue;
            if (zone.strand > 0) {
                const std::size_t number = found[{zone.strand, zone.time}]++;
                const auto [known, first] = strands.emplace(std::pair(zone.strand, number), zones_.size());
                if (!first) {
                    const TecplotZone& shown = zones[zones_[known->second]];
                    const bool later = zone.time <= time && (shown.time > time || zone.time > shown.time);
                    if (later || (shown.time > time && zone.time < shown.time)) zones_[known->second] = i;
                    continue;
                }
            }
            zones_.push_back(i);
            parts_.push_back({zone.name, "", {}});
        }
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            parts_[i].dimension = zones[zones_[i]].dimension();
            parts_[i].type = parts_[i].dimension == 3 ? "volume" : "faces";
        }
        if (parts_.empty())
            text_.fail(zones.front(), "neither it nor any other zone is faces or fills space", "such a zone");
    }

    void addArrays()
    {
        const auto& variables = text_.variables();
        for (const bool onPoints : {true, false}) {
            std::vector<std::string> names;
            std::vector<std::size_t> numbers;
            for (std::size_t v = 0; v < variables.size(); ++v) {
                if (std::ranges::find(axes_, std::optional(v)) != std::end(axes_)) continue;
                const bool any = std::ranges::any_of(zones_, [&](std::size_t zone) {
                    return text_.zones()[zone].inCells[v] != onPoints && !text_.zones()[zone].passive[v];
                });
                const bool known = std::ranges::find(names, variables[v]) != names.end();
                if (!any || known) continue;
                names.push_back(variables[v]);
                numbers.push_back(v);
            }
            for (const NamedComponents& each :
                 joinComponents(names, across_ < 3, false, std::min<std::size_t>(across_, 2))) {
                arrays_.push_back({each.name, onPoints, each.of.size() > 1 ? 3 : 1, NumberType::float64});
                std::vector<std::size_t> of;
                for (const std::size_t component : each.of) of.push_back(numbers[component]);
                of_.push_back(std::move(of));
            }
        }
    }

    std::vector<PartCells> cellsOf(std::size_t number, std::size_t points) const
    {
        const TecplotZone& zone = text_.zones()[number];
        if (zone.cells == TecplotCells::ordered) return {orderedCells(zone.lengths)};
        std::vector<std::int64_t> corners = text_.corners(number);
        for (std::int64_t& corner : corners) {
            if (corner < 1 || std::uint64_t(corner) > points)
                text_.fail(zone, fmt::format("an element has the corner {}", corner), fmt::format("1 to {}", points));
            --corner;
        }
        const auto count = std::size_t(zone.elements);
        if (zone.cells == TecplotCells::triangles) return {{CellShape::triangle, count, std::move(corners), {}, {}}};
        if (zone.cells == TecplotCells::tetrahedra) return {{CellShape::tetra, count, std::move(corners), {}, {}}};
        std::vector<PartCells> cells;
        if (zone.cells == TecplotCells::bricks) {
            for (std::size_t i = 0; i < count; ++i) addBrick(corners.data() + 8 * i, cells);
            return cells;
        }
        // A corner of a triangle comes twice.
        PartCells polygons{CellShape::polygon, count, {}, {}, {}};
        for (std::size_t i = 0; i < count; ++i) {
            const std::int64_t* c = corners.data() + 4 * i;
            std::vector<std::int64_t> ring = withoutRepeats(c, 4);
            if (ring.size() < 3) ring.assign(c, c + 3);  // Without an area, which is counted later.
            polygons.sizes.push_back(std::int64_t(ring.size()));
            polygons.corners.insert(polygons.corners.end(), ring.begin(), ring.end());
        }
        return {std::move(polygons)};
    }

    TecplotText text_;
    std::optional<std::size_t> axes_[3];        // The variables that are coordinates.
    std::size_t across_ = 3;                    // The axis that flat data lie across; 3: they are not flat.
    std::vector<std::size_t> zones_;            // Of each part.
    std::vector<std::vector<std::size_t>> of_;  // Of each array: the variables that it is made of.
};

}  // namespace

std::unique_ptr<PartSource> openTecplotFile(const std::string& path, std::optional<double> time)
{
    return std::make_unique<TecplotParts>(path, time);
}

}  // namespace aeolic
