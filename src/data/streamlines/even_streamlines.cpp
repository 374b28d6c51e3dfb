#include "data/streamlines/even_streamlines.h"

#include <cmath>
#include <utility>

#include "data/streamlines/streamline_level.h"

namespace aeolic {

EvenStreamlines::EvenStreamlines(SurfaceMesh mesh, std::vector<glm::vec3> vectors, double levelWorld)
    : surface_(std::make_unique<const StreamlineSurface>(std::move(mesh), std::move(vectors))),
      coarsest_(surface_->size() / 6)
{
    if (const double level = levelWorld / surface_->unitWorld(); level > 0 && coarsest_ > 0)
        coarsest_ = level * std::exp2(std::round(std::log2(coarsest_ / level)));
    constexpr std::size_t count = 1 << 15;
    if (surface_->area() > 0)
        for (std::size_t i = 0; i < count; ++i) places_.push_back(surface_->at(surface_->spread(i, count)));
}

EvenStreamlines::~EvenStreamlines() = default;

double EvenStreamlines::unitWorld() const
{
    return surface_->unitWorld();
}

double EvenStreamlines::spacing(int level) const
{
    return std::ldexp(coarsest_, -level);
}

bool EvenStreamlines::canRefine() const
{
    constexpr int givesUp = 5;  // Where no line is long enough on so many levels.
    const double apart = spacing(levels_);
    return surface_->area() > 0 && levels_ < kMostLevels && !(lines_.empty() && levels_ > givesUp) &&
           surface_->area() <= kMostSquares * apart * apart;
}

void EvenStreamlines::refineTo(int level)
{
    while (levels_ <= level && canRefine()) {
        StreamlineLevel next(*surface_, levels_, spacing(levels_), lines_, ends_, chains_);
        next.run();
        ++levels_;
    }
}

}  // namespace aeolic
