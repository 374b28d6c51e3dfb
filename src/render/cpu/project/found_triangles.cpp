#include "render/cpu/project/found_triangles.h"

#include <algorithm>
#include <array>
#include <bit>
#include <tuple>

#include "base/parallel.h"
#include "render/cpu/project/edge_pixels.h"
#include "render/cpu/project/raster/triangle_rows.h"

namespace aeolic::cpu {
namespace {

static_assert(kSampleMargin <= kSubpixels, "TriangleBox::beside tells of a pixel at each side");

constexpr std::size_t kMaxChunks = 64;  // Enough to keep many cores busy, few enough that per-tile counts stay small.
constexpr std::size_t kMinChunkTriangles = 2048;

/// Appends the boxes that have a marked pixel. The quick answers come first, for some boxes at once and without a jump:
/// no processor guesses them.
class QuickLook {
public:
    QuickLook(const MarkedBoxes& marked, std::vector<TriangleBox>& out) : marked_(marked), out_(out) {}

    void at(const TriangleBox& box)
    {
        some_[count_] = box;
        count_ += std::size_t(marked_.mayBeNear(box.x0, box.y0, box.x1, box.y1));
        if (count_ == some_.size()) finish();
    }
    void finish()
    {
        for (std::size_t i = 0; i < count_; ++i) {
            const TriangleBox& box = some_[i];
            const Extent extent{box.x0, box.y0, box.x1, box.y1};
            if (!extent.empty() && marked_.mayHave(extent)) out_.push_back(box);
        }
        count_ = 0;
    }

private:
    const MarkedBoxes& marked_;
    std::vector<TriangleBox>& out_;
    std::array<TriangleBox, 256> some_;
    std::size_t count_ = 0;
};

}  // namespace

void FoundTriangles::find(const SceneArrays& arrays, const View& view, const Extent& scissor, const GroupPart& part)
{
    arrays_ = &arrays;
    view_ = view;
    scissor_ = scissor;
    const std::size_t triangles = arrays.scene->surface.triangles.size();
    visible_.find(arrays.groups, triangles, view, scissor, part);
    transformVertices(arrays, view, visible_, screen_);

    count_ = std::clamp<std::size_t>(triangles / kMinChunkTriangles, 1, kMaxChunks);
    chunks_.resize(std::max(chunks_.size(), count_));
    static_assert(kGroupTriangles == 64, "a group is a word");
    between_.resize(visible_.groups());
    parallelFor(count_, [&](std::size_t i) {
        Chunk& chunk = chunks_[i];
        chunk.boxes.clear();
        chunk.unsafe.clear();
        std::fill(between_.begin() + std::ptrdiff_t(firstGroup(i)),
                  between_.begin() + std::ptrdiff_t(firstGroup(i + 1)), 0);
        visible_.forEachRange(firstGroup(i), firstGroup(i + 1), [&](std::size_t begin, std::size_t end) {
            setUpTriangles(arrays, screen_, begin, end, scissor, kSampleMargin,
                           {chunk.boxes, chunk.unsafe, between_.data()});
        });
    });
}

bool FoundTriangles::has(const SceneArrays& arrays, const View& view, const Extent& scissor) const
{
    const auto place = [](const View& v) {
        return std::tuple(v.eyeLocal, v.right, v.up, v.forward, v.focalPx, v.centerX, v.centerY, v.nearInvDepth,
                          v.farInvDepth, v.frontFacesOnly);
    };
    return arrays_ == &arrays && place(view_) == place(view) && scissor_.x0 <= scissor.x0 &&
           scissor_.y0 <= scissor.y0 && scissor_.x1 >= scissor.x1 && scissor_.y1 >= scissor.y1;
}

void FoundTriangles::findMarked(std::size_t chunk, const MarkedBoxes& marked, const Extent& scissor,
                                std::vector<TriangleBox>& out) const
{
    QuickLook look(marked, out);
    for (const TriangleBox& box : chunks_[chunk].boxes) {
        const TriangleBox wide = box.withBeside();
        look.at({box.id, std::max(wide.x0, scissor.x0), std::max(wide.y0, scissor.y0), std::min(wide.x1, scissor.x1),
                 std::min(wide.y1, scissor.y1), box.facing});
    }
    for (std::size_t g = firstGroup(chunk); g < firstGroup(chunk + 1); ++g)
        for (std::uint64_t left = between_[g]; left != 0; left &= left - 1) {
            const auto id = std::uint32_t(g * kGroupTriangles + std::size_t(std::countr_zero(left)));
            const auto [a, b, c] = arrays_->scene->surface.triangles[id];
            const Extent box =
                pixelsOver(cornerOf(screen_[a]), cornerOf(screen_[b]), cornerOf(screen_[c]), kSampleMargin, scissor);
            look.at({id, box.x0, box.y0, box.x1, box.y1});
        }
    look.finish();
}

}  // namespace aeolic::cpu
