#include "data/streamlines/even_streamlines.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/append.h"
#include "data/streamlines/near_samples.h"

namespace aeolic {
namespace {

/// Parts of a level's spacing: how far a seed is from lines at least, and a line from others; how far apart samples
/// are, and points at most; how long a line is at least, and what a finer level adds to one.
constexpr float kSeedPart = 0.9f, kLinePart = 0.55f, kSamplePart = 0.25f, kPointPart = 0.5f, kShortest = 2,
                kLeastMore = 1;

/// In spacings: within so much of its own length a line may come as near to itself as it likes. Beyond, it is closed
/// where it comes back to its seed and misses it by less than the second.
constexpr float kOwnArc = 1.5f, kMissed = 0.2f;

/// A line has a point wherever it has turned by so much. Radians.
constexpr float kTurnRad = 0.06f;

/// How far a line goes before it looks again whether it has room.
constexpr float kLookPart = 0.2f;

/// Seeds over the area: so many on the square of a spacing.
constexpr double kSeedsOnSquare = 2;

/// No line is longer than this many times the surface's size.
constexpr double kLongest = 4;

/// Keeps those places of a line at which it turns, and enough of those between.
class Thinning {
public:
    Thinning(const StreamlinePoint& first, float longest) : longest_(longest), last_(first), kept_(first) {}

    void add(const StreamlinePoint& point, std::vector<StreamlinePoint>& out)
    {
        const glm::vec3 way = point.at - last_.at;
        const float length = glm::length(way);
        if (!(length > 0)) return;
        const glm::vec3 direction = way / length;
        if (hasDirection_ && last_.arc != kept_.arc &&
            (glm::dot(direction, begun_) < std::cos(kTurnRad) || std::abs(point.arc - kept_.arc) > longest_)) {
            out.push_back(last_);
            kept_ = last_;
            hasDirection_ = false;
        }
        if (!hasDirection_) begun_ = direction, hasDirection_ = true;
        last_ = point;
    }
    void end(std::vector<StreamlinePoint>& out) const
    {
        if (last_.arc == kept_.arc) return;
        const bool isNear = std::abs(last_.arc - kept_.arc) < 0.02f * longest_;
        if (isNear && !out.empty()) out.pop_back();
        out.push_back(last_);
    }

private:
    float longest_;
    StreamlinePoint last_, kept_;
    glm::vec3 begun_{0};
    bool hasDirection_ = false;
};

LineSample sampleOf(const StreamlinePoint& point, std::uint32_t chain)
{
    return {point.at, point.normal, chain, point.arc};
}

/// Adds the streamlines of one level to those of the levels before.
class StreamlineLevel {
public:
    /// `lines`, `ends` and `chains`, how many streamlines there are, are those of the levels before; all change.
    StreamlineLevel(const StreamlineSurface& surface, int level, double spacing, std::vector<EvenStreamline>& lines,
                    std::vector<OpenEnd>& ends, std::uint32_t& chains)
        : surface_(surface),
          level_(level),
          spacing_(float(spacing)),
          lines_(lines),
          ends_(ends),
          chains_(chains),
          near_(spacing_, std::size_t(surface.area() / (spacing * spacing) * 2 / kSamplePart))
    {
        for (const EvenStreamline& line : lines_) addSamples(line);
    }

    /// Lines that are there go on at their ends. Then seeds lie across the flow from lines, old and new, and last over
    /// the whole area.
    void run()
    {
        for (const OpenEnd& end : std::exchange(ends_, {})) goOn(end);
        seedBesideAll();
        const double squares = surface_.area() / (double(spacing_) * double(spacing_));
        const auto seeds = std::size_t(std::ceil(kSeedsOnSquare * squares));
        for (std::size_t i = 0; i < seeds; ++i) {
            const SurfacePlace seed = surface_.spread(i, seeds);
            if (!surface_.hasFlow(seed.triangle)) continue;
            tryLine(seed);
            seedBesideAll();
        }
    }

private:
    /// What following a line one way found. Points are without the first.
    struct Way {
        std::vector<StreamlinePoint> points;
        SurfacePlace last;
        bool isCut = false, isClosed = false;
    };

    StreamlinePoint pointAt(const SurfacePlace& place, float arc) const
    {
        return {surface_.at(place), surface_.normal(place.triangle), arc, place};
    }

    void goOn(const OpenEnd& end)
    {
        const StreamlinePoint from = pointAt(end.place, end.arc);
        const std::size_t before = near_.count();
        Way way = follow(from, end.direction, end.chain, false);
        if (way.points.empty() || std::abs(way.points.back().arc - end.arc) < kLeastMore * spacing_) {
            near_.shrinkTo(before);
            if (way.isCut) ends_.push_back(end);  // There may be more room on the next level.
            return;
        }
        keepEnd(way, from, end.chain, end.direction);
        way.points.insert(way.points.begin(), from);
        if (end.direction < 0) std::ranges::reverse(way.points);
        lines_.push_back({level_, end.chain, std::move(way.points)});
    }

    void seedBesideAll()
    {
        for (; seeded_ < lines_.size(); ++seeded_) {
            const std::size_t count = lines_[seeded_].points.size();
            float next = lines_[seeded_].points.front().arc;
            for (std::size_t i = 0; i < count; ++i) {
                const EvenStreamline& line = lines_[seeded_];  // A line that is added may move it.
                const StreamlinePoint point = line.points[i];
                if (point.arc < next) continue;
                next = point.arc + 0.9f * kPointPart * spacing_;
                const std::size_t other = i + 1 < count ? i + 1 : i - 1;
                seedBeside(point, (other > i ? 1.0f : -1.0f) * (line.points[other].at - point.at));
            }
        }
    }

    void seedBeside(const StreamlinePoint& point, const glm::vec3& along)
    {
        const glm::vec3 across = glm::cross(point.normal, along);
        const float length = glm::length(across);
        if (!(length > 0)) return;
        for (const int side : {1, -1}) {
            // Where the surface is flat the seed lies here. This spares the way there where there is no room.
            const LineSample guess{point.at + float(side) * spacing_ / length * across, point.normal, chains_, 0};
            if (!near_.isFree(guess, kLinePart * spacing_, 0)) continue;
            SurfacePlace last = point.place;
            const double unit = surface_.unitWorld();
            const LineEnd end =
                surface_.across().follow(point.place, side, double(spacing_) * unit,
                                         double(kSamplePart * spacing_) * unit, [&](const SurfacePlace& p, double) {
                                             last = p;
                                             return true;
                                         });
            if (end == LineEnd::longest) tryLine(last);
        }
    }

    void tryLine(const SurfacePlace& seed)
    {
        const StreamlinePoint from = pointAt(seed, 0);
        const std::uint32_t chain = chains_;
        if (!near_.isFree(sampleOf(from, chain), kSeedPart * spacing_, 0)) return;
        const std::size_t before = near_.count();
        near_.add(sampleOf(from, chain));
        const Way down = follow(from, 1, chain, true);
        const Way up = down.isClosed ? Way{} : follow(from, -1, chain, false);
        std::vector<StreamlinePoint> points(up.points.rbegin(), up.points.rend());
        points.push_back(from);
        appendAll(points, down.points);
        if (points.back().arc - points.front().arc < kShortest * spacing_) return near_.shrinkTo(before);
        ++chains_;
        keepEnd(down, from, chain, 1);
        keepEnd(up, from, chain, -1);
        lines_.push_back({level_, chain, std::move(points)});
    }

    /// A line has come back to its seed, so that it can be closed, or will in a moment.
    bool isBack(const StreamlinePoint& seed, const StreamlinePoint& point, const glm::vec3& ahead) const
    {
        const glm::vec3 way = seed.at - point.at;
        return std::abs(point.arc - seed.arc) > kOwnArc * spacing_ && glm::length(way) < kLinePart * spacing_ &&
               glm::length(way - glm::dot(way, ahead) * ahead) < kMissed * spacing_;
    }

    Way follow(const StreamlinePoint& from, int direction, std::uint32_t chain, bool mayClose)
    {
        Way way{{}, from.place};
        Thinning thinning(from, kPointPart * spacing_);
        StreamlinePoint before = from;
        float looked = 0;
        const double unit = surface_.unitWorld();
        const auto visit = [&](const SurfacePlace& place, double lengthWorld) {
            const auto walked = float(lengthWorld / unit);
            const StreamlinePoint point = pointAt(place, from.arc + float(direction) * walked);
            // Along a side that the flow runs towards from both sides a line goes far at once.
            const int looks = int((walked - looked) / (kLookPart * spacing_));
            for (int i = 1; i <= looks; ++i) {
                const float part = float(i) / float(looks);
                StreamlinePoint there = point;
                there.at = before.at + part * (point.at - before.at);
                there.arc = before.arc + part * (point.arc - before.arc);
                const glm::vec3 ahead = point.at - before.at;
                if (!(glm::length(ahead) > 0)) break;
                const LineSample sample = sampleOf(there, chain);
                if (mayClose && isBack(from, there, glm::normalize(ahead))) {
                    way.isClosed = glm::dot(from.at - there.at, glm::normalize(ahead)) < kSamplePart * spacing_;
                } else {
                    way.isCut = !near_.isFree(sample, kLinePart * spacing_, kOwnArc * spacing_);
                }
                if (way.isClosed || way.isCut) return false;
                near_.add(sample);
                looked = walked;
            }
            way.last = place;
            thinning.add(point, way.points);
            before = point;
            return true;
        };
        const LineEnd end = surface_.along().follow(from.place, direction, kLongest * surface_.size() * unit,
                                                    double(kSamplePart * spacing_) * unit, visit);
        // A line may also end where it comes again and again to one edge that it slides along.
        way.isClosed |=
            mayClose && end == LineEnd::closed && glm::distance(before.at, from.at) < kSamplePart * spacing_;
        thinning.end(way.points);
        if (way.isClosed) {
            way.points.push_back(from);
            way.points.back().arc = before.arc + float(direction) * glm::length(from.at - before.at);
        }
        return way;
    }

    void keepEnd(const Way& way, const StreamlinePoint& from, std::uint32_t chain, int direction)
    {
        if (way.isCut)
            ends_.push_back({chain, direction, way.last, (way.points.empty() ? from : way.points.back()).arc});
    }

    void addSamples(const EvenStreamline& line)
    {
        for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
            const StreamlinePoint &a = line.points[i], &b = line.points[i + 1];
            const int parts = std::max(1, int(std::ceil((b.arc - a.arc) / (kSamplePart * spacing_))));
            for (int k = 0; k < parts; ++k) {
                const float part = float(k) / float(parts);
                near_.add({a.at + part * (b.at - a.at), a.normal, line.chain, a.arc + part * (b.arc - a.arc)});
            }
        }
        const StreamlinePoint& last = line.points.back();
        near_.add({last.at, last.normal, line.chain, last.arc});
    }

    const StreamlineSurface& surface_;
    const int level_;
    const float spacing_;
    std::vector<EvenStreamline>& lines_;
    std::vector<OpenEnd>& ends_;
    std::uint32_t& chains_;
    NearSamples near_;
    std::size_t seeded_ = 0;  // Lines that have had their seeds.
};

}  // namespace

EvenStreamlines::EvenStreamlines(SurfaceMesh mesh, std::vector<glm::vec3> vectors, double levelWorld)
    : surface_(std::move(mesh), std::move(vectors)), coarsest_(surface_.size() / 6)
{
    if (const double level = levelWorld / surface_.unitWorld(); level > 0 && coarsest_ > 0)
        coarsest_ = level * std::exp2(std::round(std::log2(coarsest_ / level)));
    constexpr std::size_t count = 1 << 15;
    if (surface_.area() > 0)
        for (std::size_t i = 0; i < count; ++i) places_.push_back(surface_.at(surface_.spread(i, count)));
}

double EvenStreamlines::spacing(int level) const
{
    return std::ldexp(coarsest_, -level);
}

bool EvenStreamlines::canRefine() const
{
    constexpr int givesUp = 5;  // Where no line is long enough on so many levels.
    const double apart = spacing(levels_);
    return surface_.area() > 0 && levels_ < kMostLevels && !(lines_.empty() && levels_ > givesUp) &&
           surface_.area() <= kMostSquares * apart * apart;
}

void EvenStreamlines::refineTo(int level)
{
    while (levels_ <= level && canRefine()) {
        StreamlineLevel(surface_, levels_, spacing(levels_), lines_, ends_, chains_).run();
        ++levels_;
    }
}

}  // namespace aeolic
