#include <algorithm>
#include <array>
#include <vector>

#include "gl_calls_testing.h"
#include "render_testing.h"

/// The LIC stage starts a workgroup for each tile near flow, and hardly one more. A workgroup without a tile does
/// nothing, but a program that plays the GPU on the processor takes as long for it as for any other.
namespace aeolic {
namespace {

using namespace testkit;

using Groups = std::array<GLuint, 3>;

/// What indirect dispatches ask for, for as long as it lives.
class Grids {
public:
    Grids() { now_ = this; }
    ~Grids() { now_ = nullptr; }

    std::vector<Groups> found;

private:
    static inline Grids* now_ = nullptr;

    Replaced<decltype(glDispatchComputeIndirect)> indirect_{glDispatchComputeIndirect, [](GLintptr at) {
                                                                Groups groups{};
                                                                glGetBufferSubData(GL_DISPATCH_INDIRECT_BUFFER, at,
                                                                                   sizeof groups, groups.data());
                                                                now_->found.push_back(groups);
                                                                now_->indirect_.original()(at);
                                                            }};
};

class GlGrids : public ::testing::Test {
protected:
    void SetUp() override { skipWithout("gl"); }

    static std::vector<Groups> gridsOf(int width, int height, LicMethod method)
    {
        Stages stages("gl", makeBuiltinScene("sphere", "rotation:8,8,8"));
        LicOptions lic = directLic(2);
        lic.method = method;
        CameraOptions filling;
        filling.zoom = 8;                                               // Flow in every tile.
        stages.project(fitCamera(stages.scene, filling, 16, 16), lic);  // libepoxy's pointers are set by that.
        stages.convolve(lic);
        Grids grids;
        stages.project(fitCamera(stages.scene, filling, width, height), lic);
        stages.convolve(lic);
        return grids.found;
    }
};

TEST_F(GlGrids, OfASmallPictureAreSmall)
{
    for (const LicMethod method : {LicMethod::direct, LicMethod::hierarchical}) {
        const std::vector<Groups> grids = gridsOf(40, 30, method);
        ASSERT_FALSE(grids.empty());
        for (const Groups& groups : grids) EXPECT_EQ((std::array{groups[0], groups[1]}), (std::array{6u, 1u}));
    }
}

TEST_F(GlGrids, OfALargePictureHaveRowsForTheRest)
{
    for (const Groups& groups : gridsOf(16 * 64, 16 * 17 - 1, LicMethod::direct))
        EXPECT_EQ((std::array{groups[0], groups[1]}), (std::array{1024u, 2u}));
}

}  // namespace
}  // namespace aeolic
