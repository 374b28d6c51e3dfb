#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "render_testing.h"

/// The contrast gain follows from the kernel alone; these tests hold it against images.
namespace aeolic {
namespace {

using namespace testkit;

struct Case {
    int steps = 16;
    double noiseScale = 1, stepPx = 1;
    Kernel kernel = Kernel::box;
    Style style = Style::dense;
};

/// Sum of squares and count of the LIC of a uniform flow on a plane that faces the camera, where whole kernels fit.
struct Squares {
    double sum = 0, count = 0;
};
Squares squaresOf(const std::string& backend, const Case& c, double distance, std::uint32_t seed)
{
    constexpr double slope = 0.15;  // Along no axis, so that samples lie everywhere between pixels.
    const int reach = int(std::ceil(c.steps * c.stepPx)) + 1, rise = int(std::ceil(slope * reach)) + 1;
    // Rows where long kernels do not fit need not be computed, but every row is computed in its whole width.
    const bool isDown = reach > 150;
    const glm::vec3 flow = isDown ? glm::vec3(slope, 1, 0) : glm::vec3(1, slope, 0);
    SurfaceMesh mesh = makeRectangle({0, 0, 0}, {40, 0, 0}, {0, 40, 0});
    setPointVectors(mesh, [&](const glm::dvec3&) { return flow; });
    const int marginX = isDown ? rise : reach, marginY = isDown ? reach : rise;
    const int width = 2 * marginX + (isDown ? 200 : 100), height = 2 * marginY + (isDown ? 100 : 200);
    Stages stages(backend, makeScene(std::move(mesh)), seed);
    LicOptions lic = directLic(c.steps, Integrator::euler, c.kernel);  // Exact in a uniform flow.
    lic.style = c.style;
    lic.noiseScale = c.noiseScale;
    lic.step = c.stepPx;
    stages.project(frontCamera(stages.scene, distance, width, height), lic);
    const Image<float>& found = stages.convolve(lic, {0, marginY, width, height - marginY});
    Squares squares;
    for (int y = marginY; y < height - marginY; ++y)
        for (int x = marginX; x < width - marginX; ++x) {
            squares.sum += double(found.at(x, y)) * double(found.at(x, y));
            ++squares.count;
        }
    return squares;
}

/// Measures at three distances within an octave: between two levels of the noise its grain is a little finer or
/// coarser. Each distance is measured with `tiles` noises, because one alone is off by a tenth.
double contrastOf(const std::string& backend, const Case& c, int tiles = 1)
{
    Squares all;
    for (int i = 0; i < 3 * tiles; ++i) {
        const Squares one = squaresOf(backend, c, 3 * std::exp2(i / 3.0 / tiles), std::uint32_t(1 + i));
        all.sum += one.sum;
        all.count += one.count;
    }
    return std::sqrt(all.sum / all.count);
}

class Contrast : public BackendTest {};
INSTANTIATE_TEST_SUITE_P(Backends, Contrast, allBackends, backendName);

class ContrastLong : public BackendTest {};
INSTANTIATE_TEST_SUITE_P(Backends, ContrastLong, allBackends, backendName);

void expectUnitVariance(const std::string& backend, int steps, int tiles = 1)
{
    for (const double noiseScale : {0.5, 1.0})
        for (const Kernel kernel : {Kernel::box, Kernel::hann}) {
            Case c;
            c.steps = steps;
            c.noiseScale = noiseScale;
            c.kernel = kernel;
            EXPECT_NEAR(contrastOf(backend, c, tiles), 1, 0.15)
                << steps << " steps, noise scale " << noiseScale << (kernel == Kernel::box ? ", box" : ", hann");
        }
}

void expectUnitVarianceOfStep(const std::string& backend, double stepPx, int tiles = 1)
{
    Case c;
    c.steps = 64;
    c.stepPx = stepPx;
    EXPECT_NEAR(contrastOf(backend, c, tiles), 1, 0.15) << "step " << stepPx;
}

constexpr int kEnoughTiles = 4;  // Streaks are longer than a tile is wide.

TEST_P(Contrast, UnitVarianceForAnyKernelLengthAndNoise)
{
    for (const int steps : {16, 128}) expectUnitVariance(GetParam(), steps);
    if (GetParam() == "cpu") expectUnitVariance(GetParam(), 512, kEnoughTiles);
}

/// Samples farther apart than the noise's grain are independent: then their number counts, not the length walked.
TEST_P(Contrast, UnitVarianceForStepsLongerThanTheGrain)
{
    for (const double stepPx : {0.25, 2.0, 4.0}) expectUnitVarianceOfStep(GetParam(), stepPx);
    if (GetParam() == "cpu") expectUnitVarianceOfStep(GetParam(), 8, kEnoughTiles);
}

/// Oriented streaks have a little less, for their heads to stay below white. What they have is the same for any kernel,
/// grain and step. One distance alone is off by a quarter: a line crosses few grains.
TEST_P(Contrast, OrientedStreaksHaveTheSameAtAnyLength)
{
    const auto expectContrast = [&](int steps, double noiseScale, double stepPx) {
        Case c;
        c.style = Style::oriented;
        c.steps = steps;
        c.noiseScale = noiseScale;
        c.stepPx = stepPx;
        EXPECT_NEAR(contrastOf(GetParam(), c, kEnoughTiles), 0.8, 0.12)
            << steps << " steps, noise scale " << noiseScale << ", step " << stepPx;
    };
    for (const double noiseScale : {0.5, 1.0, 2.0})
        for (const int steps : {25, 128}) expectContrast(steps, noiseScale, 1);
    if (GetParam() == "cpu") expectContrast(640, 1, 1);
    for (const double stepPx : {0.5, 2.0, 4.0}) expectContrast(128, 1, stepPx);
}

TEST_P(ContrastLong, UnitVarianceOfTheLongestStreaks)
{
    expectUnitVariance(GetParam(), 512, kEnoughTiles);
}
TEST_P(ContrastLong, UnitVarianceOfTheLongestSteps)
{
    expectUnitVarianceOfStep(GetParam(), 8, kEnoughTiles);
}

TEST_P(Contrast, UnitVarianceOfTheBareNoiseWhereNothingFlows)
{
    SurfaceMesh mesh = makeRectangle({0, 0, 0}, {40, 0, 0}, {0, 40, 0});
    setPointVectors(mesh, [](const glm::dvec3&) { return glm::vec3(0); });
    Stages stages(GetParam(), makeScene(std::move(mesh)));
    std::vector<double> values;
    for (const double distance : {3.0, 3.8, 4.8}) {
        stages.project(frontCamera(stages.scene, distance, 150, 150), directLic(16));
        const Image<float>& found = stages.convolve(directLic(16));
        for (int y = 0; y < 150; ++y)
            for (int x = 0; x < 150; ++x) values.push_back(double(found.at(x, y)));
    }
    EXPECT_NEAR(standardDeviation(values), 1, 0.15);
}

}  // namespace
}  // namespace aeolic
