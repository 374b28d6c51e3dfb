#include "aeolic/surface_spec.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "aeolic/error.h"

namespace aeolic {
namespace {

TEST(SurfaceSpec, SliceHasAPointAndAUnitNormal)
{
    const SurfaceSpec spec = parseSurfaceSpec("slice:1,-2.5,3e2:0,0,-4");
    EXPECT_EQ(spec.kind, SurfaceSpec::Kind::slice);
    EXPECT_EQ(spec.origin, (Vec3{1, -2.5, 300}));
    EXPECT_EQ(spec.normal, (Vec3{0, 0, -1}));
    EXPECT_TRUE(spec.isCut());
    EXPECT_EQ(parseSurfaceSpec("slice:0,0,0:1e200,0,0").normal, (Vec3{1, 0, 0})) << "squares overflow";
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

TEST(SurfaceSpec, FilesAndBuiltInsHaveTheirParts)
{
    const SurfaceSpec sphere = parseSurfaceSpec("sphere:5000"), wave = parseSurfaceSpec("wave");
    EXPECT_EQ(sphere.name, "sphere");
    EXPECT_EQ(sphere.triangles, 5000);
    EXPECT_EQ(wave.name, "wave");
    EXPECT_FALSE(wave.triangles);
    const SurfaceSpec walls = parseSurfaceSpec("a/b.case:wing,tail*");
    EXPECT_EQ(walls.name, "a/b.case");
    EXPECT_EQ(walls.parts, (std::vector<std::string>{"wing", "tail*"}));
    EXPECT_EQ(SurfaceSpec().text, SurfaceSource().spec);
    EXPECT_EQ(parseSurfaceSpec(SurfaceSpec().text).name, SurfaceSpec().name);
}

void expectSame(const SurfaceSpec& a, const SurfaceSpec& b)
{
    EXPECT_EQ(a.kind, b.kind) << a.text;
    EXPECT_EQ(a.text, b.text);
    EXPECT_EQ(a.name, b.name) << a.text;
    EXPECT_EQ(a.triangles, b.triangles) << a.text;
    EXPECT_EQ(a.parts, b.parts) << a.text;
    EXPECT_EQ(a.origin, b.origin) << a.text;
    EXPECT_EQ(a.normal, b.normal) << a.text;
    EXPECT_EQ(a.array, b.array) << a.text;
    EXPECT_EQ(a.value, b.value) << a.text;
}

TEST(SurfaceSpec, WhatAProgramSaysIsTheTextThatSaysTheSame)
{
    const std::pair<SurfaceSpec, std::string> specs[] = {
        {SurfaceSpec::builtin("torus"), "torus"},
        {SurfaceSpec::builtin("torus", 2000), "torus:2000"},
        {SurfaceSpec::file("body.vtp"), "body.vtp"},
        {SurfaceSpec::file("case.foam", {"wall*", "inlet"}), "case.foam:wall*,inlet"},
        {SurfaceSpec::file("teapot"), "./teapot"},
        {SurfaceSpec::file("boundary"), "./boundary"},
        {SurfaceSpec::slice({0.1, -2.5e-20, 3}, {0, 0, 1}), "slice:0.1,-2.5e-20,3:0,0,1"},
        {SurfaceSpec::isosurface("a=b:mag", 1.0 / 3), "isosurface:a=b:mag=0.3333333333333333"},
        {SurfaceSpec::boundary(), "boundary"},
        {SurfaceSpec::image(), "image"},
    };
    for (const auto& [spec, text] : specs) {
        EXPECT_EQ(spec.text, text);
        expectSame(spec, parseSurfaceSpec(text));
    }
    EXPECT_EQ(SurfaceSpec::slice({0, 0, 0}, {0, -3, 0}).normal, (Vec3{0, -1, 0}));
    EXPECT_EQ(SurfaceSpec::isosurface("p", 1.0 / 3).value, 1.0 / 3) << "no digit is lost";
}

TEST(SurfaceSpec, WhatNoTextCouldSayIsRefused)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::function<void()> wrong[] = {
        [] { SurfaceSpec::builtin("teacup"); },
        [] { SurfaceSpec::file(""); },
        [] { SurfaceSpec::file("a.case", {"left,right"}); },
        [] { SurfaceSpec::file("a.case", {""}); },
        [] { SurfaceSpec::file("no:such.vtp"); },
        [] {
            SurfaceSpec::slice({0, 0, 0}, {0, 0, 0});
        },
        [&] {
            SurfaceSpec::slice({0, nan, 0}, {0, 0, 1});
        },
        [] { SurfaceSpec::isosurface("", 1); },
        [&] { SurfaceSpec::isosurface("p", nan); },
    };
    for (const auto& make : wrong) EXPECT_THROW(make(), InputError) << &make - wrong;
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
