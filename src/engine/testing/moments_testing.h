#pragma once

#include <gtest/gtest.h>

#include <string>

#include "aeolic/renderer.h"
#include "data/vtk/testing/sample_files.h"

namespace aeolic::test {

/// A scene that changes in time, of files or of built-ins.
class Moments : public testing::Test {
protected:
    Moments()
    {
        // A field and a sheet in it, at 0, 1, 2; the sheet moves, the vectors turn.
        for (int i = 0; i < 3; ++i) {
            GridSample grid;
            grid.scale = 1 + 2 * i;
            grid.origin = {-1, -0.5, 0.25};
            writeGridFile(folder_.file("f_" + std::to_string(i) + ".vti"), grid);
            SheetSample sheet;
            sheet.shift = {0.1 * i - 0.5, 0, 0.8 + 0.2 * i};
            sheet.twist = 0.3 * i;
            writeSheetFile(folder_.file("s_" + std::to_string(i) + ".vtp"), sheet);
        }
    }
    SceneDescription describe(const std::string& surface, const std::string& field, const std::string& colorBy) const
    {
        SceneDescription d;
        d.surface.spec = surface;
        d.field.spec = field;
        d.shading.colorBy = colorBy;
        d.lic.steps = 24;
        d.output.width = 90;
        d.output.height = 71;
        d.run.backend = BackendChoice::cpu;
        return d;
    }
    SceneDescription files() const { return describe(folder_.file("s_*.vtp"), folder_.file("f_*.vti"), "p"); }
    static SceneDescription builtIn()
    {
        SceneDescription d = Moments::bare();
        d.surface.spec = "wave:1800";
        d.field.spec = "gyre:24,24,4";
        d.shading.colorBy = "gyre:mag";
        return d;
    }
    static SceneDescription bare()
    {
        SceneDescription d;
        d.lic.steps = 24;
        d.output.width = 90;
        d.output.height = 71;
        d.run.backend = BackendChoice::cpu;
        return d;
    }
    static Picture at(SceneDescription d, double moment)
    {
        d.time.moment = moment;
        return Renderer(d).render({d.camera});
    }

    TempFolder folder_;
};

}  // namespace aeolic::test
