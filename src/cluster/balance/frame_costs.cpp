#include "cluster/balance/frame_costs.h"

#include <algorithm>
#include <cmath>

namespace aeolic {
namespace {

// Measured: a Runge-Kutta step of the direct method, in both directions; and what it takes the hierarchical method to
// double its length.
constexpr double kDirectStepNs = 4.6, kDoublingNs = 8;
// The size of a guard pixel's flow and links, and of its jumps of one level in both directions.
constexpr int kFlowBytes = 5, kLevelBytes = 16, kLevels = 2;
// Measured where a SIMD vector holds 16 pixels of a row. A vector that is not full of covered pixels takes as long as
// one that is.
constexpr double kRunPixels = 15;
constexpr double kCountTriangleNs = 10;  // Counting what a triangle covers, at a part of the resolution.
constexpr double kCopyNsPerByte = 0.16;  // Copying into the message and out of it.

double guardAgainNs(const FrameCosts& costs, const LicOptions& lic)
{
    return costs.projectNs + (lic.method == LicMethod::hierarchical ? costs.convolveNs : 0.0);
}

}  // namespace

int guardPixelBytes(const LicOptions& lic)
{
    return lic.method == LicMethod::hierarchical ? kFlowBytes + kLevels * kLevelBytes : kFlowBytes;
}

FrameCosts frameCosts(const LicOptions& lic, const NetworkModel& network)
{
    FrameCosts costs;
    const double parts = lic.integrator == Integrator::euler ? 0.5 : lic.integrator == Integrator::rk4 ? 2.0 : 1.0;
    costs.convolveNs = lic.method == LicMethod::none     ? 0
                       : lic.method == LicMethod::direct ? kDirectStepNs * lic.steps * parts
                                                         : kDoublingNs * (1 + std::log2(double(lic.steps)));
    costs.runNs = kRunPixels * costs.projectNs;
    // When a trace of the direct method ends, another takes its place, so vectors stay full.
    if (lic.method == LicMethod::hierarchical) costs.runNs += kRunPixels * costs.convolveNs;
    costs.copyNs = guardPixelBytes(lic) * kCopyNsPerByte;
    costs.receiveNs = costs.copyNs + guardPixelBytes(lic) * 1e9 / network.bandwidthBytesPerS;
    return costs;
}

GuardSource cheaperGuard(const FrameCosts& costs, const LicOptions& lic, int width, int guardRows, int messages,
                         const NetworkModel& network)
{
    const double pixels = 2.0 * guardRows * width;
    const double againNs = pixels * guardAgainNs(costs, lic);
    const double receivedNs = pixels * costs.receiveNs + messages * network.latencyUs * 1e3;
    return againNs <= receivedNs ? GuardSource::project : GuardSource::receive;
}

bool cheaperShared(std::int64_t triangles, std::int64_t bytes, int ranks, const NetworkModel& network)
{
    const double sparedMs = double(triangles) * kCountTriangleNs * (1 - 1.0 / ranks) * 1e-6;
    return network.collectiveMs(ranks, collectiveRounds(ranks) * bytes) < sparedMs;
}

StripeCosts stripeCosts(const FrameCosts& costs, const LicOptions& lic, GuardSource source, int width, int guardRows,
                        double receivedPart)
{
    const bool again = source == GuardSource::project;
    const double guardNs = std::min(again ? guardAgainNs(costs, lic) : receivedPart * costs.copyNs, costs.pixelNs());
    const double rowNs = width * (costs.projectAreaNs + costs.convolveAreaNs + costs.shadeNs);
    const double guardRowNs = width * (costs.convolveAreaNs + (again ? costs.projectAreaNs : 0.0));
    return {guardRows, guardNs / costs.pixelNs(), rowNs / costs.pixelNs(), guardRowNs / costs.pixelNs(),
            costs.runNs / costs.pixelNs()};
}

}  // namespace aeolic
