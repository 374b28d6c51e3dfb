#pragma once

/// Shared by the tests of scenes from the caller's memory: the same scenes from files and from arrays.

#include <limits>

#include "aeolic/error.h"
#include "aeolic/renderer.h"
#include "scene_memory_testing.h"

namespace aeolic::testkit {

inline constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

class MemoryTest : public testing::Test {
protected:
    MemoryTest()
    {
        scene_.lic.steps = 12;
        scene_.output.width = 90;
        scene_.output.height = 70;
        scene_.run.backend = BackendChoice::cpu;
        scene_.camera.elevation = 60;
    }
    static Data dataOf(const Volume& volume)
    {
        Data data;
        data.volume = volume;
        return data;
    }
    std::string sheetFile(const test::SheetSample& sample = {}) const
    {
        test::writeSheetFile(folder_.file("sheet.vtp"), sample);
        return folder_.file("sheet.vtp");
    }
    std::string gridFile(const test::GridSample& sample = {}) const
    {
        test::writeGridFile(folder_.file("grid.vti"), sample);
        return folder_.file("grid.vti");
    }
    Picture ofFiles(SceneDescription scene, const std::string& surface, const std::string& field = "") const
    {
        if (!surface.empty()) scene.surface.spec = surface;
        scene.field.spec = field;
        return Renderer(scene).render({scene.camera});
    }
    static Picture ofMemory(const SceneDescription& scene, const Data& data)
    {
        return Renderer(scene, data).render({scene.camera});
    }
    std::string complaint(const Data& data) const
    {
        try {
            const Renderer renderer(scene_, data);
        } catch (const InputError& error) {
            return error.what();
        }
        return "taken";
    }

    SceneDescription scene_;
    test::TempFolder folder_;
};

}  // namespace aeolic::testkit
