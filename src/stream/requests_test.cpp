#include "stream/requests.h"

#include <gtest/gtest.h>

#include "aeolic/error.h"
#include "description/scene_json.h"
#include "description/scene_surfaces.h"

namespace aeolic::stream {
namespace {

Hello hello(const std::string& json)
{
    return helloFrom(parseJson(json));
}
ViewRequest view(const std::string& json, int largestSide = 4096)
{
    return viewFrom(parseJson(json), largestSide);
}
ChangeRequest change(const std::string& json)
{
    return changeFrom(parseJson(json));
}

constexpr const char* kView = R"({"view":7,"moving":true,"width":800,"height":600})";

/// `kView` with one key replaced or added.
std::string viewWith(const char* key, const std::string& value)
{
    Json json = Json::parse(kView);
    json[key] = Json::parse(value);
    return json.dump();
}

TEST(Requests, JsonIsOneShallowObject)
{
    EXPECT_EQ(parseJson(R"({"a":[1]})")["a"][0], 1);
    for (const char* wrong :
         {"", "[]", "7", "null", "{", "{}x", "{}{}", R"({"a":1,})", "{\"a\":\"\xff\"}", "{\"a\":01}",
          R"({"a":"\ud800"})", "\xef\xbb\xbf{", "{'a':1}", "// \n{}", R"({"a":1e999})"})
        EXPECT_THROW(parseJson(wrong), ProtocolError) << wrong;
    const auto nested = [](int levels) {
        return R"({"a":)" + std::string(std::size_t(levels), '[') + std::string(std::size_t(levels), ']') + "}";
    };
    EXPECT_NO_THROW(parseJson(nested(7)));
    EXPECT_THROW(parseJson(nested(8)), ProtocolError);
    EXPECT_THROW(parseJson(R"({"a":)" + std::string(16000, '[')), ProtocolError) << "stops before it is parsed";
}

TEST(Requests, HelloSaysWhatItCanDecode)
{
    const Hello full =
        hello(R"({"codecs":["jpeg","png","lz4","png","morse"],"direct":true,"name":"p\u0001\u007f\nx"})");
    EXPECT_EQ(full.codecs, (std::vector{Codec::jpeg, Codec::png, Codec::lz4})) << "known ones, each once";
    EXPECT_TRUE(full.direct);
    EXPECT_EQ(full.name, "p   x") << "nothing that a terminal or a log would act on";
    const Hello least = hello(R"({"codecs":["png"]})");
    EXPECT_FALSE(least.direct);
    EXPECT_EQ(least.name, "");
    EXPECT_EQ(hello(R"({"codecs":["png"],"name":")" + std::string(64, 'x') + "\"}").name.size(), 64u);
}

TEST(Requests, WrongHellosAreRefused)
{
    for (const char* wrong :
         {R"({})", R"({"codecs":"png"})", R"({"codecs":[]})", R"({"codecs":["jpeg","lz4"]})", R"({"codecs":["png",1]})",
          R"({"codecs":{"png":1}})", R"({"codecs":["png"],"direct":1})", R"({"codecs":["png"],"direct":null})",
          R"({"codecs":["png"],"name":7})", R"({"codecs":["png"],"name":["a"]})"})
        EXPECT_THROW(hello(wrong), ProtocolError) << wrong;
    EXPECT_THROW(hello(R"({"codecs":["png"],"name":")" + std::string(65, 'x') + "\"}"), ProtocolError);
}

TEST(Requests, ViewKeepsItsOptions)
{
    const ViewRequest request = view(viewWith("lic", R"({"steps":9})"));
    EXPECT_EQ(request.view, 7u);
    EXPECT_TRUE(request.moving);
    EXPECT_EQ(request.width, 800);
    EXPECT_EQ(request.height, 600);
    EXPECT_EQ(request.options, Json::parse(R"({"lic":{"steps":9}})"));
    EXPECT_EQ(view(viewWith("view", "4294967295")).view, 4294967295u);
}

TEST(Requests, AViewFromHomeHasTheCameraOfTheSceneSoFarAway)
{
    const Json ofScene = Json::parse(R"({"position":[4,0,2],"focal":[1,0,2],"up":[0,0,1],"fov":30})");
    ViewRequest request = view(viewWith("home", "1.5"));
    request.options["camera"] = Json::parse(R"({"azimuth":7})");
    Json camera = fromHome(request, ofScene).options["camera"];
    EXPECT_EQ(camera["position"], Json({5.5, 0.0, 2.0}));
    EXPECT_EQ(camera["fov"], 30);
    request.home = 1;
    EXPECT_FALSE(fromHome(request, ofScene).options.contains("camera")) << "it is the scene's to the last bit";
    EXPECT_FALSE(fromHome(request, Json()).options.contains("camera"));
    request.home.reset();
    EXPECT_EQ(fromHome(request, ofScene).options["camera"], request.options["camera"]);
}

TEST(Requests, WrongViewsAreRefused)
{
    for (const char* key : {"view", "moving", "width", "height"}) {
        Json without = Json::parse(kView);
        without.erase(key);
        EXPECT_THROW(view(without.dump()), ProtocolError) << "without " << key;
        for (const char* wrong : {"null", "\"1\"", "[1]", "{}", "-1", "1.5", "4294967296", "1e3"})
            EXPECT_THROW(view(viewWith(key, wrong)), ProtocolError) << key << " is " << wrong;
    }
    EXPECT_THROW(view(viewWith("moving", "1")), ProtocolError);
    for (const char* wrong : {"null", "true", "0", "-1", "1e7", "\"1\"", "[1]"})
        EXPECT_THROW(view(viewWith("home", wrong)), ProtocolError) << wrong;
    EXPECT_THROW(view(viewWith("view", "true")), ProtocolError);
    EXPECT_THROW(view(viewWith("width", "0")), ProtocolError);
    EXPECT_THROW(view(viewWith("height", "0")), ProtocolError);
    for (const char* key : {"surface", "field", "output", "run", "version", ""})
        EXPECT_THROW(view(viewWith(key, "{}")), ProtocolError) << "a view names no '" << key << "'";
    for (const char* key : {"camera", "lic", "shading"})
        for (const char* wrong : {"null", "1", "[]", "\"x\""})
            EXPECT_THROW(view(viewWith(key, wrong)), ProtocolError) << key << " is " << wrong;
}

TEST(Requests, LargeViewsAreCutDownInProportion)
{
    const auto size = [](const std::string& width, const std::string& height, int largest) {
        const ViewRequest request =
            view(R"({"view":1,"moving":false,"width":)" + width + R"(,"height":)" + height + "}", largest);
        return std::pair(request.width, request.height);
    };
    EXPECT_EQ(size("800", "400", 800), std::pair(800, 400));
    EXPECT_EQ(size("1600", "800", 800), std::pair(800, 400));
    EXPECT_EQ(size("800", "1600", 800), std::pair(400, 800));
    EXPECT_EQ(size("4294967295", "1", 4096), std::pair(4096, 1)) << "never without pixels";
}

TEST(Requests, AViewLiesOverTheScene)
{
    SceneDescription scene;
    scene.lic.steps = 11;
    scene.lic.seed = 5;
    scene.shading.colorBy = "p";
    scene.camera.position = Vec3{1, 2, 3};
    const SceneDescription drawn = withView(scene, view(viewWith("lic", R"({"steps":3})")), 40, 30);
    EXPECT_EQ(drawn.lic.steps, 3);
    EXPECT_EQ(drawn.lic.seed, 5u) << "what a view leaves out stays as the scene has it";
    EXPECT_EQ(drawn.shading.colorBy, "p");
    EXPECT_EQ(drawn.camera.position, scene.camera.position);
    EXPECT_EQ(drawn.output.width, 40);
    EXPECT_EQ(drawn.output.height, 30);
    const SceneDescription turned = withView(scene, view(viewWith("camera", R"({"azimuth":50})")), 40, 30);
    EXPECT_FALSE(turned.camera.position) << "a camera replaces the scene's as a whole";
    EXPECT_EQ(turned.camera.azimuth, 50);
}

TEST(Requests, WrongOptionsAreNamed)
{
    const auto complaint = [](const char* group, const char* options) -> std::string {
        try {
            withView({}, view(viewWith(group, options)), 8, 8);
        } catch (const InputError& error) {
            return error.what();
        }
        return "none";
    };
    EXPECT_NE(complaint("lic", R"({"steps":0})").find("lic.steps"), std::string::npos);
    EXPECT_NE(complaint("lic", R"({"stepz":1})").find("stepz"), std::string::npos);
    EXPECT_NE(complaint("camera", R"({"zoom":"far"})").find("camera.zoom"), std::string::npos);
    EXPECT_NE(complaint("camera", R"({"position":[1,2]})").find("camera.position"), std::string::npos);
    EXPECT_NE(complaint("shading", R"({"colormap":"x"})").find("shading.colormap"), std::string::npos);
    EXPECT_NE(complaint("shading", R"({"colorBy":"p"})").find("shading.colorBy"), std::string::npos);
}

/// The job reads a colour map's file where the scene names it. A viewer must not make it read others.
TEST(Requests, ViewersChooseNoFilesForTheirColours)
{
    SceneDescription scene;
    scene.shading.colormap = "maps/mine.json";
    const auto drawn = [&](const char* options) { return withView(scene, view(viewWith("shading", options)), 8, 8); };
    EXPECT_EQ(drawn(R"({"colormap":"maps/mine.json"})").shading.colormap, "maps/mine.json");
    EXPECT_EQ(drawn(R"({"colormap":"vik"})").shading.colormap, "vik");
    for (const char* other :
         {R"({"colormap":"/etc/other.json"})", R"({"colormap":"maps/../maps/mine.json"})",
          R"({"colormap":"MAPS/MINE.JSON"})", R"({"colormap":7})", R"({"colormap":"/dev/zero.csv"})"})
        EXPECT_THROW(drawn(other), InputError) << other;
}

TEST(Requests, ChangesOfEachKind)
{
    const ChangeRequest full = change(R"({"surface":"boundary","vectors":"U","colorBy":"p","time":0.25})");
    EXPECT_EQ(full.surface, "boundary");
    EXPECT_EQ(full.vectors, "U");
    EXPECT_EQ(full.colorBy, "p");
    EXPECT_EQ(full.time, 0.25);
    EXPECT_FALSE(change("{}").surface);
    for (const char* wrong : {R"({"surface":1})", R"({"surface":null})", R"({"vectors":["U"]})", R"({"colorBy":{}})",
                              R"({"time":"now"})", R"({"time":null})", R"({"field":"x.vti"})", R"({"lic":{}})"})
        EXPECT_THROW(change(wrong), ProtocolError) << wrong;
}

TEST(Requests, AViewerNamesNoFile)
{
    SceneDescription original;
    original.surface.spec = "car.vtp";
    original.surface.featureAngle = 33;
    original.field.spec = "wind.vti";
    SceneDescription now = original;
    now.surface.spec = "boundary";
    for (const char* file : {"/etc/passwd", "other.vtp", "car.vtp", "../car.vtp", "teapot", "sphere", "", "Original",
                             "slice.vtp", "file:boundary"})
        EXPECT_THROW(withChange(now, original, change(Json{{"surface", file}}.dump())), InputError) << file;
    for (const char* cut : {"boundary", "isosurface:p=0.2", "slice:0,0,0:0,0,1"})
        EXPECT_EQ(withChange(now, original, change(Json{{"surface", cut}}.dump())).surface.spec, cut);
    const SceneDescription back = withChange(now, original, change(R"({"surface":"original"})"));
    EXPECT_EQ(back.surface.spec, "car.vtp");
    EXPECT_EQ(back.surface.featureAngle, 33);
    EXPECT_EQ(back.field.spec, "wind.vti") << "and no other field either";
}

/// `scene`, which began as `original`, with some surfaces cut out of its field.
SceneDescription withCuts(const SceneDescription& scene, const SceneDescription& original, const char* cuts)
{
    return withChange(scene, original, change(std::string(R"({"cuts":)") + cuts + "}"));
}

TEST(Requests, ACutIsOneMoreSurfaceAndGoesAgain)
{
    SceneDescription original;
    original.surface.spec = "car.vtp";
    original.field.spec = "wind.vti";
    const SceneDescription sliced = withCuts(original, original, R"({"1":"slice:0,0,1:0,0,1"})");
    EXPECT_EQ(surfacesText(sliced), "car.vtp, slice:0,0,1:0,0,1");
    EXPECT_EQ(surfaceName(sliced, original), "slice:0,0,1:0,0,1");
    SceneDescription two = withCuts(sliced, original, R"({"1":"slice:0,0,2:0,0,1","2":"isosurface:p=1"})");
    EXPECT_EQ(surfacesText(two), "car.vtp, slice:0,0,2:0,0,1, isosurface:p=1");
    two.surfaces[0].shown = two.surfaces[2].shown = false;
    const SceneDescription one = withCuts(two, original, R"({"1":null})");
    EXPECT_EQ(surfacesText(one), "car.vtp, isosurface:p=1");
    EXPECT_FALSE(one.surfaces[0].shown || one.surfaces[1].shown) << "hidden surfaces stay hidden";
    const SceneDescription back = withCuts(one, original, R"({"1":null})");
    EXPECT_EQ(sceneToJson(back), sceneToJson(original));
    EXPECT_EQ(surfaceName(back, original), "original");
}

TEST(Requests, ACutThatTheServerWasStartedWithIsMovedWhereItIs)
{
    SceneDescription original;
    original.field.spec = "wind.vti";
    original.surface.spec = "slice:0,0,0:1,1,0";
    EXPECT_EQ(withCuts(original, original, R"({"0":"slice:1,1,0:1,1,0"})").surface.spec, "slice:1,1,0:1,1,0");
    for (const char* spec : {"car.vtp", "slice:0,0,0:1,1,0", "wheel.vtp"}) {
        original.surfaces.emplace_back();
        original.surfaces.back().spec = spec;
    }
    original.surfaces[1].colorBy = "p";
    const SceneDescription moved = withCuts(original, original, R"({"1":"slice:2,2,0:1,1,0"})");
    EXPECT_EQ(surfacesText(moved), "car.vtp, slice:2,2,0:1,1,0, wheel.vtp");
    EXPECT_EQ(moved.surfaces[1].colorBy, "p");
    for (const char* wrong :
         {R"({"0":"boundary"})", R"({"1":null})", R"({"0":null})", R"({"3":null})", R"({"4":"boundary"})",
          R"({"1":"car.vtp"})", R"({"1":"/etc/passwd"})", R"({"1":"slice:0,0"})", R"({"3":"teapot"})"})
        EXPECT_THROW(withCuts(original, original, wrong), InputError) << wrong;
    EXPECT_THROW(withCuts(original, original, (R"({"1":"isosurface:)" + std::string(2000, 'p') + R"(=1"})").c_str()),
                 InputError);
    for (const char* wrong : {"[]", R"({"x":"boundary"})", R"({"-1":"boundary"})", R"({"":"boundary"})", R"({"1":7})",
                              R"({"99999999999999999999":"boundary"})"})
        EXPECT_THROW(withCuts(original, original, wrong), ProtocolError) << wrong;
}

TEST(Requests, AnyNumberOfCutsHasAnEnd)
{
    SceneDescription original, scene;
    scene.field.spec = original.field.spec = "wind.vti";
    int added = 0;
    try {
        for (; added < 100; ++added)
            scene = withCuts(scene, original, (R"({")" + std::to_string(added + 1) + R"(":"boundary"})").c_str());
    } catch (const InputError&) {
    }
    EXPECT_EQ(added, 16);
}

/// Others of several surfaces stay, and those that are hidden stay hidden.
TEST(Requests, ASurfaceBesideSeveralIsOneMore)
{
    SceneDescription original;
    original.field.spec = "wind.vti";
    original.surfaces.resize(2);
    original.surfaces[0].spec = "car.vtp";
    original.surfaces[1].spec = "road.vtp";
    SceneDescription now = original;
    now.surfaces[1].shown = false;
    const SceneDescription sliced = withChange(now, original, change(R"({"surface":"slice:0,0,1:0,0,1"})"));
    EXPECT_EQ(surfacesText(sliced), "car.vtp, road.vtp, slice:0,0,1:0,0,1");
    EXPECT_FALSE(sliced.surfaces[1].shown);
    const SceneDescription back = withChange(sliced, original, change(R"({"surface":"original"})"));
    EXPECT_EQ(sceneToJson(back), sceneToJson(now));
}

TEST(Requests, AnotherColourForgetsTheRangeOfTheOneBefore)
{
    SceneDescription scene;
    scene.shading.colorBy = "p";
    scene.shading.colorRange = {0, 1};
    EXPECT_FALSE(withChange(scene, scene, change(R"({"colorBy":"T"})")).shading.colorRange);
    EXPECT_TRUE(withChange(scene, scene, change(R"({"vectors":"U"})")).shading.colorRange);
    EXPECT_EQ(withChange(scene, scene, change(R"({"colorBy":""})")).shading.colorBy, "");
}

TEST(Requests, DrawsSurviveTheWay)
{
    DrawRequest draw{17, 3, 7, 800, Codec::jpeg, 55, true, {}};
    draw.scene.lic.steps = 21;
    draw.scene.output.width = 400;
    draw.scene.camera.position = Vec3{1, 2, 0.1};
    draw.scene.shading.background = "transparent";
    const DrawRequest back = drawFrom(parseJson(drawToJson(draw)));
    EXPECT_EQ(back.frame, 17u);
    EXPECT_EQ(back.viewer, 3u);
    EXPECT_EQ(back.view, 7u);
    EXPECT_EQ(back.askedWidth, 800u);
    EXPECT_EQ(back.codec, Codec::jpeg);
    EXPECT_EQ(back.quality, 55);
    EXPECT_TRUE(back.direct);
    EXPECT_EQ(sceneToJson(back.scene), sceneToJson(draw.scene));
}

TEST(Requests, WrongDrawsAreRefused)
{
    const Json good = Json::parse(drawToJson({}));
    for (const char* key : {"frame", "viewer", "view", "askedWidth", "codec", "quality", "direct", "scene"}) {
        Json without = good;
        without.erase(key);
        EXPECT_THROW(drawFrom(without), ProtocolError) << key;
    }
    Json unknown = good;
    unknown["codec"] = "morse";
    EXPECT_THROW(drawFrom(unknown), ProtocolError);
}

}  // namespace
}  // namespace aeolic::stream
