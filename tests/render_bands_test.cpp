#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "render_testing.h"

/// A band of rows is a scissor of the whole image, not an image of its own: the same bits, whoever draws it.
namespace aeolic {
namespace {

using namespace testkit;

class RenderBands : public BackendTest {};
INSTANTIATE_TEST_SUITE_P(Backends, RenderBands, allBackends, backendName);

constexpr int kWidth = 160, kHeight = 240;

Scene teapot()
{
    Scene scene = makeBuiltinScene("teapot:20000", "abc:32,32,32");
    scene.hasScalar = true;
    scene.ofVectors = ArrayPart::length;
    return scene;
}

Camera closeCamera(const Scene& scene)
{
    CameraOptions options;
    options.zoom = 1.8;
    return fitCamera(scene, options, kWidth, kHeight);
}

template <class T>
bool sameBits(T a, T b)
{
    return std::memcmp(&a, &b, sizeof a) == 0;
}

TEST_P(RenderBands, ProjectionOfABandIsTheWholesRows)
{
    const LicOptions lic = directLic(20);
    Stages whole(GetParam(), teapot()), part(GetParam(), teapot());
    const GBuffer& all = whole.project(closeCamera(whole.scene), lic);
    for (const auto& [y0, y1] :
         {std::pair(0, 100), std::pair(100, 200), std::pair(77, 78), std::pair(239, 240), std::pair(63, 131)}) {
        part.backend->project(whole.view, {0, y0, kWidth, y1});
        const GBuffer& band = part.backend->probe().gbuffer();
        for (int y = y0; y < y1; ++y)
            for (int x = 0; x < kWidth; ++x) {
                ASSERT_TRUE(sameBits(all.invDepth.at(x, y), band.invDepth.at(x, y))) << x << "," << y;
                ASSERT_EQ(all.flow.at(x, y), band.flow.at(x, y)) << x << "," << y;
                if (!(all.invDepth.at(x, y) > 0)) continue;
                ASSERT_TRUE(sameBits(all.gradX.at(x, y), band.gradX.at(x, y))) << x << "," << y;
                ASSERT_TRUE(sameBits(all.gradY.at(x, y), band.gradY.at(x, y))) << x << "," << y;
                ASSERT_TRUE(sameBits(all.light.at(x, y), band.light.at(x, y))) << x << "," << y;
                ASSERT_TRUE(sameBits(all.scalar.at(x, y), band.scalar.at(x, y))) << x << "," << y;
                const bool neighboursKnown = (y > y0 || y0 == 0) && (y < y1 - 1 || y1 == kHeight);
                ASSERT_TRUE(!neighboursKnown || all.links.at(x, y) == band.links.at(x, y)) << x << "," << y;
            }
    }
}

/// Guard rows as far as a trace can go, one for interpolation and one for links, are enough.
TEST_P(RenderBands, LineIntegralsOfABandAreTheWholesRows)
{
    Stages whole(GetParam(), teapot()), part(GetParam(), teapot());
    for (const Integrator integrator : {Integrator::euler, Integrator::rk2, Integrator::rk4})
        for (const double stepPx : {1.0, 2.5}) {
            LicOptions lic = directLic(15, integrator);
            lic.step = stepPx;
            whole.project(closeCamera(whole.scene), lic);
            const Image<float>& all = whole.convolve(lic);
            const LicOptions walked = inShortSteps(lic, whole.view);
            const int guard = int(std::ceil(walked.steps * double(whole.view.maxStepPx))) + 2;
            for (const auto& [y0, y1] :
                 {std::pair(0, 90), std::pair(90, 133), std::pair(133, 134), std::pair(200, 240)}) {
                const Extent valid{0, std::max(0, y0 - guard), kWidth, std::min(kHeight, y1 + guard)},
                    compute{0, y0, kWidth, y1};
                part.backend->project(whole.view, valid);
                part.backend->convolve(walked, compute);
                const Image<float>& found = part.backend->probe().lic();
                for (int y = y0; y < y1; ++y)
                    for (int x = 0; x < kWidth; ++x)
                        ASSERT_TRUE(sameBits(all.at(x, y), found.at(x, y)))
                            << x << "," << y << " of rows " << y0 << " to " << y1;
            }
        }
}

TEST_P(RenderBands, ShadingOfABandIsTheWholesRows)
{
    const LicOptions lic = directLic(20);
    Stages whole(GetParam(), teapot());
    const GBuffer& buffer = whole.project(closeCamera(whole.scene), lic);
    whole.convolve(lic);
    const Palette palette = makePalette({}, true, {0, 3});
    Tile all, pieces;
    all.resize(buffer.valid());
    pieces.resize(buffer.valid());
    whole.backend->shade(palette, buffer.valid(), all);
    whole.backend->finish();
    for (const auto& [y0, y1] : {std::pair(0, 1), std::pair(1, 100), std::pair(100, 237), std::pair(237, 240)})
        whole.backend->shade(palette, {0, y0, kWidth, y1}, pieces), whole.backend->finish();
    EXPECT_TRUE(all.rgba == pieces.rgba);
}

}  // namespace
}  // namespace aeolic
