#pragma once

#include <array>
#include <cstdint>

#include "data/vector_field.h"
#include "render/lic/jump_plan.h"
#include "render/palette.h"
#include "render/view.h"

/// The shaders' uniform blocks, laid out by std140; each has its like in shaders/.
namespace aeolic::gl {

/// Binding points of the blocks, the same in every program.
enum : unsigned { kViewBinding = 0, kFieldBinding = 1, kTilingBinding = 2, kJumpBinding = 3, kPaletteBinding = 4 };

using Vec4 = std::array<float, 4>;

struct ViewBlock {  // view.glsl
    Vec4 eyeAndFocal, rightAndCenterX, upAndCenterY, forwardAndNear;
    Vec4 noiseRow[3];
    Vec4 clipScale;
    float stepLocal, vectorScale, tinyVector, maxStepPx;
    float flowUnitPx, inverseFocal, levelFromFootprint, maskBelow;
    std::int32_t imageSize[2], firstRow, rows;
    std::uint32_t normalizeSteps;
    float vectorFactor, vectorUnit;
    std::uint32_t grains;
    float fadePerVector, unused[3];
};
static_assert(sizeof(ViewBlock) == 208);

/// The LIC stage computes in tiles of so many pixels squared; a row of workgroups has kRowOfTiles of them, for one
/// dimension alone may be too short.
inline constexpr int kNearTile = 16, kRowOfTiles = 1024;

/// Textures hold `rows` of the image from `firstRow` on.
ViewBlock makeViewBlock(const View& view, int firstRow, int rows);

struct FieldLookup {  // field.glsl
    Vec4 scale{}, offset{}, top{}, cellLo{}, cellHi{};
    std::int32_t firstSample[4] = {};
};
FieldLookup makeFieldLookup(const GridField& field, const glm::dvec3& originWorld, double unitWorld);

struct TilingBlock {  // tiles.glsl
    std::int32_t size[2], tiles[2], rows[2], unused[2];
};

struct JumpBlock {                                   // jumps.glsl
    static constexpr int kLevels = kMostLevels + 1;  // The last is the remainder's.
    Vec4 units[kLevels], perUnit[kLevels];
    std::int32_t counts[kLevels][4];
    std::int32_t levels, directSteps, remainderSteps, unused;
};

struct PaletteBlock {  // surface_color.glsl
    Vec4 plain;        // shading::PlainSurface
    float contrast;
    std::uint32_t background, useScalar, several, lighting, hasLic, occlusion, unused;
};
PaletteBlock makePaletteBlock(const Palette& palette, bool hasLic);

struct ColorTable {  // surface_color.glsl
    std::array<std::uint32_t, ScalarColors::kAll> base, dark, bright;
    std::array<float, ScalarColors::kEntries> edges;
    float scalarLo, lowest, highest, entriesPerScalar, lastEntry;
    std::uint32_t searched;
};
/// The palette's own, or those of several surfaces.
std::vector<ColorTable> makeColorTables(const Palette& palette);
inline constexpr unsigned kColorTablesBinding = 7;  ///< Their binding among the storage buffers.

}  // namespace aeolic::gl
