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

/// Members of an ensemble, of which the first is read.
bool isEnsemble(const NetcdfFile& file, const std::string& dimension)
{
    constexpr std::string_view names[] = {"number", "realization", "member", "ensemble", "ens", "expver"};
    const std::string name = lowerCase(dimension);
    return std::ranges::find(names, name) != std::end(names) ||
           (file.has(dimension) && attribute(file, dimension, "standard_name") == "realization");
}

/// The dimensions along which places of any kind stand in a row: meshes without a grid have them.
std::set<std::string> rowsOfPlaces(const NetcdfFile& file)
{
    std::map<std::string, int> found;
    for (const std::string& name : file.variables()) {
        const auto& dimensions = file.dimensions(name);
        if (dimensions.size() != 1 || dimensions[0] == name) continue;
        const CoordinateKind kind = coordinateKindOf(file, name);
        const bool isAngle = attribute(file, name, "units").starts_with("rad");
        if (kind == CoordinateKind::x || (isAngle && name.starts_with("lon"))) found[dimensions[0]] |= 1;
        if (kind == CoordinateKind::y || (isAngle && name.starts_with("lat"))) found[dimensions[0]] |= 2;
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
    if (lengths.size() != dimensions.size()) return std::nullopt;
    GridVariable variable{name, {}, {}, {}};
    std::vector<std::size_t> at;
    for (std::size_t k = 0; k < dimensions.size(); ++k) {
        if (lengths[k] == 0) return std::nullopt;
        if (isTimeDimension(file, dimensions[k]))
            variable.time = k;  // Of a run's beginning and its times the latter, which come behind it.
        else if (!isEnsemble(file, dimensions[k]))
            at.push_back(k);
    }
    if (std::ranges::any_of(at, [&](std::size_t k) { return rows.contains(dimensions[k]); })) return std::nullopt;
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
    if (ranks == 3)  // Where nothing tells them, the dimensions are in the usual order.
        std::ranges::stable_sort(at, [&](std::size_t a, std::size_t b) { return rankOf(a) < rankOf(b); });
    if (lengths[at[at.size() - 1]] < 2 || lengths[at[at.size() - 2]] < 2) return std::nullopt;
    for (const std::size_t k : at) variable.axes.push_back(dimensions[k]);
    variable.at = at;
    return variable;
}

/// A name with another letter at one place: "v10" of "u10", "wind_y" of "wind_x".
std::string withLetter(const std::string& name, std::size_t at, char letter)
{
    std::string other = name;
    other[at] = letter;
    return other;
}

/// Whether the unit is that of a velocity, a flux or a stress.
bool isOfFlow(const std::string& units)
{
    constexpr std::string_view parts[] = {"s-1", "s**-1", "s^-1", "s^{-1}",  "/s",  "second",
                                          "Pa",  "N m-2", "N/m",  "N m**-2", "knot"};
    return std::ranges::any_of(parts, [&](std::string_view part) { return units.find(part) != std::string::npos; });
}

/// Two names that differ in the letter of an axis may be those of anything: of masks, of factors, of nitrogen oxides.
bool mayBeFlow(const NetcdfFile& file, const std::string& u, const std::string& v)
{
    const std::string units = attribute(file, u, "units");
    if (units != attribute(file, v, "units")) return false;
    return units.empty() ? lowerCase(u).find("mask") == std::string::npos : isOfFlow(units);
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
                if (!v || !mayBeFlow(file_, name, all_.variables[*v].name) ||
                    !add(u, *v, name.substr(0, at) + std::string(letters.substr(0, 2)) + name.substr(at + 1)))
                    continue;
                GridVector& made = all_.vectors.back();
                const auto w = find(withLetter(name, at, letters[2]));
                // On a map a third component has another unit than the places, so vectors have two.
                if (w && made.axes.size() == 3 && !isMap(made.axes, name) &&
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

    bool isMap(const GridAxes& axes, const std::string& of) const
    {
        const auto plane = planeOf(file_, axes, of);
        const auto x = coordinateOf(file_, axes.back(), CoordinateKind::x);
        return (plane && isInDegrees(file_, plane->x)) || (x && isInDegrees(file_, *x));
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
        // On a C grid the first component is shifted along x alone, and the second along y alone.
        GridAxes axes = across;
        axes.back() = up.back();
        if (!isStaggered(file_, across, axes) || !isStaggered(file_, up, axes)) return false;
        while (file_.has(name)) name += "XYZ";
        const std::string& first = all_.variables[u].name;
        const std::string standard = attribute(file_, first, "standard_name");
        const bool isRelative = file_.numbers(first, "GRIB_uvRelativeToGrid") == std::vector<double>{1};
        const bool isEastward = standard.find("eastward") != std::string::npos && !standard.starts_with("grid_");
        all_.vectors.push_back({std::move(name),
                                {u, v},
                                std::move(axes),
                                isEastward && !isRelative,
                                isOfFlow(attribute(file_, first, "units"))});
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

std::optional<PlaneNames> planeOf(const NetcdfFile& file, const GridAxes& axes, const std::string& of)
{
    const std::string named = " " + attribute(file, of, "coordinates") + " ";
    const auto fits = [&](const std::string& name, int pass) {
        const GridAxes& own = file.dimensions(name);
        if (own.size() < 2 || !file.type(name)) return false;
        if (pass == 0 && named.find(" " + name + " ") == std::string::npos) return false;
        for (std::size_t k = 1; k <= 2; ++k) {
            const std::string &a = own[own.size() - k], &b = axes[axes.size() - k];
            if (a != b && (pass < 2 || file.dimension(a) != file.dimension(b))) return false;
        }
        return true;
    };
    for (const int pass : {0, 1, 2})
        for (const std::string& x : file.variables()) {
            if (!fits(x, pass) || coordinateKindOf(file, x) != CoordinateKind::x) continue;
            for (const std::string& y : file.variables())
                if (fits(y, pass) && coordinateKindOf(file, y) == CoordinateKind::y &&
                    file.dimensions(y) == file.dimensions(x))
                    return PlaneNames{x, y, pass == 0};
        }
    return std::nullopt;
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
    const auto isEmptyTime = [&](const std::string& name) {
        const std::vector<std::string>& dimensions = file.dimensions(name);
        return std::ranges::any_of(dimensions, [&](const std::string& dimension) {
            return isTimeDimension(file, dimension) && file.dimension(dimension).value_or(1) == 0;
        });
    };
    const std::vector<std::string> names = file.variables();
    if (all.variables.empty() && std::ranges::any_of(names, isEmptyTime)) file.fail("it has no step of time", "one");
    if (all.variables.empty())
        file.fail(rows.empty() ? "it has no variable on a grid"
                               : "its values stand on a mesh without a grid, along '" + *rows.begin() + "'",
                  "variables over latitude and longitude, or x and y (CF conventions)");
    VectorSearch(file, all).run();
    return all;
}

}  // namespace aeolic
