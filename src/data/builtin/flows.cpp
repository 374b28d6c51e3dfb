#include "data/builtin/flows.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "aeolic/error.h"
#include "base/large_memory.h"
#include "base/memory.h"
#include "base/parallel.h"

namespace aeolic {
namespace {

constexpr std::int64_t defaultSamples = 128, minSamples = 2, maxSamples = 4096;
/// Parts of the longest side: what counts as flat, because neighbouring samples would coincide in float, and what a
/// flat side is given instead.
constexpr double flatness = 1e-6, flatThickness = 1e-3;

double longestSide(const Bounds& bounds)
{
    const glm::dvec3 size = bounds.hi - bounds.lo;
    return std::max({size.x, size.y, size.z});
}

/// Each flow splits the work along the axes, because a grid has far fewer coordinates than samples: `along(axis,
/// value)` is what one coordinate contributes, and `combine` makes a velocity of three of them.
struct Abc {
    struct Wave {
        double sin, cos;
    };
    using Term = Wave;
    static constexpr double periods = 1.25;
    glm::dvec3 center;
    double wavenumber;

    explicit Abc(const Bounds& bounds, double)
        : center(bounds.center()), wavenumber(2 * std::numbers::pi * periods / longestSide(bounds))
    {
    }
    Wave along(int axis, double value) const
    {
        const double phase = wavenumber * (value - center[axis]);
        return {std::sin(phase), std::cos(phase)};
    }
    /// Dombre et al., "Chaotic streamlines in the ABC flows", J. Fluid Mech. 167, 1986.
    static glm::dvec3 combine(const Wave& x, const Wave& y, const Wave& z)
    {
        constexpr double a = std::numbers::sqrt3, b = std::numbers::sqrt2, c = 1;
        return {a * z.sin + c * y.cos, b * x.sin + a * z.cos, c * y.sin + b * x.cos};
    }
};

/// It looks like Crawfis' well-known tornado, in a form of its own: a Scully vortex (Kaufmann's profile) plus
/// inflow and updraft. Lengths are in halves of the longer horizontal side.
struct Tornado {
    struct Term {
        double position;       ///< Distance from the box's centre; not used for z.
        glm::dvec2 core;       ///< Where the core is. This and what follows is known from z alone.
        double radiusSquared;  ///< How wide the core is.
        double inflow;         ///< How strongly air is drawn towards the core.
    };
    glm::dvec3 center;
    double bottom, height, scale;

    explicit Tornado(const Bounds& bounds, double)
        : center(bounds.center()),
          bottom(bounds.lo.z),
          height(bounds.hi.z - bounds.lo.z),
          scale(0.5 * std::max(bounds.hi.x - bounds.lo.x, bounds.hi.y - bounds.lo.y))
    {
    }
    Term along(int axis, double value) const
    {
        if (axis < 2) return {(value - center[axis]) / scale, {}, 0, 0};
        const double h = (value - bottom) / height;  // 0 at the ground, 1 at the top.
        const double turn = 2 * std::numbers::pi * h, radius = 0.12 + 0.3 * h * h;
        return {0, {0.25 * std::sin(1.3 * turn), 0.2 * std::cos(turn)}, radius * radius, 0.6 * (1 - h) * (1 - h)};
    }
    static glm::dvec3 combine(const Term& x, const Term& y, const Term& z)
    {
        const glm::dvec2 fromCore = glm::dvec2(x.position, y.position) - z.core;
        // Swirl d / (d^2 + r^2) is that of a solid body in the core, and of a free vortex far from it.
        const double strength = 1 / (glm::dot(fromCore, fromCore) + z.radiusSquared);
        const double updraft = 0.1 + 1.4 * z.radiusSquared * strength;
        return {-strength * (fromCore.y + z.inflow * fromCore.x), strength * (fromCore.x - z.inflow * fromCore.y),
                updraft};
    }
};

struct Rotation {
    using Term = double;
    glm::dvec3 center;

    explicit Rotation(const Bounds& bounds, double) : center(bounds.center()) {}
    double along(int axis, double value) const { return value - center[axis]; }
    static glm::dvec3 combine(double x, double y, double) { return {-y, x, 0}; }
};

struct Uniform {
    struct Term {};

    explicit Uniform(const Bounds&, double) {}
    Term along(int, double) const { return {}; }
    static glm::dvec3 combine(Term, Term, Term) { return {1, 0, 0}; }
};

/// psi = A sin(pi f(x, t)) sin(pi y) on [0, 2] x [0, 1], f = epsilon sin(omega t) x^2 + (1 - 2 epsilon sin(omega t)) x:
/// two vortices whose border sways. (u, v) = (-d psi / dy, d psi / dx), and a box of another shape is stretched with
/// it.
struct Gyre {
    struct Term {
        double sin, cos;  ///< Sine and cosine of pi f along x, of pi y along y.
        double slope;     ///< df/dx.
    };
    static constexpr double amplitude = 0.1, epsilon = 0.25, period = 10;
    glm::dvec3 lo, scale;  ///< World size of a unit of the gyre's own coordinates.
    double a;              ///< epsilon sin(omega t)

    Gyre(const Bounds& bounds, double time)
        : lo(bounds.lo),
          scale(0.5 * (bounds.hi.x - bounds.lo.x), bounds.hi.y - bounds.lo.y, 1),
          // The place within a period: the sine of 1e30 could be anything.
          a(epsilon * std::sin(2 * std::numbers::pi * (std::fmod(time, period) / period)))
    {
    }
    Term along(int axis, double value) const
    {
        if (axis == 2) return {scale.x, scale.y, 0};
        const double at = (value - lo[axis]) / scale[axis];
        const double f = axis == 0 ? (a * at + 1 - 2 * a) * at : at;
        return {std::sin(std::numbers::pi * f), std::cos(std::numbers::pi * f), 2 * a * at + 1 - 2 * a};
    }
    static glm::dvec3 combine(const Term& x, const Term& y, const Term& size)
    {
        constexpr double speed = std::numbers::pi * amplitude;
        return {-size.sin * speed * x.sin * y.cos, size.cos * speed * x.cos * y.sin * x.slope, 0};
    }
};

/// Fills `samples` and returns the largest length among those stored.
template <class Flow>
double fillGrid(const GridField& grid, const Bounds& box, double time, float* samples)
{
    const Flow flow(box, time);
    std::array<std::vector<typename Flow::Term>, 3> terms;
    const GridIndex first = grid.firstSample(), held = grid.heldDims();
    if (grid.sampleCount() == 0) return 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = std::size_t(axis);
        for (std::int64_t i = first[a]; i < first[a] + held[a]; ++i) {
            const double value = grid.originWorld[axis] + double(i) * grid.spacingWorld[axis];
            terms[std::size_t(axis)].push_back(flow.along(axis, value));
        }
    }
    const auto &x = terms[0], &y = terms[1], &z = terms[2];
    const std::size_t rows = y.size() * z.size(), tasks = std::min<std::size_t>(rows, 512);
    std::vector<double> maxSquared(tasks, 0);
    parallelFor(tasks, [&](std::size_t task) {
        double largest = 0;
        for (std::size_t row = rows * task / tasks; row < rows * (task + 1) / tasks; ++row) {
            float* out = samples + row * x.size() * 3;
            for (const auto& term : x) {
                const glm::vec3 v(Flow::combine(term, y[row % y.size()], z[row / y.size()]));
                *out++ = v.x;
                *out++ = v.y;
                *out++ = v.z;
                largest = std::max(largest, glm::dot(glm::dvec3(v), glm::dvec3(v)));
            }
        }
        maxSquared[task] = largest;
    });
    return std::sqrt(*std::ranges::max_element(maxSquared));
}

template <class Flow>
glm::dvec3 evaluate(const glm::dvec3& point, const Bounds& box, double time)
{
    const Flow flow(box, time);
    return Flow::combine(flow.along(0, point.x), flow.along(1, point.y), flow.along(2, point.z));
}

struct NamedFlow {
    std::string_view name;
    double (*fill)(const GridField& grid, const Bounds& box, double time, float* samples);
    glm::dvec3 (*at)(const glm::dvec3& point, const Bounds& box, double time);
    double period = 0;  ///< 0: it is steady.
};
constexpr int gyreMomentsPerPeriod = 40;
constexpr std::array<NamedFlow, 5> flows{{{"abc", fillGrid<Abc>, evaluate<Abc>},
                                          {"tornado", fillGrid<Tornado>, evaluate<Tornado>},
                                          {"rotation", fillGrid<Rotation>, evaluate<Rotation>},
                                          {"uniform", fillGrid<Uniform>, evaluate<Uniform>},
                                          {"gyre", fillGrid<Gyre>, evaluate<Gyre>, Gyre::period}}};
static_assert(std::ranges::equal(flows, builtinFlowNames, {}, &NamedFlow::name));

const NamedFlow& requireFlow(const std::string& spec)
{
    const auto found = std::ranges::find(flows, nameInSpec(spec), &NamedFlow::name);
    if (found == flows.end()) throw InputError("--field", "'" + spec + "'", "abc, tornado, rotation, uniform or gyre");
    return *found;
}

std::array<std::int64_t, 3> parseDims(const std::string& spec)
{
    const std::size_t colon = spec.find(':');
    std::array<std::int64_t, 3> dims{defaultSamples, defaultSamples, defaultSamples};
    if (colon == std::string::npos) return dims;
    const char* at = spec.data() + colon + 1;
    const char* const end = spec.data() + spec.size();
    bool good = true;
    for (std::size_t axis = 0; axis < 3 && good; ++axis) {
        const auto [stop, error] = std::from_chars(at, end, dims[axis]);
        good = error == std::errc() && dims[axis] >= minSamples && dims[axis] <= maxSamples;
        good = good && (axis == 2 ? stop == end : stop != end && *stop == ',');
        at = stop + 1;
    }
    if (good) return dims;
    throw InputError("--field", "'" + spec + "'", spec.substr(0, colon) + "[:NX,NY,NZ], each from 2 to 4096");
}

/// The bounds with every flat side thickened evenly to both sides.
Bounds withThickness(Bounds bounds)
{
    const double longest = longestSide(bounds), thickness = longest > 0 ? flatThickness * longest : 1;
    for (int axis = 0; axis < 3; ++axis) {
        if (bounds.hi[axis] - bounds.lo[axis] > flatness * longest) continue;
        const double middle = 0.5 * (bounds.lo[axis] + bounds.hi[axis]);
        bounds.lo[axis] = middle - 0.5 * thickness;
        bounds.hi[axis] = middle + 0.5 * thickness;
    }
    return bounds;
}

/// The box a flow is defined on.
Bounds flowBox(const Bounds& bounds)
{
    const bool finite = std::isfinite(glm::dot(bounds.hi - bounds.lo, bounds.hi - bounds.lo));
    if (bounds.empty() || !finite)
        throw std::invalid_argument("a built-in flow needs finite bounds that are not empty");
    return withThickness(bounds);
}

}  // namespace

GridField outlineOfBuiltinFlow(const std::string& spec)
{
    GridField grid;
    grid.dims = parseDims(spec);
    grid.name = requireFlow(spec).name;
    return grid;
}

std::vector<double> builtinFlowTimes(const std::string& spec)
{
    const double period = requireFlow(spec).period;
    std::vector<double> times;
    for (int i = 0; period > 0 && i <= gyreMomentsPerPeriod; ++i) times.push_back(period * i / gyreMomentsPerPeriod);
    return times;
}

glm::dvec3 builtinFlow(const std::string& name, const glm::dvec3& pointWorld, const Bounds& boundsWorld, double time)
{
    return requireFlow(name).at(pointWorld, flowBox(boundsWorld), time);
}

std::shared_ptr<const GridField> makeBuiltinFlow(const std::string& spec, const Bounds& boundsWorld,
                                                 const FieldPart& part, double time)
{
    const NamedFlow& flow = requireFlow(spec);
    const Bounds box = flowBox(boundsWorld);
    auto grid = std::make_shared<GridField>();
    grid->dims = parseDims(spec);
    grid->name = flow.name;
    grid->originWorld = box.lo;
    for (int axis = 0; axis < 3; ++axis) {
        grid->spacingWorld[axis] = (box.hi[axis] - box.lo[axis]) / double(grid->dims[std::size_t(axis)] - 1);
    }
    if (part.split()) grid->brick = brickOf(*grid, part);
    requireMemory("--field", "'" + spec + "'", grid->bytes());
    const std::shared_ptr<float> samples(makeLargeArray<float>(grid->sampleCount() * 3).release(), FreeLarge());
    grid->maxMagnitude = flow.fill(*grid, box, time, samples.get());
    grid->samples = samples;
    return grid;
}

}  // namespace aeolic
