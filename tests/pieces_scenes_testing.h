#pragma once

/// Shared by the tests of surfaces in pieces: scenes, and a check that any number of ranks draws the same bytes as one.

#include "aeolic/renderer.h"
#include "data/vtk/testing/sample_files.h"
#include "pieces_testing.h"
#include "same_bytes_testing.h"

namespace aeolic::testkit {

class PiecesTest : public testing::Test {
protected:
    Case make(const std::string& name, const std::string& surface, const std::string& field, const LicOptions& lic,
              const std::string& colorBy) const
    {
        Case c = makeCase(name, 130, 101, lic);
        c.description.surface.spec = surface;
        c.description.field.spec = field;
        c.description.shading.colorBy = colorBy;
        c.camera.elevation = 35;
        return c;
    }
    /// Comes with vectors of its own.
    Case torus(const LicOptions& lic, const TorusPieces& torus = {}, const std::string& colorBy = "q") const
    {
        return make("torus", writeTorusPieces(folder_.path().string(), "torus", torus), "", lic, colorBy);
    }
    /// Cut out of the field by each rank in its brick.
    Case winding(const LicOptions& lic, bool masked = false, const std::string& colorBy = "U:mag") const
    {
        writeWindingField(folder_.file("f.vti"), masked);
        return make("isosurface", "isosurface:p=0.1", folder_.file("f.vti"), lic, colorBy);
    }
    void expectSame(const Case& c, const std::vector<int>& ranks, const std::vector<RunOptions>& options,
                    int frames = 2) const
    {
        const std::vector<Picture> alone = draw("cpu", c, {}, 1, frames);
        for (const int n : ranks)
            for (const RunOptions& o : options) expectSameBytes("cpu", c, alone, o, n);
    }
    test::TempFolder folder_;
};

inline const RunOptions kHybrid = runOptions("hybrid", "bound", "auto", "on");

}  // namespace aeolic::testkit
