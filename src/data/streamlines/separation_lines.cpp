#include "data/streamlines/separation_lines.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "base/append.h"
#include "base/parallel.h"
#include "data/streamlines/line_counts.h"
#include "data/streamlines/near_samples.h"

namespace aeolic {
namespace {

constexpr std::size_t kFollowed = 2048;  // Streamlines, either way.
constexpr double kLongest = 0.4;         // They are followed so far, as a part of the surface's size.
// Lengths, as multiples of how far apart two lines are at least.
constexpr double kStep = 0.5;    // Samples on a streamline are so far apart.
constexpr float kBeside = 2.5f;  // A line is compared with what is so far beside it.
constexpr float kGap = 2;        // A line may be too weak to be seen for so long.
constexpr float kShortest = 6;   // No line is shorter.
constexpr float kDense = 2;      // On a line are so many times as many samples as on average …
constexpr float kRidge = 2;      // … and so many times as many as on either side.

/// With less there would be too few streamlines between two lines to tell one by.
constexpr double kLeastApart = 0.005;

struct Sample {
    LineSample at;
    glm::vec3 along{0};
    SurfacePlace place;
    float density = 0;  // As a part of the average.
    bool isOnLine = false;
};

/// Samples that follow each other on one streamline: from the first that is on a line to the last.
struct Piece {
    std::size_t begin = 0, end = 0;
    double strength = 0;  // The sum.
};

/// Looks for the lines where streamlines gather that are followed in one direction.
class Gathering {
public:
    Gathering(const StreamlineSurface& surface, int direction, double apart)
        : surface_(surface),
          direction_(direction),
          apart_(float(apart)),
          samples_(followed()),
          counts_(placesOf(samples_), float(apart))
    {
        const double each = std::numbers::pi * apart * apart * kLongest * surface.size() / (kStep * apart);
        average_ = float(double(kFollowed) / surface.area() * each);
        judge();
    }

    std::vector<SeparationLine> lines() const
    {
        std::vector<Piece> pieces = piecesOnLines();
        std::ranges::stable_sort(pieces, std::greater(), &Piece::strength);
        NearSamples taken(kBeside * apart_, samples_.size());
        std::vector<SeparationLine> lines;
        for (const Piece& piece : pieces) takeFree(piece, taken, lines);
        return lines;
    }

private:
    std::vector<Sample> followed() const
    {
        std::vector<std::vector<Sample>> lines(kFollowed);
        const double step = kStep * double(apart_) * surface_.unitWorld(),
                     longest = kLongest * surface_.size() * surface_.unitWorld();
        parallelFor(kFollowed, [&](std::size_t i) {
            const SurfacePlace seed = surface_.spread(i, kFollowed);
            if (!surface_.hasFlow(seed.triangle)) return;
            double next = 0;
            surface_.along().follow(seed, direction_, longest, step, [&](const SurfacePlace& place, double length) {
                if (length < next) return true;
                next += step;
                lines[i].push_back(sampleAt(place, length, i));
                return true;
            });
            for (std::size_t k = 0; k < lines[i].size(); ++k) {
                const std::size_t after = std::min(k + 1, lines[i].size() - 1), before = k > 0 ? k - 1 : 0;
                lines[i][k].along = lines[i][after].at.at - lines[i][before].at.at;
            }
        });
        std::vector<Sample> all;
        for (const auto& line : lines) appendAll(all, line);
        return all;
    }

    static std::vector<LineSample> placesOf(const std::vector<Sample>& samples)
    {
        std::vector<LineSample> places;
        places.reserve(samples.size());
        for (const Sample& sample : samples) places.push_back(sample.at);
        return places;
    }

    float densityAt(const LineSample& place) const { return float(counts_.near(place)) / average_; }

    void judge()
    {
        parallelFor(samples_.size(), [&](std::size_t i) { judge(samples_[i]); });
    }

    void judge(Sample& sample) const
    {
        if (float(counts_.atMost(sample.at)) < kDense * average_) return;
        sample.density = densityAt(sample.at);
        const glm::vec3 across = glm::cross(sample.at.normal, sample.along);
        if (sample.density < kDense || !(glm::length(across) > 0)) return;
        const glm::vec3 way = kBeside * apart_ * glm::normalize(across);
        LineSample left = sample.at, right = sample.at;
        left.at += way;
        right.at -= way;
        sample.isOnLine = sample.density > kRidge * std::max(densityAt(left), densityAt(right));
    }

    Sample sampleAt(const SurfacePlace& place, double length, std::size_t line) const
    {
        return {{surface_.at(place), surface_.normal(place.triangle), std::uint32_t(line),
                 float(length / surface_.unitWorld())},
                glm::vec3(0),
                place};
    }

    /// The streamline goes on from a place for as long as it is on a line that no other has taken.
    std::vector<Sample> goneOn(const Sample& from, int direction, const NearSamples& taken) const
    {
        std::vector<Sample> more;
        std::size_t kept = 0;
        const double step = kStep * double(apart_) * surface_.unitWorld();
        double next = step;
        glm::vec3 last = from.at.at;
        surface_.along().follow(from.place, direction, 4 * surface_.size() * surface_.unitWorld(), step,
                                [&](const SurfacePlace& place, double length) {
                                    if (length < next) return true;
                                    next += step;
                                    Sample sample = sampleAt(place, length, from.at.chain);
                                    sample.along = sample.at.at - last;
                                    last = sample.at.at;
                                    judge(sample);
                                    if (!taken.isFree(sample.at, kBeside * apart_, 0)) return false;
                                    more.push_back(sample);
                                    if (sample.isOnLine) kept = more.size();
                                    return float(more.size() - kept) * float(kStep) <= kGap;
                                });
        more.resize(kept);
        return more;
    }

    std::vector<Piece> piecesOnLines() const
    {
        std::vector<Piece> pieces;
        const Sample* last = nullptr;  // Of the last piece.
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            const Sample& sample = samples_[i];
            if (!sample.isOnLine) continue;
            const bool goesOn =
                last && last->at.chain == sample.at.chain && sample.at.arc - last->at.arc <= kGap * apart_;
            if (!goesOn) pieces.push_back({i, i});
            pieces.back().end = i + 1;
            pieces.back().strength += std::log(double(sample.density));
            last = &sample;
        }
        return pieces;
    }

    /// The longest run of a piece that no stronger one is beside.
    void takeFree(const Piece& piece, NearSamples& taken, std::vector<SeparationLine>& lines) const
    {
        Piece best, run{piece.begin, piece.begin};
        for (std::size_t i = piece.begin; i < piece.end; ++i) {
            if (!taken.isFree(samples_[i].at, kBeside * apart_, 0))
                run = {i + 1, i + 1};
            else if (++run.end - run.begin > best.end - best.begin)
                best = run;
        }
        if (best.end - best.begin < 2) return;
        std::vector<Sample> line = goneOn(samples_[best.begin], -direction_, taken);
        std::ranges::reverse(line);
        line.insert(line.end(), samples_.begin() + std::ptrdiff_t(best.begin),
                    samples_.begin() + std::ptrdiff_t(best.end));
        appendAll(line, goneOn(samples_[best.end - 1], direction_, taken));
        SeparationLine found{direction_ > 0, 0, 0, {}};
        for (std::size_t i = 1; i < line.size(); ++i)
            found.lengthWorld += double(glm::length(line[i].at.at - line[i - 1].at.at)) * surface_.unitWorld();
        if (found.lengthWorld < double(kShortest * apart_) * surface_.unitWorld()) return;
        for (const Sample& sample : line) {
            found.strength += std::log(std::max(double(sample.density), 1.0));
            found.places.push_back(sample.place);
            taken.add(sample.at);
        }
        found.strength /= double(line.size());
        if (direction_ < 0) std::ranges::reverse(found.places);
        lines.push_back(std::move(found));
    }

    const StreamlineSurface& surface_;
    int direction_;
    float apart_, average_ = 1;
    std::vector<Sample> samples_;
    LineCounts counts_;
};

}  // namespace

std::vector<SeparationLine> separationLines(const StreamlineSurface& surface, double persistence)
{
    if (!(surface.area() > 0)) return {};
    const double apart = std::clamp(persistence, kLeastApart, 0.1) * surface.size();
    std::vector<SeparationLine> all;
    for (const int direction : {1, -1})
        for (SeparationLine& line : Gathering(surface, direction, apart).lines()) all.push_back(std::move(line));
    std::ranges::stable_sort(all, [](const SeparationLine& a, const SeparationLine& b) {
        return a.separates != b.separates ? a.separates : a.strength > b.strength;
    });
    return all;
}

}  // namespace aeolic
