#include "render/overlay/topology_lines.h"

#include <gtest/gtest.h>

namespace aeolic {
namespace {

using Style = SurfaceLines::Style;

/// Which style has something with a mark at that place.
const Style* styleAt(const std::vector<Style>& styles, const glm::vec3& at, MarkShape& shape)
{
    for (const Style& style : styles)
        for (const SurfaceLines::Mark& mark : style.marks)
            if (mark.at == at) {
                shape = mark.shape;
                return &style;
            }
    return nullptr;
}

TEST(TopologyLines, WhatTheFlowRunsToAndWhatItComesFromDiffer)
{
    SurfaceMesh mesh;
    mesh.originWorld = {1000, 0, -5};
    SurfaceTopology topology;
    const auto add = [&](float x, CriticalKind kind, bool attracts) {
        const auto first = std::uint32_t(mesh.positions.size());
        for (const glm::vec3& corner : {glm::vec3(x, 0, 0), glm::vec3(x, 1, 0), glm::vec3(x, 0, 1)})
            mesh.positions.push_back(corner);
        CriticalPoint point;
        point.place = {std::uint32_t(mesh.triangles.size()), {1, 0, 0}};
        mesh.triangles.push_back({first, first + 1, first + 2});
        point.kind = kind;
        point.attracts = attracts;
        topology.points.push_back(point);
    };
    add(0, CriticalKind::saddle, false);
    add(1, CriticalKind::node, true);
    add(2, CriticalKind::node, false);
    add(3, CriticalKind::focus, true);
    add(4, CriticalKind::centre, false);
    topology.lines.push_back({0, 1, 1, 1, {topology.points[0].place, topology.points[1].place}});
    topology.lines.push_back({0, 2, -1, 2, {topology.points[0].place, topology.points[2].place}});

    const std::vector<Style> styles = topologyLines(topology, mesh);
    MarkShape saddle{}, attracting{}, repelling{}, focus{}, centre{};
    const Style *atSaddle = styleAt(styles, {0, 0, 0}, saddle), *to = styleAt(styles, {1, 0, 0}, attracting),
                *from = styleAt(styles, {2, 0, 0}, repelling);
    EXPECT_EQ(styleAt(styles, {3, 0, 0}, focus), to);
    ASSERT_TRUE(styleAt(styles, {4, 0, 0}, centre));
    ASSERT_TRUE(atSaddle && to && from);
    EXPECT_TRUE(atSaddle != to && to != from && from != atSaddle);
    EXPECT_EQ(saddle, MarkShape::cross);
    EXPECT_EQ(attracting, MarkShape::disc);
    EXPECT_EQ(repelling, MarkShape::disc);
    EXPECT_EQ(focus, MarkShape::ringWithDot);
    EXPECT_EQ(centre, MarkShape::ring);
    // Separation leaves the saddle downstream, and is as what the flow runs to.
    using Line = std::vector<glm::vec3>;
    EXPECT_EQ(to->lines, (std::vector<Line>{{{0, 0, 0}, {1, 0, 0}}}));
    EXPECT_EQ(from->lines, (std::vector<Line>{{{0, 0, 0}, {2, 0, 0}}}));
    EXPECT_EQ(atSaddle, &styles.back()) << "crosses lie over the lines that end in them";
}

}  // namespace
}  // namespace aeolic
