#include "render/gl/edges/edges.h"

#include <algorithm>
#include <array>

#include "render/antialias.h"
#include "render/gl/device/dispatch.h"
#include "render/gl/device/gl_limits.h"
#include "render/limits.h"

namespace aeolic::gl {
namespace {

constexpr int kBlock = 8;                    // Pixels, in both directions: a workgroup of edge_mask.comp.
constexpr GLuint kGroupSize = 64;            // Of the other programs here.
constexpr std::array<GLuint, 4> kNoEdges{};  // How an EdgeList (edge_list.glsl) begins.
constexpr std::size_t kListedBytes = 2 * sizeof(GLuint), kSampleBytes = std::size_t{2} * sizeof(GLuint);

/// How high and wide a triangle is at most whose coordinates' products fit 32 bits (narrowCross()), and one whose
/// blocks a workgroup looks through in a few steps.
constexpr GLint kMostNarrowPx = 24, kMostMediumPx = 128;

/// How many workgroups share a triangle of each kind: small, medium, large (edge_near.comp). Of the small ones a
/// workgroup draws several.
constexpr std::array<int, 3> kShares{0, 1, 32};

/// Binding points of storage buffers; those of the mesh are before.
enum : GLuint { kBlocks = 2, kList = 3, kTrianglesNear = 4, kPixels = 4, kSamples = 5, kOpen = 6 };

constexpr GLint kHeldLocation = 20;

float slackPerDepth(const View& view)
{
    return 0.5f * limits::kSlackFootprints / view.focalPx;
}

std::size_t pixelsOf(const Extent& rows)
{
    return std::size_t(rows.width()) * std::size_t(rows.height());
}

}  // namespace

Edges::Edges(bool isProgram)
    : lanes_(isProgram ? 1 : antialias::kSamples),
      mostSmallPx_(isProgram ? kMostNarrowPx : kMostNarrowPx / 2),
      listGroups_(isProgram ? 64 : 2048),
      noEdges_(sizeof kNoEdges, 0, kNoEdges.data()),
      mostHeld_(std::max<std::size_t>(deviceLimits().block / (antialias::kSamples * kSampleBytes), 1))
{
}

void Edges::reserve(const Pass& pass, const Extent& compute)
{
    held_ = std::min(pixelsOf(compute), mostHeld_);
    samples_.reserve(held_ * antialias::kSamples * kSampleBytes);
    list_.reserve(sizeof kNoEdges + pixelsOf(compute) * kListedBytes).begin(noEdges_);
    blocks_.reserve(std::size_t((compute.width() + kBlock - 1) / kBlock) *
                    std::size_t((compute.height() + kBlock - 1) / kBlock) * 4 * sizeof(GLuint));
    near_.reserve(2 * pass.scene.triangles() * sizeof(GLuint));
}

void Edges::findEdges(const Pass& pass, const Extent& compute) const
{
    const GLuint program = pass.programs.compute("edge_mask");
    setFloats(program, 1, slackPerDepth(pass.view));
    setInts(program, 2, pass.palette.lighting);
    pass.images.visible.bind(0);
    pass.images.surface.bind(1);
    bindStorage(kBlocks, blocks_.get());
    bindStorage(kList, list_.get());
    dispatchOver(program, compute, kBlock);
}

void Edges::listTriangles(const Pass& pass, const Extent& compute) const
{
    constexpr GLuint kMostGroups = 1u << 15;  // One dimension alone may be too short.
    const GLuint triangles = GLuint(pass.scene.triangles()), groups = (triangles + kGroupSize - 1) / kGroupSize;
    if (groups == 0) return;
    const GLuint program = pass.programs.compute("edge_near");
    setExtent(program, 0, compute);
    setUnsigned(program, 1, triangles);
    setInts(program, 2, mostSmallPx_, kMostMediumPx);
    setInts(program, 3, pass.view.frontFacesOnly);
    pass.scene.bindMesh();
    bindStorage(kBlocks, blocks_.get());
    bindStorage(kList, list_.get());
    bindStorage(kTrianglesNear, near_.get());
    dispatch(program, std::min(groups, kMostGroups), (groups + kMostGroups - 1) / kMostGroups);
}

void Edges::drawSamples(const Pass& pass, const Extent& compute, std::size_t first) const
{
    std::array<GLint, std::size_t(2 * antialias::kSamples)> places{};
    constexpr int kSubpixelsPerPart = 256 / antialias::kParts;
    for (std::size_t s = 0; s < std::size_t(antialias::kSamples); ++s) {
        places[2 * s] = antialias::kRight[s] * kSubpixelsPerPart;
        places[2 * s + 1] = antialias::kDown[s] * kSubpixelsPerPart;
    }
    const GLuint clear = pass.programs.compute("edge_clear");
    setInts(clear, kHeldLocation, GLint(first), GLint(held_));
    pass.scene.bindMesh();
    bindStorage(kBlocks, blocks_.get());
    bindStorage(kList, list_.get());
    bindStorage(kTrianglesNear, near_.get());
    bindStorage(kSamples, samples_.get());
    dispatch(clear, listGroups_);
    for (const bool naming : {false, true})
        for (const int shares : kShares) {
            const GLuint program = pass.programs.compute("edge_samples", {{"SHARES", shares}, {"LANES", lanes_}});
            setExtent(program, 0, compute);
            setUnsigned(program, 1, GLuint(pass.scene.triangles()));
            setInts(program, 2, naming);
            setInts(program, 3, pass.view.frontFacesOnly);
            setFloats(program, 4, pass.view.farInvDepth);
            setPairs(program, 5, antialias::kSamples, places.data());
            setInts(program, kHeldLocation, GLint(first), GLint(held_));
            dispatch(program, listGroups_);
        }
}

void Edges::findColors(const Pass& pass, const Extent& shown, const Buffer& pixels, const Buffer& open,
                       std::size_t first) const
{
    std::array<GLfloat, std::size_t(2 * antialias::kSamples)> places{};
    for (std::size_t s = 0; s < std::size_t(antialias::kSamples); ++s) {
        places[2 * s] = float(antialias::kRight[s]) / float(antialias::kParts);
        places[2 * s + 1] = float(antialias::kDown[s]) / float(antialias::kParts);
    }
    const GLuint program = pass.programs.compute("edge_colors");
    setExtent(program, 1, shown);
    setFloats(program, 2, slackPerDepth(pass.view));
    setPairs(program, 3, antialias::kSamples, places.data());
    setInts(program, kHeldLocation, GLint(first), GLint(held_));
    pass.images.visible.bind(2);
    pass.images.surface.bind(3);
    pass.images.bindColors(4, 5);
    bindStorage(kPixels, pixels);
    bindStorage(kOpen, open);
    dispatch(program, listGroups_);
}

void Edges::run(const Pass& pass, const Extent& compute, const Extent& shown, const Buffer& pixels, const Buffer& open)
{
    if (compute.empty()) return;
    reserve(pass, compute);
    findEdges(pass, compute);
    listTriangles(pass, compute);
    for (std::size_t first = 0; first < pixelsOf(compute); first += held_) {
        drawSamples(pass, compute, first);
        findColors(pass, shown, pixels, open, first);
    }
    const GLuint mix = pass.programs.compute("edge_mix");
    setExtent(mix, 1, shown);
    dispatch(mix, listGroups_);
}

}  // namespace aeolic::gl
