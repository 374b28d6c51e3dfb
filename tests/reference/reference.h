#pragma once

/// The scalar double-precision reference of the three stages: small, slow and obviously right. The tests' oracle and
/// nothing else; no backend uses it.

#include <array>
#include <vector>

#include "render/gbuffer.h"
#include "render/lic/noise.h"
#include "render/palette.h"
#include "render/view.h"

namespace aeolic::reference {

struct Pixel {
    double invDepth = 0;  ///< 0: background.
    double gradX = 0, gradY = 0;
    double vx = 0, vy = 0;  ///< Pixels per step.
    double noise = 0;       ///< -1 … 1
    double light = 0, scalar = 0;
    bool hasFlow = false;
    std::array<bool, 9> linked{};  ///< [(sy + 1) * 3 + sx + 1]
    long triangle = -1;
};

struct PixelImage {
    int width = 0, height = 0;
    std::vector<Pixel> pixels;

    PixelImage(int w, int h) : width(w), height(h), pixels(std::size_t(w) * std::size_t(h)) {}
    bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
    Pixel& at(int x, int y) { return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
    const Pixel& at(int x, int y) const { return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
};

/// Projection stage: every pixel's ray against every triangle. Cost: pixels x triangles.
PixelImage project(const View& view, const Scene& scene, const NoisePyramid& noise);

/// A backend's G-buffer as the reference's own type, so that stages can be compared one at a time.
PixelImage fromGBuffer(const GBuffer& buffer);

/// The noise pyramid at a local P-space position for a footprint in world units, -1 … 1 (may exceed it a little).
double noiseAt(const NoisePyramid& noise, const NoiseLookup& lookup, const glm::dvec3& local, double footprint);

/// Trilinear interpolation of a grid's sample; NaN outside or where masked.
glm::dvec3 sampleField(const GridField& field, const glm::dvec3& positionWorld);

/// LIC stage. Steps are divided by `substeps` (4: quarter steps); normalised by the contrast model like the backends'.
/// [width * height], 0 where there is no flow.
std::vector<double> convolve(const PixelImage& image, const LicOptions& lic, int substeps = 1);

/// The second convolution (along_flow.h) of `values`, whatever `lic` says of streaks.
std::vector<double> smooth(const PixelImage& image, const std::vector<double>& values, const LicOptions& lic);

/// The last step of even streaks (flatten.h), without rounding to whole numbers. The square reaches `reachPx` beyond
/// its middle.
std::vector<double> flatten(const PixelImage& image, const std::vector<double>& values, int reachPx);

/// Blending stage: RGBA per pixel, before rounding, 0 … 255.
std::vector<std::array<double, 4>> shade(const PixelImage& image, const std::vector<double>& lic,
                                         const Palette& palette);

}  // namespace aeolic::reference
