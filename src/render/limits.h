#pragma once

/// Numbers that the pictures' bytes hang on, each in one place: kernels and cluster code include them, and shaders get
/// them as constants of the same names (render/gl/device/programs.cpp). The layouts of words stand where the words do:
/// flow_texel in gbuffer.h, jump_word in jump_plan.h.
///
/// The proof that a rank has all rows its traces read (docs/cluster.md, "Guard rows") uses most of them. Each of these
/// has a test that fails when the number is one too small, or one too large where that is the danger. The name of the
/// test stands with the number.
namespace aeolic::limits {

// Traces stay on their sheet of the surface (docs/decisions/0005-sheets.md).

/// A trace needs no link looked up where it lands within so many pixels of one on its sheet, in x and y each, and the
/// four pixels around it are open. Farther, and it would cross a border of the sheet unseen. Test: SheetsHold.
inline constexpr int kOpenReachPx = 2;
/// Four pixels are open where they and so many rings of pixels around them are linked to all eight neighbours each. The
/// links of the outermost ring vouch for a pixel more. Test: SheetsHold.
inline constexpr int kOpenRings = kOpenReachPx - 1;
/// An interpolated jump holds where it ends within so many pixels of the end of the nearest pixel's own jump, in x and
/// y each. That end is on the sheet for certain. Where neighbours part further, their mean lies on neither's way, and
/// the trace goes as the nearest pixel does. Test: JumpFootprint.
inline constexpr int kTogetherPx = 2;
/// A trace that ends within so many pixels of a pixel on its sheet needs no link looked up if that pixel is linked to
/// all eight neighbours. Farther, and it might be two pixels away. Test: SheetsHold.
inline constexpr int kSettledPx = 1;

// Rows that a pixel's value depends on (docs/cluster.md).

/// A pixel's links depend on so many rows around it. Test: ReadRows.LinksOfAPixel.
inline constexpr int kLinkRows = 1;
/// What a trace reads between row y and the next depends on rows y - 1 to y + kCellRows: the second tap, and the
/// neighbours that its noise is sharpened against or that the open ones' links are looked up of. Test:
/// ReadRows.FlowCells.
inline constexpr int kCellRows = 1 + kOpenRings;
/// What a pixel reads beyond the row its trace gets to. Where guards are drawn again, the links of the outermost row
/// are not right, for their neighbours are missing. Test: ReadRows.
inline constexpr int kTapRows = kCellRows + kLinkRows;
/// What rounding adds to long ways, at most: of vectors half a unit a step as stored and half as traces read them, of
/// jumps a 32nd for each level, where a unit is up to a 1024th of the longest step; and of positions. Test: GuardRows.
inline constexpr double kRounded = 1 + 1.0 / 512;
/// Flow units that rounding adds to a step at most, on top of that: traces leave a row whose vectors all run along it,
/// too. Test: VectorReach.FlowAlongRowsLeavesThemByRounding.
inline constexpr int kRoundedUnits = 1;
/// A step takes its vector at most so many lengths of the longest step from where it crosses a row: double steps take
/// it half-way, and flow may turn. Test: GuardWalks.
inline constexpr int kVectorSteps = 3;
/// A vector is interpolated from up to so many rows further. Test: GuardWalks.
inline constexpr int kVectorRows = 1;
/// Jumps of one more level begin up to so many rows beside those that they are interpolated from. Test: GuardWalks.
inline constexpr int kLevelRows = 1;
/// Jumps of a block of pixels lead to within a box (JumpBoxes). A trace ends up to kTogetherPx from the end of the
/// nearest pixel's jump, and rounding adds less than a pixel. Test:
/// JumpFootprint.HasWhatTheFarthestTraceReads.
inline constexpr int kJumpMarginPx = kTogetherPx + 1;
/// Flow that traces look at lies within so many pixels of the sheet they are on: kOpenReachPx, and half a pixel from
/// where they are to the nearest. Beyond, images may hold anything. Test: ReadRows.BesideASheet.
inline constexpr int kNearPx = kOpenReachPx + 1;

/// The second convolution reads so many pixels to either side, and so the values of so many rows. Test: AlongFlow.
inline constexpr int kAlongRows = 3;

/// Where edges are smoothed a pixel takes colours from so many rows around it. Test: Edges.
inline constexpr int kEdgeRows = 1;

// What a trace counts.

/// Squared flow units: a streamline ends where the vectors of two samples after each other have a scalar product of no
/// more. Shorter vectors are their own rounding.
inline constexpr float kVanishing = 2.0f;
/// Taps that have ended weigh at least so much where a trace ends with them.
inline constexpr float kLeastWeight = 1e-3f;
/// A stream tube that narrows by less than this share a step keeps its width: vectors' rounding looks like that.
inline constexpr float kSteadyWidth = 1.0f / 1024;
/// A sharpened noise byte: 0 and 1 are kept for "no flow" and a flag, and as many on the other side.
inline constexpr int kLeastNoise = 2, kMostNoise = 253;
/// A pixel's nine bits (the links, and itself in the middle) where it is linked to all neighbours.
inline constexpr int kAllNine = 0x1FF;

// What two pixels need to be on one sheet (cpu/project/links.h has the rule).

/// A facet predicts its neighbour's depth if it is off by no more than so many pixel footprints and the share
/// kSlackSlope of the steeper facet's change per pixel, which is curvature within a pixel.
inline constexpr float kSlackFootprints = 1.5f;
inline constexpr float kSlackSlope = 0.1f;

}  // namespace aeolic::limits
