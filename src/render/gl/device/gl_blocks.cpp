#include "render/gl/device/gl_blocks.h"

#include <bit>

#include "render/shading_model.h"

namespace aeolic::gl {
namespace {

Vec4 vec4(const glm::vec3& v, float w)
{
    return {v.x, v.y, v.z, w};
}

}  // namespace

ViewBlock makeViewBlock(const View& view, int firstRow, int rows)
{
    ViewBlock block{};
    block.eyeAndFocal = vec4(view.eyeLocal, view.focalPx);
    block.rightAndCenterX = vec4(view.right, view.centerX);
    block.upAndCenterY = vec4(view.up, view.centerY);
    block.forwardAndNear = vec4(view.forward, float(view.nearDepth));
    for (int r = 0; r < 3; ++r) {
        const auto& m = view.noise.texelFromLocal;
        block.noiseRow[r] = {float(m[0][r]), float(m[1][r]), float(m[2][r]), 0};
    }
    const double width = view.camera.width, height = view.camera.height;
    // Row 0 is at the top (GL_UPPER_LEFT), where NDC's y is 1.
    block.clipScale = {float(2 * double(view.focalPx) / width), float(2 * double(view.focalPx) / height),
                       float(2 * double(view.centerX) / width - 1), float(1 - 2 * double(view.centerY) / height)};
    block.stepLocal = view.stepLocal;
    block.vectorScale = view.vectorScale;
    block.tinyVector = view.tinyVector;
    block.maxStepPx = view.maxStepPx;
    block.flowUnitPx = view.flowUnitPx;
    block.inverseFocal = 1.0f / view.focalPx;
    block.levelFromFootprint = float(view.noise.levelFromFootprint);
    block.maskBelow = view.maskBelow;
    block.imageSize[0] = view.camera.width;
    block.imageSize[1] = view.camera.height;
    block.firstRow = firstRow;
    block.rows = rows;
    block.normalizeSteps = view.normalize;
    block.vectorFactor = view.vectorFactor;
    block.vectorUnit = view.vectorUnit;
    block.grains = std::uint32_t(view.noise.grains);
    block.fadePerVector = view.fadePerVector;
    return block;
}

FieldLookup makeFieldLookup(const GridField& field, const glm::dvec3& originWorld, double unitWorld)
{
    FieldLookup lookup;
    const GridIndex first = field.firstSample();
    for (int c = 0; c < 3; ++c) {
        const auto a = std::size_t(c);
        lookup.scale[a] = float(unitWorld / field.spacingWorld[c]);
        lookup.offset[a] = float((originWorld[c] - field.originWorld[c]) / field.spacingWorld[c]);
        lookup.top[a] = float(field.dims[a] - 1);
        lookup.cellLo[a] = field.brick ? float(field.brick->cellLo[a]) : 0.0f;
        lookup.cellHi[a] = field.brick ? float(field.brick->cellHi[a]) : lookup.top[a];
        lookup.firstSample[a] = std::int32_t(first[a]);
    }
    return lookup;
}

PaletteBlock makePaletteBlock(const Palette& palette, bool hasLic)
{
    const shading::PlainSurface plain = shading::plainSurface(palette.blend);
    return {{plain.base, plain.dark, plain.bright, 0},
            palette.contrast,
            std::bit_cast<std::uint32_t>(palette.background),
            palette.useScalar,
            !palette.tables.empty(),
            palette.lighting,
            hasLic,
            palette.occlusion,
            0};
}

std::vector<ColorTable> makeColorTables(const Palette& palette)
{
    std::vector<ColorTable> tables;
    const auto add = [&](const ScalarColors& colors) {
        tables.push_back({colors.base, colors.dark, colors.bright, colors.edges, colors.scalarLo, colors.lowest,
                          colors.highest, colors.entriesPerScalar, colors.lastEntry, colors.searched});
    };
    for (const ScalarColors& colors : palette.tables) add(colors);
    if (tables.empty()) add(palette);
    return tables;
}

}  // namespace aeolic::gl
