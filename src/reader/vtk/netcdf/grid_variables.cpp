#include "reader/vtk/netcdf/grid_variables.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <sstream>
#include <string_view>

#include "base/text.h"

namespace aeolic {
namespace {

std::string attribute(const NetcdfFile& file, const std::string& variable, const char* name)
{
    return file.text(variable, name).value_or("");
}

bool isAngleTowards(const std::string& units, char letter, std::string_view word)
{
    std::string_view rest = units;
    if (!rest.starts_with("degree")) return false;
    rest.remove_prefix(6);
    if (rest.starts_with('s')) rest.remove_prefix(1);
    if (rest.starts_with('_')) rest.remove_prefix(1);
    return rest == word || (rest.size() == 1 && rest[0] == letter);
}

bool isTimeName(const std::string& dimension)
{
    const std::string name = lowerCase(dimension);
    return name == "t" || name == "time" || name == "time_counter" || name == "ocean_time" || name == "record";
}

bool isTimeDimension(const NetcdfFile& file, const std::string& dimension)
{
    return isTimeName(dimension) || (file.has(dimension) && coordinateKindOf(file, dimension) == CoordinateKind::time);
}

/// The dimensions along which places of any kind stand in a row: meshes without a grid have them.
std::set<std::string> rowsOfPlaces(const NetcdfFile& file)
{
    std::map<std::string, int> found;
    for (const std::string& name : file.variables()) {
        const auto& dimensions = file.dimensions(name);
        if (dimensions.size() != 1 || dimensions[0] == name) continue;
        const CoordinateKind kind = coordinateKindOf(file, name);
        if (kind == CoordinateKind::x) found[dimensions[0]] |= 1;
        if (kind == CoordinateKind::y) found[dimensions[0]] |= 2;
    }
    std::set<std::string> rows;
    for (const auto& [dimension, kinds] : found)
        if (kinds == 3) rows.insert(dimension);
    return rows;
}

/// Variables that say where others are.
std::set<std::string> coordinatesIn(const NetcdfFile& file)
{
    std::set<std::string> all;
    for (const std::string& name : file.variables()) {
        for (const char* key : {"coordinates", "bounds"}) {
            std::istringstream words(attribute(file, name, key));
            for (std::string word; words >> word;) all.insert(word);
        }
        const CoordinateKind kind = coordinateKindOf(file, name);
        if (kind == CoordinateKind::x || kind == CoordinateKind::y || kind == CoordinateKind::time) all.insert(name);
    }
    return all;
}

/// Nothing where the variable does not stand on a grid.
std::optional<GridVariable> onGrid(const NetcdfFile& file, const std::string& name, const std::set<std::string>& rows)
{
    const std::vector<std::string>& dimensions = file.dimensions(name);
    const std::vector<std::uint64_t> lengths = file.shape(name);
    GridVariable variable{name, {}, {}, {}};
    std::vector<std::size_t> at;
    for (std::size_t k = 0; k < dimensions.size(); ++k) {
        if (!variable.time && isTimeDimension(file, dimensions[k]))
            variable.time = k;
        else
            at.push_back(k);
        if (rows.contains(dimensions[k]) || lengths[k] == 0) return std::nullopt;
    }
    while (at.size() > 3 && lengths[at.front()] == 1) at.erase(at.begin());
    if (at.size() > 3 && !variable.time) {  // Such as months, of which no unit tells.
        variable.time = at.front();
        at.erase(at.begin());
    }
    if (at.size() < 2 || at.size() > 3) return std::nullopt;

    const auto rankOf = [&](std::size_t k) {
        const auto kind = file.has(dimensions[k]) ? coordinateKindOf(file, dimensions[k]) : CoordinateKind::none;
        return kind == CoordinateKind::x ? 2 : kind == CoordinateKind::y ? 1 : 0;
    };
    const int ranks = std::accumulate(at.begin(), at.end(), 0, [&](int sum, std::size_t k) { return sum + rankOf(k); });
    if (ranks == 3)  // Else the usual order.
        std::stable_sort(at.begin(), at.end(), [&](std::size_t a, std::size_t b) { return rankOf(a) < rankOf(b); });
    if (lengths[at[at.size() - 1]] < 2 || lengths[at[at.size() - 2]] < 2) return std::nullopt;
    for (const std::size_t k : at) variable.axes.push_back(dimensions[k]);
    variable.at = at;
    return variable;
}

/// The name of the component after that of `name`, where there is one: "v10" of "u10", "wind_y" of "wind_x". `letters`
/// are those of the axes.
std::string withLetter(const std::string& name, std::size_t at, char letter)
{
    std::string other = name;
    other[at] = letter;
    return other;
}

class VectorSearch {
public:
    VectorSearch(const NetcdfFile& file, GridVariables& all) : file_(file), all_(all) {}

    void run()
    {
        for (std::size_t u = 0; u < all_.variables.size(); ++u) byLetters(u);
        for (std::size_t u = 0; u < all_.variables.size(); ++u) byStandardName(u);
    }

private:
    void byLetters(std::size_t u)
    {
        const std::string& name = all_.variables[u].name;
        for (const std::string_view letters : {"uvw", "UVW", "xyz", "XYZ"})
            for (std::size_t at = 0; at < name.size(); ++at) {
                const bool anywhere = lowerCase(std::string(letters)) == "uvw";
                if (name[at] != letters[0] || (!anywhere && at != 0 && at + 1 != name.size())) continue;
                const auto v = find(withLetter(name, at, letters[1]));
                if (!v || !add(u, *v, name.substr(0, at) + std::string(letters.substr(0, 2)) + name.substr(at + 1)))
                    continue;
                GridVector& made = all_.vectors.back();
                const auto w = find(withLetter(name, at, letters[2]));
                const auto x = coordinateOf(file_, made.axes.back(), CoordinateKind::x);
                // Of a map the third component has another unit than the places.
                if (w && made.axes.size() == 3 && !(x && isInDegrees(file_, *x)) &&
                    isStaggered(file_, all_.variables[*w].axes, made.axes)) {
                    made.of.push_back(*w);
                    made.name.insert(at + 2, 1, letters[2]);
                }
                return;
            }
    }

    void byStandardName(std::size_t u)
    {
        std::string name = attribute(file_, all_.variables[u].name, "standard_name"), rest;
        for (const auto& [x, y] :
             {std::pair<std::string_view, std::string_view>{"eastward_", "northward_"}, {"x_", "y_"}}) {
            std::size_t at = name.starts_with(x) ? 0 : name.find("_" + std::string(x));
            if (at == std::string::npos) continue;
            if (at > 0) ++at;
            rest = name;
            rest.erase(at, x.size());
            name.replace(at, x.size(), y);
            break;
        }
        if (rest.empty() || used_.contains(u)) return;
        std::optional<std::size_t> v;
        for (std::size_t i = 0; i < all_.variables.size(); ++i)
            if (!used_.contains(i) && attribute(file_, all_.variables[i].name, "standard_name") == name) {
                if (v) return;
                v = i;
            }
        if (v) add(u, *v, rest);
    }

    std::optional<std::size_t> find(const std::string& name) const
    {
        for (std::size_t i = 0; i < all_.variables.size(); ++i)
            if (all_.variables[i].name == name) return i;
        return std::nullopt;
    }

    bool add(std::size_t u, std::size_t v, std::string name)
    {
        const GridAxes &across = all_.variables[u].axes, &up = all_.variables[v].axes;
        if (used_.contains(u) || used_.contains(v) || across.size() != up.size()) return false;
        GridAxes axes = across;  // Of a C grid the first component stands on the second's columns, and so on.
        axes.back() = up.back();
        if (!isStaggered(file_, across, axes) || !isStaggered(file_, up, axes)) return false;
        while (file_.has(name)) name += "XYZ";
        const bool isEastward =
            attribute(file_, all_.variables[u].name, "standard_name").find("eastward") != std::string::npos;
        all_.vectors.push_back({std::move(name), {u, v}, std::move(axes), isEastward});
        used_.insert({u, v});
        return true;
    }

    const NetcdfFile& file_;
    GridVariables& all_;
    std::set<std::size_t> used_;
};

std::vector<double> timesOf(const NetcdfFile& file, const std::string& dimension, std::uint64_t length)
{
    std::vector<double> times;
    if (const auto name = coordinateOf(file, dimension, CoordinateKind::time)) times = file.read<double>(*name);
    bool increase = times.size() == length;
    for (std::size_t i = 0; i < times.size(); ++i)
        increase = increase && std::isfinite(times[i]) && (i == 0 || times[i] > times[i - 1]);
    if (increase) return times;
    times.resize(length);
    std::iota(times.begin(), times.end(), 0.0);
    return times;
}

}  // namespace

CoordinateKind coordinateKindOf(const NetcdfFile& file, const std::string& variable)
{
    const std::string units = lowerCase(attribute(file, variable, "units")), axis = attribute(file, variable, "axis"),
                      name = attribute(file, variable, "standard_name");
    if (units.find(" since ") != std::string::npos || axis == "T" || name == "time") return CoordinateKind::time;
    if (isAngleTowards(units, 'e', "east") || axis == "X" || name == "longitude" || name == "grid_longitude" ||
        name == "projection_x_coordinate")
        return CoordinateKind::x;
    if (isAngleTowards(units, 'n', "north") || axis == "Y" || name == "latitude" || name == "grid_latitude" ||
        name == "projection_y_coordinate")
        return CoordinateKind::y;
    const bool isRow = file.dimensions(variable).size() == 1;  // Fluxes may be positive downwards, too.
    if (axis == "Z" || (isRow && file.text(variable, "positive"))) return CoordinateKind::z;
    return CoordinateKind::none;
}

bool isInDegrees(const NetcdfFile& file, const std::string& variable)
{
    return attribute(file, variable, "units").starts_with("degree");
}

std::optional<std::string> coordinateOf(const NetcdfFile& file, const std::string& dimension, CoordinateKind kind)
{
    const auto isRow = [&](const std::string& name) {
        return file.type(name) && file.dimensions(name) == std::vector<std::string>{dimension};
    };
    if (file.has(dimension) && isRow(dimension)) return dimension;
    std::optional<std::string> found;
    for (const std::string& name : file.variables()) {
        if (!isRow(name) || coordinateKindOf(file, name) != kind) continue;
        if (found) return std::nullopt;
        found = name;
    }
    return found;
}

bool isStaggered(const NetcdfFile& file, const GridAxes& from, const GridAxes& to)
{
    if (from.size() != to.size()) return false;
    for (std::size_t k = 0; k < from.size(); ++k) {
        const std::uint64_t a = file.dimension(from[k]).value_or(0), b = file.dimension(to[k]).value_or(0);
        if (from[k] != to[k] && (a > b + 1 || b > a + 1)) return false;
    }
    return true;
}

GridVariables gridVariablesOf(const NetcdfFile& file)
{
    GridVariables all;
    const std::set<std::string> rows = rowsOfPlaces(file), coordinates = coordinatesIn(file);
    for (const std::string& name : file.variables()) {
        if (!file.type(name) || coordinates.contains(name)) continue;
        auto variable = onGrid(file, name, rows);
        if (!variable) continue;
        if (variable->time) {
            const std::string& dimension = file.dimensions(name)[*variable->time];
            if (!all.times.contains(dimension))
                all.times[dimension] = timesOf(file, dimension, file.shape(name)[*variable->time]);
        }
        all.variables.push_back(std::move(*variable));
    }
    if (all.variables.empty())
        file.fail(rows.empty() ? "it has no variable on a grid"
                               : "its values stand on a mesh without a grid, along '" + *rows.begin() + "'",
                  "variables over latitude and longitude, or x and y (CF conventions)");
    VectorSearch(file, all).run();
    return all;
}

}  // namespace aeolic
