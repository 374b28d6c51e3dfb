#include "description/scene_json.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "aeolic/error.h"
#include "description/scene_text.h"

namespace aeolic {
namespace {

std::string complaint(const std::string& text)
{
    try {
        sceneFromJson(text, "scene.json");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

/// A scene in which every field differs from its default.
SceneDescription unusualScene()
{
    SceneDescription scene;
    scene.surface = {"slice:0,0,0:0,1,0", 45};
    scene.field = {"tornado", FieldPrecision::float16, "Geschwindigkeit größer", -0.02, 0.1};
    scene.time.range = std::array{0.25, -4.0};
    scene.lic = {
        LicMethod::direct, Style::dense, Integrator::rk4,   77,  0.3,         Kernel::hann, Streaks::plain, -1.25,
        FlowMotion::loop,  false,        Magnitude::length, 2.5, 4294967295u, 0.25};
    scene.shading = {"p",           "coolwarm", std::array{-1e-7, 3.0},
                     RangeOf::data, "bands:7",  "112233",
                     "445566",      "778899",   false,
                     "p [Pa]",      "Flügel",   true,
                     true,          1.5,        2.0,
                     0.1,           "102030",   false};
    scene.camera = {-10, 89.5, 7, 2, 45, Vec3{1, 2, 3}, Vec3{0, 0, 0.1}, Vec3{0, 1, 0}};
    scene.output = {1920, 1080, 24, 60, -90};
    scene.run = {BackendChoice::cpu,      3, 2, Balance::timing, BrickChoice::on, GuardChoice::bound,
                 GuardRowsChoice::receive};
    return scene;
}

TEST(SceneJson, EmptyObjectIsTheDefaultScene)
{
    EXPECT_EQ(sceneToJson(sceneFromJson("{}", "")), sceneToJson(SceneDescription{}));
}

TEST(SceneJson, EveryFieldSurvivesTheRoundTrip)
{
    const std::string text = sceneToJson(unusualScene());
    const SceneDescription read = sceneFromJson(text, "");
    EXPECT_EQ(sceneToJson(read), text);
    EXPECT_EQ(read.lic.kernel, Kernel::hann);
    EXPECT_EQ(read.lic.streaks, Streaks::plain);
    EXPECT_EQ(read.lic.seed, 4294967295u);
    EXPECT_EQ(read.field.vectors, "Geschwindigkeit größer");
    EXPECT_EQ(read.camera.position, (Vec3{1, 2, 3}));
    EXPECT_EQ(read.shading.colorRange, (std::array{-1e-7, 3.0}));
    EXPECT_EQ(read.output.frames, 24);
    EXPECT_EQ(read.run.device, 2);
}

/// The same with several surfaces.
SceneDescription severalSurfaces()
{
    SceneDescription scene;
    scene.surface.featureAngle = 30;
    SurfaceItem body, cut, ground;
    body.spec = "body.vtp";
    body.vectors = "tau";
    body.colorBy = "p";
    body.colormap = "coolwarm";
    body.legend = "p [Pa]";
    body.colorRange = std::array{-1.0, 2.0};
    cut.spec = "slice:0,0,0:0,1,0";
    cut.shown = false;
    ground.spec = "ground.stl";
    ground.streaks = false;
    ground.colorBy = "";
    scene.surfaces = {body, cut, ground};
    return scene;
}

TEST(SceneJson, SeveralSurfacesSurviveTheRoundTrip)
{
    const std::string text = sceneToJson(severalSurfaces());
    const SceneDescription read = sceneFromJson(text, "");
    EXPECT_EQ(sceneToJson(read), text);
    ASSERT_EQ(read.surfaces.size(), 3u);
    EXPECT_EQ(read.surfaces[0].vectors, "tau");
    EXPECT_EQ(read.surfaces[0].colormap, "coolwarm");
    EXPECT_EQ(read.surfaces[0].legend, "p [Pa]");
    EXPECT_EQ(read.surfaces[0].colorRange, (std::array{-1.0, 2.0}));
    EXPECT_TRUE(read.surfaces[0].streaks && read.surfaces[0].shown);
    EXPECT_FALSE(read.surfaces[1].colorBy || read.surfaces[1].vectors || read.surfaces[1].colorRange);
    EXPECT_FALSE(read.surfaces[1].shown);
    EXPECT_FALSE(read.surfaces[2].streaks);
    EXPECT_EQ(read.surfaces[2].colorBy, "");
    EXPECT_EQ(text.find("\"spec\": \"teapot\""), std::string::npos) << "the default surface is not one of them";
}

TEST(SceneJson, FaultsAmongSeveralSurfacesAreNamed)
{
    EXPECT_EQ(complaint(R"({"surfaces":{}})"), "scene.json: surfaces: found an object; expected a list of objects");
    EXPECT_EQ(complaint(R"({"surfaces":["a.vtp"]})"),
              "scene.json: surfaces[0]: found the text 'a.vtp'; expected an object");
    EXPECT_EQ(complaint(R"({"surfaces":[{"spec":"a.vtp"},{"spec":"b.vtp","colorby":"p"}]})")
                  .find("scene.json: surfaces[1]: 'colorby': unknown key; expected one of spec, "),
              0u);
    EXPECT_EQ(complaint(R"({"surfaces":[{"spec":"a.vtp"},{"spec":"b.vtp","streaks":1}]})"),
              "scene.json: surfaces[1].streaks: found 1; expected true or false");
    EXPECT_EQ(complaint(R"({"surfaces":[{"spec":"a.vtp"}],"surface":{"spec":"b.vtp"}})"),
              "scene.json: surface.spec: found together with surfaces; expected one or the other");
    EXPECT_EQ(complaint(R"({"surfaces":[{"spec":"a.vtp","streaks":false}]})"),
              "surfaces: none of them has streaks; expected at least one with streaks");
    EXPECT_EQ(complaint(R"({"surfaces":[{"spec":"a.vtp"},{"spec":"image"}]})"),
              "scene.json: surfaces[1].spec: found 'image' among several; expected it alone");
    EXPECT_EQ(complaint(R"({"surfaces":[{"spec":"a.vtp","colorRange":[2,1]}]})"),
              "scene.json: surfaces[0].colorRange: found 2,1; expected the low end first, and below the high end");
    EXPECT_EQ(complaint(R"({"surfaces":[{}]})").find("scene.json: surfaces[0].spec: found ''"), 0u);
    std::string many;
    for (int i = 0; i < 201; ++i) many += std::string(i ? "," : "") + R"({"spec":"a.vtp"})";
    EXPECT_EQ(complaint("{\"surfaces\":[" + many + "]}"),
              "scene.json: surfaces: found a list of 201; expected at most 200 surfaces");
    EXPECT_EQ(complaint(R"({"surfaces":[]})"), "") << "then the only surface is drawn";
}

TEST(SceneJson, DocumentsAreWhatTheTextSays)
{
    for (const SceneDescription& scene : {SceneDescription{}, unusualScene()}) {
        const std::string text = sceneToJson(scene);
        EXPECT_EQ(sceneDocument(scene), nlohmann::ordered_json::parse(text));
        EXPECT_EQ(sceneToJson(sceneFromDocument(sceneDocument(scene), "")), text);
    }
    try {
        sceneFromDocument({{"lic", {{"steps", -3}}}}, "view");
        ADD_FAILURE() << "taken";
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "view: lic.steps: found -3; expected a whole number from 1 to 65536");
    }
}

TEST(SceneJson, UnsetFieldsAreLeftOut)
{
    const std::string text = sceneToJson({});
    EXPECT_EQ(text.find("colorRange"), std::string::npos);
    EXPECT_EQ(text.find("position"), std::string::npos);
    EXPECT_NE(text.find("\"version\": 1"), std::string::npos);
    EXPECT_NE(text.find("\"method\": \"hierarchical\""), std::string::npos);
}

TEST(SceneJson, EachFaultIsOneLineThatNamesTheField)
{
    const std::pair<const char*, const char*> faults[] = {
        {R"({"lic": {"steps": -3}})", "scene.json: lic.steps: found -3; expected a whole number from 1 to 65536"},
        {R"({"lic": {"steps": 2.5}})", "scene.json: lic.steps: found 2.5; expected a whole number from 1 to 65536"},
        {R"({"lic": {"steps": 1e99}})", "scene.json: lic.steps: found 1e+99; expected a whole number from 1 to 65536"},
        {R"({"lic": {"steps": "8"}})",
         "scene.json: lic.steps: found the text '8'; expected a whole number from 1 to 65536"},
        {R"({"lic": {"steps": true}})", "scene.json: lic.steps: found true; expected a whole number from 1 to 65536"},
        {R"({"lic": {"steps": null}})", "scene.json: lic.steps: found null; expected a whole number from 1 to 65536"},
        {R"({"lic": {"normalize": 1}})", "scene.json: lic.normalize: found 1; expected true or false"},
        {R"({"lic": {"kernel": "cos"}})", "scene.json: lic.kernel: found the text 'cos'; expected one of box, hann"},
        {R"({"lic": {"seed": -1}})", "scene.json: lic.seed: found -1; expected a whole number from 0 to 4294967295"},
        {R"({"lic": {"stepp": 1}})",
         "scene.json: lic: 'stepp': unknown key; expected one of method, style, integrator, steps, step, kernel, "
         "streaks, "
         "phase, flow, "
         "normalize, magnitude, "
         "noiseScale, seed, maskBelow; did you mean steps?"},
        {R"({"lic": {"Method": "none"}})",
         "scene.json: lic: 'Method': unknown key; expected one of method, style, integrator, steps, step, kernel, "
         "streaks, "
         "phase, flow, "
         "normalize, magnitude, noiseScale, seed, maskBelow; did you mean method?"},
        {R"({"lic": {"method": "hierachical"}})",
         "scene.json: lic.method: found the text 'hierachical'; expected one of none, direct, hierarchical; did you "
         "mean hierarchical?"},
        {R"({"lick": {}})",
         "scene.json: 'lick': unknown key; expected one of version, surface, field, time, lic, shading, camera, "
         "output, run, surfaces; did you mean lic?"},
        {R"({"lic": 5})", "scene.json: lic: found 5; expected an object"},
        {R"({"lic": {"steps": 4, "steps": 5}})", "scene.json: 'steps': found twice; expected each key once"},
        {R"({"lic": {}, "lic": {}})", "scene.json: 'lic': found twice; expected each key once"},
        {R"({"camera": {"position": [1, 2]}})",
         "scene.json: camera.position: found a list of 2; expected a list of 3 numbers"},
        {R"({"camera": {"position": [1, "a", 2]}})",
         "scene.json: camera.position[1]: found the text 'a'; expected a number from -1e+30 to 1e+30"},
        {R"({"camera": {"position": [0, 0, 0], "focal": [0, 0, 0]}})",
         "scene.json: camera.focal: found the camera's position 0,0,0; expected another point, to look at"},
        {R"({"surface": {"spec": ""}})", "scene.json: surface.spec: found ''; expected a file or a built-in surface"},
        {R"({"version": 2})", "scene.json: version: found 2; expected 1"},
        {R"([1, 2])", "scene.json: document: found a list of 2; expected an object"},
        {"", "scene.json: line 1, column 1: found the end of the text; expected valid JSON"},
        {"{} x", "scene.json: line 1, column 4: found 'x'; expected valid JSON"},
        {"{\n  \"lic\": {,}}", "scene.json: line 2, column 11: found ','; expected valid JSON"},
        {R"({"lic": {"phase": 1e999}})", "scene.json: document: found a number beyond 1e308; expected finite numbers"},
    };
    for (const auto& [text, message] : faults) EXPECT_EQ(complaint(text), message) << text;
}

TEST(SceneJson, AbsurdNestingIsRefusedBeforeItIsBuilt)
{
    EXPECT_EQ(complaint(std::string(1000000, '[')), "scene.json: nesting: found more than 8 levels; expected a scene");
    std::string objects;
    for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
    EXPECT_EQ(complaint(objects), "scene.json: nesting: found more than 8 levels; expected a scene");
}

TEST(SceneJson, WholeNumbersMayBeWrittenAsFloats)
{
    EXPECT_EQ(sceneFromJson(R"({"lic": {"steps": 64.0}})", "").lic.steps, 64);
}

TEST(SceneJson, TextThatIsNotUtf8CannotBeWritten)
{
    SceneDescription scene;
    scene.shading.colorBy = "\xff\xfe";
    EXPECT_THROW(sceneToJson(scene), InputError);
}

TEST(SceneJson, DefaultFieldOnlyWhereTheSurfaceHasNoVectors)
{
    SceneDescription scene;
    chooseDefaultField(scene);
    EXPECT_EQ(scene.field.spec, "abc");
    for (const char* spec : {"car.vtp", "boundary", "slice:0,0,0:0,0,1"}) {
        scene = {};
        scene.surface.spec = spec;
        chooseDefaultField(scene);
        EXPECT_EQ(scene.field.spec, "") << spec;
    }
    scene = {};
    scene.field.vectors = "U";
    chooseDefaultField(scene);
    EXPECT_EQ(scene.field.spec, "");
}

std::string complaintWithoutSurface(const SceneDescription& scene)
{
    try {
        requireSurface(scene, false);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(SceneJson, TheDefaultSurfaceIsForBuiltInFieldsAlone)
{
    SceneDescription scene;
    EXPECT_EQ(complaintWithoutSurface(scene), "");
    for (const char* field : {"tornado:8,8,8", "Tornado:8,8,8"}) {
        scene.field.spec = field;
        EXPECT_EQ(complaintWithoutSurface(scene), "") << "the loader tells how a built-in is spelt";
    }
    for (const char* field : {"wind.vti", "grid in memory", "volume in memory"}) {
        scene.field.spec = field;
        EXPECT_EQ(complaintWithoutSurface(scene),
                  "--surface: found none; expected a file, boundary, slice:OX,OY,OZ:NX,NY,NZ, isosurface:ARRAY=VALUE "
                  "or image (the teapot is drawn in built-in fields alone)");
        EXPECT_NO_THROW(requireSurface(scene, true));
    }
    scene.field.spec = "";
    setSurfaces(scene, {}, {"body.vtp"});
    EXPECT_EQ(complaintWithoutSurface(scene),
              "--surface: found none beside --context; expected a surface with streaks (the teapot is drawn alone)");
    EXPECT_NO_THROW(requireSurface(scene, true));
}

class SceneFile : public testing::Test {
protected:
    void SetUp() override { std::filesystem::create_directories(folder_); }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::string write(const std::string& text) const
    {
        std::string path = (folder_ / "scene.json").string();
        std::ofstream(path) << text;
        return path;
    }
    std::string complaintAbout(const std::string& path) const
    {
        try {
            readSceneFile(path);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }

    std::filesystem::path folder_ =
        std::filesystem::temp_directory_path() / ("aeolic_scene_file_" + std::to_string(getpid()));
};

TEST_F(SceneFile, FileNamesAreRelativeToTheSceneFile)
{
    const auto read =
        readSceneFile(write(R"({"surface": {"spec": "car.vtp"}, "field": {"spec": "/data/wind.vti"}})")).scene;
    EXPECT_EQ(read.surface.spec, (folder_ / "car.vtp").string());
    EXPECT_EQ(read.field.spec, "/data/wind.vti");
}

TEST_F(SceneFile, BuiltInsAreNoFileNames)
{
    const auto read =
        readSceneFile(write(R"({"surface": {"spec": "isosurface:Q=0.5"}, "field": {"spec": "uniform:8,8,8"}})")).scene;
    EXPECT_EQ(read.surface.spec, "isosurface:Q=0.5");
    EXPECT_EQ(read.field.spec, "uniform:8,8,8");
}

/// The default surface is a text like another: only the file tells whether it was asked for.
TEST_F(SceneFile, ItIsKnownWhetherItNamesASurface)
{
    EXPECT_FALSE(readSceneFile(write(R"({"field": {"spec": "wind.vti"}})")).namesSurface);
    EXPECT_FALSE(readSceneFile(write(R"({"surface": {"cells": "steps"}, "surfaces": []})")).namesSurface);
    EXPECT_TRUE(readSceneFile(write(R"({"surface": {"spec": "teapot"}})")).namesSurface);
    EXPECT_TRUE(readSceneFile(write(R"({"surfaces": [{"spec": "car.vtp"}]})")).namesSurface);
}

TEST_F(SceneFile, MissingFolderEndlessOrHuge)
{
    const std::string missing = (folder_ / "no.json").string();
    EXPECT_EQ(complaintAbout(missing),
              missing + ": cannot be opened (No such file or directory); expected a scene file (JSON)");
    EXPECT_EQ(complaintAbout(folder_.string()), folder_.string() + ": found a folder; expected a scene file (JSON)");
    EXPECT_EQ(complaintAbout("/dev/zero"), "/dev/zero: found more than 1 MiB; expected a scene file (JSON)");
    const std::string huge = write("{" + std::string(2 << 20, ' ') + "}");
    EXPECT_EQ(complaintAbout(huge), huge + ": found more than 1 MiB; expected a scene file (JSON)");
}

}  // namespace
}  // namespace aeolic
