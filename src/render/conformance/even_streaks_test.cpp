#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "reference/reference.h"
#include "render/lic/lic_kernel.h"
#include "render_testing.h"

/// Even streaks: noise counts by the width of the stream tube. Flows whose tubes are known, and every backend.
namespace aeolic {
namespace {

using namespace testkit;
using reference::Pixel;
using reference::PixelImage;

constexpr int kSize = 201, kCenter = 100;

/// A whole sheet with the same noise everywhere, so that a value is the gain and shows the weights alone. `flow` gives
/// the unit direction at a place seen from the middle.
template <class Flow>
PixelImage sheet(const Flow& flow)
{
    PixelImage image(kSize, kSize);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            Pixel& p = image.at(x, y);
            const glm::dvec2 v = flow(double(x - kCenter), double(y - kCenter));
            p.invDepth = p.noise = 1;
            p.vx = v.x;
            p.vy = v.y;
            p.hasFlow = v != glm::dvec2(0);
            for (int k = 0; k < 9; ++k) p.linked[std::size_t(k)] = image.contains(x + k % 3 - 1, y + k / 3 - 1);
        }
    return image;
}

LicOptions streaks(Streaks kind, int steps)
{
    LicOptions lic = directLic(steps);
    lic.streaks = kind;
    return lic;
}

double valueAt(const PixelImage& image, const LicOptions& lic, int x, int y)
{
    return reference::convolve(image, lic, 4)[std::size_t(y + kCenter) * kSize + std::size_t(x + kCenter)];
}

double gainOf(const LicOptions& lic, double pixels)
{
    const ContrastModel contrast = makeContrastModel(lic);
    return std::pow(double(contrast.zeroLength) + pixels * pixels * double(contrast.perLength), 0.25);
}

glm::dvec2 outward(double x, double y)
{
    const double r = std::hypot(x, y);
    return r > 0 ? glm::dvec2(x / r, y / r) : glm::dvec2(0);
}

TEST(EvenStreaks, UniformFlowStaysAsItIs)
{
    const PixelImage image = sheet([](double, double) { return glm::dvec2(0.8, 0.6); });
    EXPECT_EQ(valueAt(image, streaks(Streaks::even, 30), 3, 5), valueAt(image, streaks(Streaks::plain, 30), 3, 5));
}

TEST(EvenStreaks, PureRotationStaysAsItIs)
{
    const PixelImage image = sheet([](double x, double y) { return 0.01 * glm::dvec2(-y, x); });
    EXPECT_DOUBLE_EQ(valueAt(image, streaks(Streaks::even, 90), 60, 5),
                     valueAt(image, streaks(Streaks::plain, 90), 60, 5));
}

/// Upstream the tube is as wide as the way to the source; downstream it only widens, which does not count.
TEST(EvenStreaks, TowardsASourceTheWeightFallsAsTheRadius)
{
    const PixelImage image = sheet(outward);
    const int from = 50;
    for (const int steps : {10, 30, 45}) {
        const LicOptions lic = streaks(Streaks::even, steps);
        const double end = double(from - steps), up = (from * from - end * end) / (2 * from), down = steps;
        const double total = 1 + up + down, squares = 1 + down + 0.5 * up * (1 + end / from);
        const double expected = gainOf(lic, total * total / squares);
        EXPECT_NEAR(valueAt(image, lic, from, 0), expected, 0.01 * expected) << steps << " steps";
    }
}

/// The closed form of the gain is exact for weights that fall exponentially. These fall in proportion to the way.
TEST(EvenStreaks, TheGainIsThatOfTheWeightsSquares)
{
    const PixelImage image = sheet(outward);
    const int from = 50, steps = 45;
    double sum = 0, squares = 0;
    for (int i = -steps; i <= steps; ++i) {
        const double weight = i < 0 ? double(from + i) / from : 1;
        sum += weight;
        squares += weight * weight;
    }
    const LicOptions lic = streaks(Streaks::even, steps);
    EXPECT_NEAR(valueAt(image, lic, from, 0) / gainOf(lic, sum * sum / squares), 1, 0.05);
}

class EvenStreaksOf : public BackendTest {};
INSTANTIATE_TEST_SUITE_P(Backends, EvenStreaksOf, allBackends, backendName);

/// The ends of a meridian, where all streamlines merge; a whirl; and both kinds of streaks.
TEST_P(EvenStreaksOf, EveryBackendWeighsAsTheReferenceDoes)
{
    for (const char* field : {"tornado:32,32,32", "abc:32,32,32"}) {
        Stages stages(GetParam(), makeBuiltinScene("sphere:4000", field));
        const Camera camera = fitCamera(stages.scene, {}, 120, 90);
        for (const Streaks kind : {Streaks::plain, Streaks::even}) {
            const LicOptions lic = streaks(kind, 64);
            const GBuffer& buffer = stages.project(camera, lic);
            const std::vector<double> expected = reference::convolve(reference::fromGBuffer(buffer), lic);
            const Image<float>& found = stages.convolve(lic);
            std::vector<double> a, b;
            for (int y = 0; y < 90; ++y)
                for (int x = 0; x < 120; ++x)
                    if (buffer.flow.at(x, y) != 0) {
                        a.push_back(double(found.at(x, y)));
                        b.push_back(expected[std::size_t(y * 120 + x)]);
                    }
            EXPECT_GE(correlation(a, b), 0.999) << field << (kind == Streaks::even ? ", even" : ", plain");
        }
    }
}

/// The weights are what makes the difference, not rounding: where tubes narrow the two kinds differ.
TEST_P(EvenStreaksOf, DifferWhereStreamlinesMerge)
{
    Stages stages(GetParam(), makeBuiltinScene("sphere:4000", "abc:32,32,32"));
    stages.project(fitCamera(stages.scene, {}, 120, 90), streaks(Streaks::even, 64));
    const auto valuesOf = [&](Streaks kind) {
        const Image<float>& found = stages.convolve(streaks(kind, 64));
        std::vector<float> values;
        for (int y = 0; y < 90; ++y) values.insert(values.end(), found.row(y), found.row(y) + 120);
        return values;
    };
    const std::vector<float> plain = valuesOf(Streaks::plain), even = valuesOf(Streaks::even);
    int different = 0;
    for (std::size_t i = 0; i < plain.size(); ++i) different += std::abs(plain[i] - even[i]) > 0.1f;
    EXPECT_GT(different, 500);
}

}  // namespace
}  // namespace aeolic
