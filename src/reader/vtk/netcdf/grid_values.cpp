#include "reader/vtk/netcdf/grid_values.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "reader/parts/part_source.h"

namespace aeolic {
namespace {

/// Values beyond this were never written: the library fills such places with 9.97e36.
constexpr double kNeverWritten = 9.9e36;
/// The cosine of the latitude counts as this at least. At the poles, where it is 0, no direction is east.
constexpr double kLowestCosine = 1e-3;

double onlyNumber(const NetcdfFile& file, const std::string& variable, const char* attribute, double otherwise)
{
    const auto numbers = file.numbers(variable, attribute);
    return numbers && numbers->size() == 1 ? numbers->front() : otherwise;
}

/// What a packed value means.
class Packing {
public:
    Packing(const NetcdfFile& file, const std::string& variable)
        : scale_(onlyNumber(file, variable, "scale_factor", 1)),
          offset_(onlyNumber(file, variable, "add_offset", 0)),
          lo_(onlyNumber(file, variable, "valid_min", -kNeverWritten)),
          hi_(onlyNumber(file, variable, "valid_max", kNeverWritten))
    {
        if (file.text(variable, "_Unsigned") == "true") wrap_ = wrapOf(file.type(variable));
        for (const char* attribute : {"_FillValue", "missing_value"})
            if (const auto numbers = file.numbers(variable, attribute))
                missing_.insert(missing_.end(), numbers->begin(), numbers->end());
        const auto range = file.numbers(variable, "valid_range");
        if (range && range->size() == 2) {
            lo_ = (*range)[0];
            hi_ = (*range)[1];
        }
    }

    template <class Number>
    float operator()(Number packed) const
    {
        for (const double missing : missing_)
            if (packed == Number(missing)) return kMissing;
        double value(packed);
        if (value < 0) value += wrap_;
        return value >= lo_ && value <= hi_ ? float(value * scale_ + offset_) : kMissing;
    }

private:
    /// What a negative number of the type lacks to the one without a sign that it stands for.
    static double wrapOf(std::optional<NumberType> type)
    {
        return type == NumberType::int8    ? 256.0
               : type == NumberType::int16 ? 65536.0
               : type == NumberType::int32 ? 4294967296.0
                                           : 0;
    }

    double scale_, offset_, lo_, hi_, wrap_ = 0;
    std::vector<double> missing_;
};

template <class Number>
std::vector<float> unpack(const NetcdfFile& file, const std::string& variable, const Slab& slab)
{
    std::vector<Number> packed = file.read<Number>(variable, slab);
    const Packing value(file, variable);
    if constexpr (std::is_same_v<Number, float>) {
        std::transform(packed.begin(), packed.end(), packed.begin(), value);
        return packed;
    } else {
        std::vector<float> values(packed.size());
        std::transform(packed.begin(), packed.end(), values.begin(), value);
        return values;
    }
}

/// Values in three dimensions, x fastest.
struct Block {
    std::array<std::size_t, 3> size{1, 1, 1};  // How many values it has along x, y and z.
    std::vector<float> values;

    std::size_t stride(std::size_t c) const { return c == 0 ? 1 : c == 1 ? size[0] : size[0] * size[1]; }
};

/// The variable as it is, with its axes in the usual order.
Block readBlock(const NetcdfFile& file, const GridVariable& variable, std::size_t step)
{
    const std::vector<std::uint64_t> shape = file.shape(variable.name);
    Slab slab{std::vector<std::uint64_t>(shape.size(), 0), std::vector<std::uint64_t>(shape.size(), 1)};
    if (variable.time) {
        if (shape[*variable.time] == 0) file.fail("'" + variable.name + "' has no step of time", "one");
        slab.first[*variable.time] = std::min<std::uint64_t>(step, shape[*variable.time] - 1);
    }
    Block block;
    const std::size_t rank = variable.at.size();
    for (std::size_t k = 0; k < rank; ++k)
        block.size[rank - 1 - k] = slab.count[variable.at[k]] = shape[variable.at[k]];
    block.values = unpackedValues(file, variable.name, slab);
    if (std::ranges::is_sorted(variable.at)) return block;

    std::vector<std::size_t> strides(shape.size(), 1);  // Of the slab, in elements.
    for (std::size_t k = shape.size() - 1; k-- > 0;) strides[k] = strides[k + 1] * std::size_t(slab.count[k + 1]);
    const auto strideOf = [&](std::size_t c) { return c < rank ? strides[variable.at[rank - 1 - c]] : 0; };
    std::vector<float> sorted(block.values.size());
    std::size_t to = 0;
    for (std::size_t z = 0; z < block.size[2]; ++z)
        for (std::size_t y = 0; y < block.size[1]; ++y)
            for (std::size_t x = 0; x < block.size[0]; ++x)
                sorted[to++] = block.values[x * strideOf(0) + y * strideOf(1) + z * strideOf(2)];
    block.values = std::move(sorted);
    return block;
}

/// Which neighbours along an axis the point at `i` of the grid lies between: `i + before` and the next one. Nothing
/// where it is not told that they are other points.
std::optional<int> neighbourBefore(const NetcdfFile& file, const std::string& from, const std::string& to,
                                   CoordinateKind kind)
{
    const std::uint64_t there = file.dimension(from).value_or(0), here = file.dimension(to).value_or(0);
    if (there != here) return there > here ? 0 : -1;
    const auto a = coordinateOf(file, from, kind), b = coordinateOf(file, to, kind);
    if (!a || !b || here < 2) return std::nullopt;
    constexpr double kSame = 0.1;  // Points that are apart by less than this share of a step are the same.
    const Slab two{{0}, {2}};
    const std::vector<double> others = file.read<double>(*a, two), own = file.read<double>(*b, two);
    const double step = own[1] - own[0];
    double apart = others[0] - own[0];
    if (kind == CoordinateKind::x && isInDegrees(file, *b)) apart -= 360 * std::round(apart / 360);
    if (apart == 0) apart = onlyNumber(file, *a, "c_grid_axis_shift", 0) * step;  // Of xgcm, whose places are indices.
    if (!(std::abs(apart) >= kSame * std::abs(step))) return std::nullopt;
    return (apart < 0) == (step > 0) ? 0 : -1;
}

/// The means of two neighbours along an axis.
Block averaged(const Block& block, std::size_t c, std::size_t size, int before)
{
    Block result;
    result.size = block.size;
    result.size[c] = size;
    result.values.resize(result.size[0] * result.size[1] * result.size[2]);
    std::size_t to = 0;
    std::array<std::size_t, 3> at{};
    for (at[2] = 0; at[2] < result.size[2]; ++at[2])
        for (at[1] = 0; at[1] < result.size[1]; ++at[1])
            for (at[0] = 0; at[0] < result.size[0]; ++at[0]) {
                const auto first = std::ptrdiff_t(at[c]) + before;
                const bool isBetween = first >= 0 && std::size_t(first) + 1 < block.size[c];
                std::array<std::size_t, 3> source = at;
                source[c] = isBetween ? std::size_t(first) : 0;
                const std::size_t a = source[0] + source[1] * block.stride(1) + source[2] * block.stride(2);
                result.values[to++] =
                    isBetween ? 0.5f * (block.values[a] + block.values[a + block.stride(c)]) : kMissing;
            }
    return result;
}

void turn(Block& block, std::size_t c)
{
    const std::size_t stride = block.stride(c), length = stride * block.size[c];
    for (std::size_t begin = 0; begin < block.values.size(); begin += length)
        for (std::size_t lo = 0, hi = block.size[c] - 1; lo < hi; ++lo, --hi)
            std::swap_ranges(block.values.begin() + std::ptrdiff_t(begin + lo * stride),
                             block.values.begin() + std::ptrdiff_t(begin + (lo + 1) * stride),
                             block.values.begin() + std::ptrdiff_t(begin + hi * stride));
}

/// Directions at a point, in the plane of the map.
struct Frame {
    double ux = 1, uy = 0, vx = 0, vy = 1;  // Where the first component points, and the second.
};

/// Where the lines of a curvilinear grid run, with lengths along the equator for longitudes.
Frame frameAt(const GridPlaces& places, std::size_t row, std::size_t column, double cosine)
{
    const auto towards = [&](std::size_t r0, std::size_t c0, std::size_t r1, std::size_t c1, double& x, double& y) {
        const double dx = (places.xAt(r1, c1) - places.xAt(r0, c0)) * cosine,
                     dy = places.yAt(r1, c1) - places.yAt(r0, c0);
        const double length = std::hypot(dx, dy);
        if (!(length > 0)) return;  // Also where a place is missing.
        x = dx / length;
        y = dy / length;
    };
    Frame frame;
    const std::size_t left = column > 0 ? column - 1 : 0, below = row > 0 ? row - 1 : 0;
    towards(row, left, row, std::min(column + 1, places.columns() - 1), frame.ux, frame.uy);
    towards(below, column, std::min(row + 1, places.rows() - 1), column, frame.vx, frame.vy);
    return frame;
}

/// Turns the vector to where it points on the map.
void toMap(float* vector, const GridPlaces& places, std::size_t row, std::size_t column, bool isEastward)
{
    const double u = vector[0], v = vector[1];
    const double latitude = places.yAt(row, column) * (M_PI / 180);
    const double cosine = places.inDegrees ? std::max(std::cos(latitude), kLowestCosine) : 1;
    const Frame frame = places.isCurvilinear() && !isEastward ? frameAt(places, row, column, cosine) : Frame{};
    const double east = u * frame.ux + v * frame.vx, north = u * frame.uy + v * frame.vy;
    const double length = std::hypot(u, v), onMap = std::hypot(east / cosine, north);
    const double scale = onMap > 0 ? length / onMap : onMap;
    vector[0] = float(east / cosine * scale);
    vector[1] = float(north * scale);
}

}  // namespace

std::vector<float> unpackedValues(const NetcdfFile& file, const std::string& variable, const Slab& slab)
{
    return file.type(variable) == NumberType::float32 ? unpack<float>(file, variable, slab)
                                                      : unpack<double>(file, variable, slab);
}

bool canStandOn(const NetcdfFile& file, const GridAxes& from, const GridAxes& to)
{
    if (from.size() > to.size()) return false;
    return isStaggered(file, from, {to.end() - std::ptrdiff_t(from.size()), to.end()});
}

std::vector<float> valuesOnGrid(const NetcdfFile& file, const GridVariable& variable, const GridAxes& axes,
                                const GridPlaces& places, std::size_t step)
{
    Block block = readBlock(file, variable, step);
    const std::size_t rank = variable.axes.size();
    for (std::size_t c = 0; c < rank; ++c) {
        const std::string &from = variable.axes[rank - 1 - c], &to = axes[axes.size() - 1 - c];
        const std::size_t size = places.lines[c].size();
        const auto before = from == to ? std::nullopt : neighbourBefore(file, from, to, kKindOfAxis[c]);
        if (before) block = averaged(block, c, size, *before);
        if (block.size[c] != size)
            file.fail("'" + variable.name + "' has " + std::to_string(block.size[c]) + " values along '" + from + "'",
                      std::to_string(size));
        if (places.turned[c]) turn(block, c);
    }
    const std::size_t layer = block.values.size();
    if (rank == 2) {
        block.values.reserve(places.count());
        for (std::size_t k = 1; k < places.layers(); ++k)
            std::copy_n(block.values.begin(), layer, std::back_inserter(block.values));
    }
    return std::move(block.values);
}

std::vector<float> vectorsOnGrid(const NetcdfFile& file, const GridVariables& all, const GridVector& vector,
                                 const GridAxes& axes, const GridPlaces& places, const std::vector<std::size_t>& steps)
{
    std::vector<float> vectors(3 * places.count(), 0.0f);
    for (std::size_t c = 0; c < vector.of.size(); ++c) {
        const std::vector<float> values =
            valuesOnGrid(file, all.variables[vector.of[c]], axes, places, steps[vector.of[c]]);
        for (std::size_t i = 0; i < values.size(); ++i) vectors[3 * i + c] = values[i];
    }
    std::size_t i = 0;
    for (std::size_t layer = 0; layer < places.layers(); ++layer)
        for (std::size_t row = 0; row < places.rows(); ++row)
            for (std::size_t column = 0; column < places.columns(); ++column)
                toMap(&vectors[3 * i++], places, row, column, vector.isEastward);
    return vectors;
}

}  // namespace aeolic
