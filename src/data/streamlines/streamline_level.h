#pragma once

#include <vector>

#include "data/streamlines/even_streamlines.h"
#include "data/streamlines/near_samples.h"
#include "data/streamlines/streamline_surface.h"

namespace aeolic {

/// Adds the streamlines of one level to those of the levels before.
class StreamlineLevel {
public:
    /// `lines`, `ends` and `chains`, how many streamlines there are, are those of the levels before; all change.
    StreamlineLevel(const StreamlineSurface& surface, int level, double spacing, std::vector<EvenStreamline>& lines,
                    std::vector<OpenEnd>& ends, std::uint32_t& chains);

    /// Lines that are there go on at their ends. Then seeds lie across the flow from lines, old and new, and last over
    /// the whole area.
    void run();

private:
    /// What following a line one way found. Points are without the first.
    struct Way {
        std::vector<StreamlinePoint> points;
        SurfacePlace last;
        bool isCut = false, isClosed = false;
    };

    void goOn(const OpenEnd& end);
    void seedBesideAll();
    void seedBeside(const StreamlinePoint& point, const glm::vec3& along);
    void tryLine(const SurfacePlace& seed);
    Way follow(const StreamlinePoint& from, int direction, std::uint32_t chain, bool mayClose);
    bool isBack(const StreamlinePoint& seed, const StreamlinePoint& point, const glm::vec3& ahead) const;
    void keepEnd(const Way& way, const StreamlinePoint& from, std::uint32_t chain, int direction);
    void addSamples(const EvenStreamline& line);
    StreamlinePoint pointAt(const SurfacePlace& place, float arc) const;

    const StreamlineSurface& surface_;
    const int level_;
    const float spacing_;
    std::vector<EvenStreamline>& lines_;
    std::vector<OpenEnd>& ends_;
    std::uint32_t& chains_;
    NearSamples near_;
    std::size_t seeded_ = 0;  // Lines that have had their seeds.
};

}  // namespace aeolic
