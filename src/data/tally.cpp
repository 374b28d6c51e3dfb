#include "data/tally.h"

#include <fmt/format.h>

#include "base/half.h"

namespace aeolic {
namespace {

std::string leftBlank(const Tally& tally, const char* unit)
{
    std::string what = tally.found > 0 ? fmt::format("{} masked", tally.found) : "";
    if (tally.also > 0) what += fmt::format("{}{} not finite", what.empty() ? "" : ", ", tally.also);
    return fmt::format("{}: {} of {} {}, left blank", tally.where, what, tally.all, unit);
}

std::vector<std::string> ofHalves(const Tally& tally)
{
    constexpr double kShortest = 0x1p-10;
    std::vector<std::string> warnings;
    if (tally.longest > 0 && tally.longest < kShortest)
        warnings.push_back(
            fmt::format("{}: the longest vector is {:.3g}; in half precision vectors this short lose accuracy",
                        tally.where, tally.longest));
    if (tally.found > 0)
        warnings.push_back(fmt::format("{}: {} values beyond {}, the largest half, were set to it", tally.where,
                                       tally.found, kLargestHalf));
    return warnings;
}

}  // namespace

std::vector<std::string> warningsOf(const Tally& tally)
{
    if (tally.of == Tally::Of::halves) return ofHalves(tally);
    if (tally.found + tally.also == 0) return {};
    switch (tally.of) {
        case Tally::Of::maskedPoints:
            return {leftBlank(tally, "points")};
        case Tally::Of::maskedCells:
            return {leftBlank(tally, "cells")};
        case Tally::Of::corners:
            return {fmt::format("{}: {} of {} cells left out: a corner is not finite", tally.where, tally.found,
                                tally.all)};
        case Tally::Of::areas:
            return {
                fmt::format("{}: {} of {} triangles left out: they have no area", tally.where, tally.found, tally.all)};
        case Tally::Of::halves:
            break;
    }
    return {};
}

}  // namespace aeolic
