#include "stream/gateway/hub/hub_testing.h"

/// The scene of a program that draws itself: it changes unasked, and viewers steer it.
namespace aeolic::stream {
namespace {

using test::FakeViewer;

Hub::Options ofProgram()
{
    Hub::Options options;
    options.ofProgram = true;
    options.scene.surface.spec = "surface in memory";
    return options;
}

class HubProgram : public test::HubTest {
protected:
    HubProgram() : HubTest(ofProgram()) {}
    void renew() { hub.jobSaid(emptyMessage(MessageType::renewed)); }
    /// The program's scene, with this colour map.
    void showWith(const std::string& colorMap)
    {
        SceneDescription scene = ofProgram().scene;
        scene.shading.colormap = colorMap;
        say(MessageType::scene, {{"scene", Json::parse(sceneToJson(scene))}});
    }
    FakeViewer a, b;
};

TEST_F(HubProgram, DataThatChangeAreDrawnAgainForAll)
{
    startJob();
    join(a);
    join(b);
    see(a, 1, false);
    see(b, 7, false);
    renew();
    const DrawRequest first = onlyDraw();
    finish(first);
    shown(first.viewer == a.id ? a : b, first.frame);
    const DrawRequest second = onlyDraw();
    EXPECT_NE(first.viewer, second.viewer);
    EXPECT_EQ(first.view + second.view, 8u) << "the last view of each";
}

TEST_F(HubProgram, DataThatChangeFasterThanTheyAreDrawnDoNotStopThePictures)
{
    startJob();
    join(a);
    see(a, 1, false);
    renew();
    const DrawRequest begun = onlyDraw();
    for (int i = 0; i < 100; ++i) renew();
    EXPECT_TRUE(draws().empty());
    finish(begun);
    shown(a, begun.frame);
    EXPECT_EQ(a.ended().size(), 2u) << "the frame that was begun";
    finish(onlyDraw());
    EXPECT_TRUE(draws().empty()) << "a hundred changes are one";
}

TEST_F(HubProgram, WhoHasSeenNothingYetIsNotDrawnFor)
{
    startJob();
    join(a);
    renew();
    EXPECT_TRUE(draws().empty());
    follow(a, 99);
    renew();
    EXPECT_TRUE(draws().empty());
}

TEST_F(HubProgram, ASceneThatChangesUnaskedIsToldAndDrawn)
{
    startJob();
    join(a);
    see(a, 1, false);
    a.messages.clear();
    showWith("coolwarm");
    const auto told = a.taken(MessageType::scene);
    ASSERT_EQ(told.size(), 1u);
    EXPECT_EQ(test::jsonOf(told[0])["scene"]["shading"]["colormap"], "coolwarm");
    EXPECT_EQ(test::jsonOf(told[0])["surface"], "original");
    const DrawRequest draw = onlyDraw();
    EXPECT_EQ(draw.scene.shading.colormap, "coolwarm");
    finish(draw);
    shown(a, draw.frame);
    showWith("coolwarm");
    EXPECT_EQ(a.taken(MessageType::scene).size(), 1u) << "a control may be another";
    EXPECT_TRUE(draws().empty()) << "but the picture is the same";
    join(b);
    EXPECT_EQ(b.taken(MessageType::scene).size(), 1u);
}

TEST_F(HubProgram, WhatViewersSteerIsMergedAndGoesWithTheLoad)
{
    startJob();
    join(a);
    join(b);
    now += std::chrono::seconds(1);
    change(a, R"({"steer":{"speed":0.5}})");
    const auto first = loads();
    ASSERT_EQ(first.size(), 1u);
    EXPECT_EQ(first[0]["steer"].dump(), R"({"speed":0.5})");
    change(a, R"({"steer":{"speed":0.6}})");
    change(b, R"({"steer":{"pause":1}})");
    change(a, R"({"steer":{"speed":0.7}})");
    EXPECT_TRUE(loads().empty()) << "one at a time";
    sceneLoaded(first[0]);
    const auto second = loads();
    ASSERT_EQ(second.size(), 1u);
    EXPECT_EQ(second[0]["steer"].dump(), R"({"pause":1})") << "each viewer has its turn";
    sceneLoaded(second[0]);
    const auto third = loads();
    ASSERT_EQ(third.size(), 1u);
    EXPECT_EQ(third[0]["steer"].dump(), R"({"speed":0.7})") << "the newest";
    sceneLoaded(third[0]);
    change(a, R"({"time":1})");
    const auto last = loads();
    ASSERT_EQ(last.size(), 1u);
    EXPECT_FALSE(last[0].contains("steer")) << "nothing is steered twice";
}

TEST_F(HubProgram, NonsenseEndsTheConversation)
{
    startJob();
    join(a);
    for (const char* wrong : {R"({"steer":{}})", R"({"steer":7})", R"({"steer":null})", R"({"steer":{"a":"b"}})",
                              R"({"steer":{"a":null}})", R"({"steer":{"a":{"b":1}}})", R"({"steer":[1]})"})
        EXPECT_THROW(change(a, wrong), ProtocolError) << wrong;
    const std::string name(65, 'x');
    EXPECT_THROW(change(a, R"({"steer":{")" + name + R"(":1}})"), ProtocolError);
    EXPECT_TRUE(loads().empty());
}

using HubOfFiles = test::HubTest;

TEST_F(HubOfFiles, ARendererOfFilesIsNotSteeredAndChangesNothingUnasked)
{
    startJob();
    FakeViewer a;
    join(a);
    change(a, R"({"steer":{"speed":1}})");
    EXPECT_EQ(a.errors(), "change: steer: found where nothing can be steered; expected a program that has controls\n");
    EXPECT_TRUE(loads().empty());
    EXPECT_THROW(hub.jobSaid(emptyMessage(MessageType::renewed)), ProtocolError);
    a.messages.clear();
    say(MessageType::scene, {{"scene", Json::parse(sceneToJson({}))}});
    EXPECT_TRUE(a.taken(MessageType::scene).empty());
}

}  // namespace
}  // namespace aeolic::stream
