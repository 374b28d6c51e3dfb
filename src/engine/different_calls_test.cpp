#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "aeolic/error.h"
#include "aeolic/renderer.h"
#include "cluster/comm/communicator.h"
#include "ranks/thread_communicator.h"

namespace aeolic {
namespace {

using Call = std::function<void(Renderer&, int rank)>;

SceneDescription described()
{
    SceneDescription scene;
    scene.surface.spec = "torus:2000";
    scene.field.spec = "gyre:9,9,9";
    scene.lic.steps = 20;
    scene.output.width = 90;
    scene.output.height = 70;
    scene.run.backend = BackendChoice::cpu;
    return scene;
}

Renderer rendererOf(Communicator& ranks, const SceneDescription& scene = described())
{
    return Renderer(scene, std::shared_ptr<Communicator>(&ranks, [](Communicator*) {}));
}

/// What ranks are told that call what differs; all the same line. They can go on: the picture is then what it was.
std::string toldAfter(const Call& call, int count = 3)
{
    std::vector<std::string> told(std::size_t(count), "nothing");
    Picture before, after;
    runRanks(count, [&](Communicator& ranks) {
        Renderer renderer = rendererOf(ranks);
        const Picture first = renderer.render({});
        try {
            call(renderer, ranks.rank());
        } catch (const InputError& error) {
            told[std::size_t(ranks.rank())] = error.what();
        }
        const Picture last = renderer.render({});
        if (ranks.isRoot()) before = first, after = last;
    });
    for (const std::string& line : told) EXPECT_EQ(line, told[0]) << "every rank's";
    EXPECT_EQ(after.pixels, before.pixels);
    EXPECT_EQ(told[0].find('\n'), std::string::npos) << told[0];
    return told[0];
}

/// The last of three ranks does something else.
bool isOther(int rank)
{
    return rank == 2;
}

TEST(DifferentCalls, Sizes)
{
    EXPECT_EQ(toldAfter([](Renderer& r, int rank) { r.setSize(isOther(rank) ? 900 : 80, 70); }),
              "setSize: rank 2 has 'output.width = 900'; expected 'output.width = 80' as on rank 0");
    EXPECT_EQ(toldAfter([](Renderer& r, int rank) { r.setSize(isOther(rank) ? -1 : 80, 70); }),
              "setSize: rank 2 has 'output.width = -1'; expected 'output.width = 80' as on rank 0");
}

TEST(DifferentCalls, LicOptions)
{
    EXPECT_EQ(toldAfter([](Renderer& r, int rank) {
                  LicOptions lic;
                  lic.steps = isOther(rank) ? 2000 : 20;
                  r.setLic(lic);
              }),
              "setLic: rank 2 has 'lic.steps = 2000'; expected 'lic.steps = 20' as on rank 0");
    EXPECT_EQ(toldAfter([](Renderer& r, int rank) {
                  LicOptions lic;
                  if (isOther(rank)) lic.kernel = Kernel(77);
                  r.setLic(lic);
              }),
              "setLic: rank 2 has 'lic.kernel = 77'; expected 'lic.kernel = box' as on rank 0");
}

TEST(DifferentCalls, ShadingOfWhichOneHasAColourMapThatIsNotReadYet)
{
    EXPECT_EQ(toldAfter([](Renderer& r, int rank) {
                  ShadingOptions shading;
                  if (isOther(rank)) shading.colormap = "turbo";
                  r.setShading(shading);
              }),
              "setShading: rank 2 has 'shading.colormap = turbo'; expected 'shading.colormap = viridis' as on rank 0");
}

TEST(DifferentCalls, Cameras)
{
    EXPECT_EQ(toldAfter([](Renderer& r, int rank) {
                  CameraOptions camera;
                  camera.azimuth = isOther(rank) ? 31 : 30;
                  r.render({camera});
              }),
              "start: rank 2 has 'camera.azimuth = 31'; expected 'camera.azimuth = 30' as on rank 0");
    EXPECT_EQ(toldAfter([](Renderer& r, int rank) {
                  CameraOptions camera;
                  if (isOther(rank)) camera.position = {1, 2, 30};
                  r.start({camera, false});
              }),
              "start: rank 2 has 'camera.position = 1,2,30'; expected 'camera.position =' as on rank 0");
}

TEST(DifferentCalls, Moments)
{
    EXPECT_EQ(toldAfter([](Renderer& r, int rank) { r.setTime(isOther(rank) ? 2 : 0.5); }),
              "setTime: rank 2 has 'time.moment = 2'; expected 'time.moment = 0.5' as on rank 0");
}

TEST(DifferentCalls, FramesOfAnAnimation)
{
    EXPECT_EQ(toldAfter([](Renderer& r, int rank) { r.render({AnimationFrame{isOther(rank) ? 3 : 0}}); }),
              "start: rank 2 has 'frame = 3'; expected 'frame = 0' as on rank 0");
    EXPECT_EQ(toldAfter([](Renderer& r, int) { r.render({AnimationFrame{1}}); }),
              "frame: found 1; expected 0 to 0, those of the animation");
}

TEST(DifferentCalls, WhoGetsTheRows)
{
    EXPECT_EQ(toldAfter([](Renderer& r, int rank) {
                  r.render({{}, !isOther(rank)});
              }),
              "start: rank 2 has 'gather = off'; expected 'gather = on' as on rank 0");
    EXPECT_EQ(toldAfter([](Renderer& r, int rank) {
                  if (isOther(rank)) return void(r.render({CameraOptions{}}));
                  r.render({AnimationFrame{0}});
              }),
              "start: rank 2 has 'camera.azimuth = 30'; expected 'frame = 0' as on rank 0");
}

TEST(DifferentCalls, SurfacesShown)
{
    EXPECT_EQ(toldAfter([](Renderer& r, int rank) { r.setShown(std::vector<bool>(isOther(rank), true)); }),
              "setShown: rank 2 has 'on'; expected nothing as on rank 0");
}

TEST(DifferentCalls, AnotherFunction)
{
    EXPECT_EQ(toldAfter([](Renderer& r, int rank) {
                  if (isOther(rank)) return r.setSize(90, 70);
                  r.render({});
              }),
              "the ranks' calls: rank 2 has 'setSize'; expected 'start' as on rank 0");
}

/// A picture that one rank has not taken yet is not lost: it takes it then.
TEST(DifferentCalls, OneThatFinishesLater)
{
    EXPECT_EQ(toldAfter([](Renderer& r, int rank) {
                  r.start({});
                  try {
                      if (isOther(rank)) return r.setSize(80, 80);
                      r.finish();
                  } catch (const InputError&) {
                      r.finish();
                      throw;
                  }
              }),
              "the ranks' calls: rank 2 has 'setSize'; expected 'finish' as on rank 0");
}

TEST(DifferentCalls, DataInMemory)
{
    std::vector<std::string> told(2);
    runRanks(2, [&](Communicator& ranks) {
        const std::vector<float> values(3 * 27, 1.0f);
        Data data;
        Grid& grid = data.grid.emplace();
        grid.dims = {3, 3, 3};
        grid.pointArrays = {{"u", {values.data(), 27, 3}}};
        Renderer renderer(described(), data, std::shared_ptr<Communicator>(&ranks, [](Communicator*) {}));
        if (ranks.rank() == 1) grid.spacing[1] = 0.5;
        try {
            renderer.setData(data);
        } catch (const InputError& error) {
            told[std::size_t(ranks.rank())] = error.what();
        }
        grid.spacing[1] = 1;
        renderer.setData(data);
        renderer.render({});
    });
    EXPECT_EQ(told[0], "setData: rank 1 has '3 samples from 0 by 0.5'; expected '3 samples from 0 by 1' as on rank 0");
    EXPECT_EQ(told[1], told[0]);
}

TEST(DifferentCalls, TheSameMistakeOnAllIsSaidWithoutARank)
{
    EXPECT_EQ(toldAfter([](Renderer& r, int) { r.setSize(0, 70); }),
              "output.width: found 0; expected a whole number from 1 to 32768");
}

}  // namespace
}  // namespace aeolic
