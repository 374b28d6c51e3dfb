#include "description/surface_spec.h"

#include <gtest/gtest.h>

#include "aeolic/error.h"

namespace aeolic {
namespace {

TEST(SurfaceSpec, SliceHasAPointAndAUnitNormal)
{
    const SurfaceSpec spec = parseSurfaceSpec("slice:1,-2.5,3e2:0,0,-4");
    EXPECT_EQ(spec.kind, SurfaceSpec::Kind::slice);
    EXPECT_EQ(spec.originWorld, glm::dvec3(1, -2.5, 300));
    EXPECT_EQ(spec.normal, glm::dvec3(0, 0, -1));
    EXPECT_TRUE(spec.isCut());
    EXPECT_EQ(parseSurfaceSpec("slice:0,0,0:1e200,0,0").normal, glm::dvec3(1, 0, 0)) << "squares overflow";
}

TEST(SurfaceSpec, IsosurfaceTakesTheLastEqualsSign)
{
    const SurfaceSpec spec = parseSurfaceSpec("isosurface:a=b:mag=-0.5");
    EXPECT_EQ(spec.array, "a=b:mag");
    EXPECT_EQ(spec.value, -0.5);
}

TEST(SurfaceSpec, WhatIsNotKnownByNameIsAFile)
{
    EXPECT_EQ(parseSurfaceSpec("teapot:1000").kind, SurfaceSpec::Kind::builtin);
    EXPECT_EQ(parseSurfaceSpec("boundary").kind, SurfaceSpec::Kind::boundary);
    EXPECT_EQ(parseSurfaceSpec("boundary.vtp").kind, SurfaceSpec::Kind::file);
}

TEST(SurfaceSpec, MalformedTextIsOneLineThatNamesIt)
{
    for (const char* text :
         {"", "slice:", "slice:1,2,3", "slice:1,2:0,0,1", "slice:1,2,3,4:0,0,1", "slice:1,x,3:0,0,1",
          "slice:1,2,3:0,0,0", "slice:1,,3:0,0,1", "slice:1,2,3:0,0,1e999", "slice:1,2,3:0,0,nan", "slice:0,0,0:0,0,1 ",
          "isosurface:", "isosurface:p", "isosurface:=3", "isosurface:p=", "isosurface:p=3x"}) {
        try {
            parseSurfaceSpec(text);
            ADD_FAILURE() << "accepted: " << text;
        } catch (const InputError& error) {
            const std::string message = error.what();
            EXPECT_NE(message.find(text), std::string::npos);
            EXPECT_EQ(message.find('\n'), std::string::npos);
            EXPECT_NE(message.find("; expected "), std::string::npos);
        }
    }
}

}  // namespace
}  // namespace aeolic
