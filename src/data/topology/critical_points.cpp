#include "data/topology/critical_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/parallel.h"

namespace aeolic {
namespace {

constexpr std::size_t kGrain = 1024;
constexpr double kPi = std::numbers::pi;

/// Below this part of the longest vector a point is at rest.
constexpr double kAtRest = 1e-9;

/// Where streamlines turn by less than this beside how they come nearer they do not turn: what flows straight at a
/// point from everywhere would else be a node or a focus by rounding.
constexpr double kRounding = 1e-6;

/// Where streamlines come no nearer in this part of a turn they count as closed.
constexpr double kClosed = 1e-3;

double cross(const glm::dvec2& a, const glm::dvec2& b)
{
    return a.x * b.y - a.y * b.x;
}

double from0To2Pi(double rad)
{
    const double positive = rad < 0 ? rad + 2 * kPi : rad;
    return positive < 2 * kPi ? positive : 0;
}

/// The corners of one fan, counterclockwise.
template <class Visit>
void forEachCorner(const SurfaceFans& fans, std::uint32_t fan, const Visit& visit)
{
    const std::uint32_t first = fans.firstCorner[fan];
    std::uint32_t corner = first;
    do {
        visit(corner);
        corner = fans.nextCorner(corner);
    } while (corner != SurfaceFans::kNone && corner != first);
}

class FanFrame {
public:
    FanFrame(const SurfaceMesh& mesh, const SurfaceFans& fans, std::uint32_t fan) : mesh_(mesh), fans_(fans), fan_(fan)
    {
        forEachCorner(fans, fan, [&](std::uint32_t c) { normal_ += glm::cross(side(c, 1), side(c, 2)); });
        const std::uint32_t first = fans.firstCorner[fan];
        if (!(glm::length(normal_) > 0)) normal_ = glm::cross(side(first, 1), side(first, 2));
        normal_ = glm::normalize(normal_);
        glm::dvec3 ahead = along(side(first, 1));
        if (!(glm::length(ahead) > 0)) ahead = along(side(first, 2));
        ahead_ = glm::normalize(ahead);
        left_ = glm::cross(normal_, ahead_);
    }

    glm::dvec3 along(const glm::dvec3& vector) const { return vector - normal_ * glm::dot(normal_, vector); }

    /// The angle of a tangential vector: between the edges on either side of it, which are scaled.
    double radOf(const glm::dvec3& vector) const
    {
        const double seen = seenRad(vector);
        double lowSeen = 0, lowRad = 0, highSeen = 2 * kPi, highRad = 2 * kPi;
        forEachCorner(fans_, fan_, [&](std::uint32_t c) {
            const double edge = c == fans_.firstCorner[fan_] ? 0 : seenRad(side(c, 1));
            take(edge, fans_.edgeRad[c], seen, lowSeen, lowRad, highSeen, highRad);
            if (fans_.nextCorner(c) == SurfaceFans::kNone)
                take(seenRad(side(c, 2)), fans_.secondEdgeRad(c), seen, lowSeen, lowRad, highSeen, highRad);
        });
        if (!(highSeen > lowSeen)) return lowRad;
        return lowRad + (highRad - lowRad) * (seen - lowSeen) / (highSeen - lowSeen);
    }

private:
    static void take(double edge, double edgeRad, double seen, double& lowSeen, double& lowRad, double& highSeen,
                     double& highRad)
    {
        if (edge <= seen && edge >= lowSeen) lowSeen = edge, lowRad = edgeRad;
        if (edge > seen && edge < highSeen) highSeen = edge, highRad = edgeRad;
    }

    /// From the corner to the triangle's next (1) or last (2) point.
    glm::dvec3 side(std::uint32_t corner, std::uint32_t which) const
    {
        const auto& t = mesh_.triangles[corner / 3];
        return glm::dvec3(mesh_.positions[t[(corner + which - corner / 3 * 3) % 3]]) -
               glm::dvec3(mesh_.positions[t[corner % 3]]);
    }
    double seenRad(const glm::dvec3& vector) const
    {
        return from0To2Pi(std::atan2(glm::dot(vector, left_), glm::dot(vector, ahead_)));
    }

    const SurfaceMesh& mesh_;
    const SurfaceFans& fans_;
    std::uint32_t fan_;
    glm::dvec3 normal_{0}, ahead_{0}, left_{0};
};

/// A triangle laid flat, with the flow at its corners, which differs from that in the fans by how curved they are.
struct FlatTriangle {
    std::array<glm::dvec2, 3> point, flow;
};

FlatTriangle flat(const SurfaceMesh& mesh, const SurfaceFans& fans, const TangentField& field, std::uint32_t t)
{
    const auto at = [&](std::size_t i) { return glm::dvec3(mesh.positions[mesh.triangles[t][i % 3]]); };
    const double base = glm::length(at(1) - at(0)), last = glm::length(at(2) - at(0));
    const std::uint32_t corner = 3 * t;
    const double rad0 = fans.cornerRad[corner], rad1 = fans.cornerRad[corner + 1];
    FlatTriangle out{{glm::dvec2(0), {base, 0}, {last * std::cos(rad0), last * std::sin(rad0)}}, {}};
    const std::array<double, 3> sideRad{0, kPi - rad1, kPi + rad0};  // Of the half-edge that begins at each corner.
    for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t c = corner + i, fan = fans.fanOf[c];
        const double curved = 0.5 * fans.cornerRad[c] * (1 - fans.scale[fan]);  // Half of it beside either edge.
        const double rad = sideRad[i] + wrapped(field.rad[fan] - fans.edgeRad[c]) + curved;
        out.flow[i] = field.length[fan] * glm::dvec2(std::cos(rad), std::sin(rad));
    }
    return out;
}

/// By how much the flow turns along a half-edge, more than what is carried along. Opposite for its twin, to the bit:
/// half a turn would else be counted to the same side twice.
double rotationRad(const SurfaceFans& fans, const TangentField& field, std::uint32_t h)
{
    if (const std::uint32_t twin = fans.twin[h]; twin < h) return -rotationRad(fans, field, twin);
    const double there = field.rad[fans.fanOf[nextInTriangle(h)]], here = field.rad[fans.fanOf[h]];
    return wrapped(there - here - fans.transportRad(h));
}

/// Turns of the flow around a triangle.
int indexOf(const SurfaceFans& fans, const TangentField& field, std::uint32_t t)
{
    double rotation = 0, holonomy = 0;
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
        rotation += rotationRad(fans, field, h);
        holonomy += fans.transportRad(h);
    }
    return int(std::lround((rotation + wrapped(holonomy)) / (2 * kPi)));
}

void placeIn(const FlatTriangle& flat, CriticalPoint& out)
{
    const auto& v = flat.flow;
    const double parts[3] = {cross(v[1], v[2]), cross(v[2], v[0]), cross(v[0], v[1])};
    const double whole = parts[0] + parts[1] + parts[2];
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += out.weight[i] = whole == 0 ? 1 : std::max(parts[i] / whole, 0.0);
    for (double& weight : out.weight) weight /= sum;
}

void classify(const FlatTriangle& flat, CriticalPoint& out)
{
    const glm::dmat2 sides(flat.point[1] - flat.point[0], flat.point[2] - flat.point[0]);
    const glm::dmat2 change(flat.flow[1] - flat.flow[0], flat.flow[2] - flat.flow[0]);
    const glm::dmat2 derivative = change * glm::inverse(sides);
    const double trace = derivative[0][0] + derivative[1][1], determinant = glm::determinant(derivative);
    out.strength = std::sqrt(std::abs(determinant));
    if (std::abs(out.index) != 1) return;
    out.attracts = trace < 0;
    const double turning = determinant - 0.25 * trace * trace;
    if (out.index < 0)
        out.kind = CriticalKind::saddle, out.attracts = false;
    else if (turning <= kRounding * trace * trace)
        out.kind = CriticalKind::node;
    else
        out.kind = std::abs(trace) < kClosed * std::sqrt(turning) ? CriticalKind::centre : CriticalKind::focus;
}

std::optional<CriticalPoint> criticalPointOf(const SurfaceMesh& mesh, const SurfaceFans& fans,
                                             const TangentField& field, std::uint32_t t)
{
    int resting = 0, restingCorner = 0;
    for (int i = 0; i < 3; ++i) {
        const double length = field.length[fans.fanOf[3 * t + std::uint32_t(i)]];
        if (!std::isfinite(length)) return {};
        if (length == 0) ++resting, restingCorner = i;
    }
    if (resting > 1) return {};
    CriticalPoint found;
    found.triangle = t;
    found.index = indexOf(fans, field, t);
    if (found.index == 0) return {};
    const FlatTriangle laid = flat(mesh, fans, field, t);
    if (resting == 1)
        found.weight[restingCorner] = 1;
    else
        placeIn(laid, found);
    classify(laid, found);
    found.positionWorld = mesh.originWorld;
    for (std::size_t i = 0; i < 3; ++i)
        found.positionWorld += found.weight[i] * glm::dvec3(mesh.positions[mesh.triangles[t][i]]);
    return found;
}

}  // namespace

TangentField tangentField(const SurfaceMesh& mesh, const SurfaceFans& fans, const std::vector<glm::vec3>& vectors)
{
    TangentField field{std::vector<double>(fans.fans()), std::vector<double>(fans.fans())};
    double longest = 0;
    for (const glm::vec3& vector : vectors)
        if (const double length = glm::length(glm::dvec3(vector)); std::isfinite(length))
            longest = std::max(longest, length);
    parallelRanges(fans.fans(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (auto fan = std::uint32_t(begin); fan < end; ++fan) {
            glm::dvec3 vector(std::numeric_limits<double>::quiet_NaN());
            forEachCorner(fans, fan, [&](std::uint32_t c) {
                if (!std::isfinite(glm::length(vector))) vector = glm::dvec3(vectors[mesh.triangles[c / 3][c % 3]]);
            });
            const FanFrame frame(mesh, fans, fan);
            const glm::dvec3 along = frame.along(vector);
            const double length = glm::length(along);
            field.length[fan] = length <= kAtRest * longest ? 0 : length;
            field.rad[fan] = std::isfinite(length) && field.length[fan] > 0 ? frame.radOf(along) : 0;
        }
    });
    return field;
}

std::vector<CriticalPoint> criticalPoints(const SurfaceMesh& mesh, const SurfaceFans& fans, const TangentField& field)
{
    const std::size_t triangles = mesh.triangles.size(), runs = (triangles + kGrain - 1) / kGrain;
    std::vector<std::vector<CriticalPoint>> found(runs);
    parallelFor(runs, [&](std::size_t run) {
        for (std::size_t t = run * kGrain; t < std::min(triangles, (run + 1) * kGrain); ++t)
            if (const auto point = criticalPointOf(mesh, fans, field, std::uint32_t(t))) found[run].push_back(*point);
    });
    std::vector<CriticalPoint> all;
    for (const auto& some : found) all.insert(all.end(), some.begin(), some.end());
    return all;
}

}  // namespace aeolic
