#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "aeolic/error.h"
#include "description/scene_json.h"
#include "description/validate.h"

/// Thousands of damaged scenes, the same ones on every run: each is either read as a valid scene or refused with one
/// line.
namespace aeolic {
namespace {

using Random = std::mt19937;

std::size_t below(Random& random, std::size_t limit)
{
    return limit == 0 ? 0 : random() % limit;
}

std::vector<std::string> seeds()
{
    SceneDescription scene;
    scene.field = {"wind.vti", FieldPrecision::float16, "U", 0.01, 0.5};
    scene.shading.colorRange = {-1.0, 2.5};
    scene.camera.position = {1, 2, 3};
    scene.camera.focal = {0, 0, 0};
    scene.camera.up = {0, 0, 1};
    return {sceneToJson(scene), sceneToJson({}), R"({"version":1,"lic":{"steps":5,"kernel":"hann"}})",
            R"({"camera":{"position":[1,2,3],"fov":45},"output":{"width":64}})"};
}

const std::vector<std::string> fragments{"{",
                                         "}",
                                         "[",
                                         "]",
                                         ",",
                                         ":",
                                         "\"",
                                         "null",
                                         "true",
                                         "false",
                                         "-1",
                                         "0",
                                         "1e308",
                                         "1e999",
                                         "-0.0",
                                         "99999999999999999999",
                                         "\"lic\"",
                                         "\"steps\":",
                                         "\"version\": 2",
                                         "\\u0000",
                                         "\\ud800",
                                         "\\",
                                         "\xff",
                                         "\xe2\x82",
                                         "\xef\xbb\xbf",
                                         "/*",
                                         "NaN",
                                         "\n",
                                         "[[[[[[[[[[",
                                         "{\"a\":{\"a\":",
                                         "\"box\"",
                                         "2147483648",
                                         "-2147483649",
                                         "0.1",
                                         "[1,2,3]",
                                         "\"\""};

void mutate(std::string& text, Random& random, const std::vector<std::string>& all)
{
    const std::size_t at = below(random, text.size() + 1), length = below(random, 12);
    switch (random() % 7) {
        case 0:
            if (!text.empty()) text[below(random, text.size())] ^= char(1u << random() % 8);
            break;
        case 1:
            text.erase(at, length);
            break;
        case 2:
            text.insert(at, fragments[below(random, fragments.size())]);
            break;
        case 3:
            text.replace(at, std::min(length, text.size() - at), fragments[below(random, fragments.size())]);
            break;
        case 4:
            text.insert(at, text.substr(below(random, text.size() + 1), length * 4));
            break;
        case 5:
            text.resize(at);
            break;
        default:
            text += all[below(random, all.size())].substr(0, length * 10);
            break;
    }
}

/// Replaces one number or word after a colon: keeps the document whole, so that the values are tried, not only the
/// grammar.
void mutateValue(std::string& text, Random& random)
{
    std::vector<std::size_t> colons;
    for (std::size_t i = text.find(':'); i != std::string::npos; i = text.find(':', i + 1)) colons.push_back(i);
    if (colons.empty()) return;
    const std::size_t start = colons[below(random, colons.size())] + 1;
    const std::size_t end = text.find_first_of(",}\n", start);
    if (end == std::string::npos) return;
    const bool number = random() % 2;
    text.replace(start, end - start,
                 number ? std::to_string(int(below(random, 200)) - 20) : fragments[below(random, fragments.size())]);
}

TEST(SceneJsonFuzz, EveryDocumentIsAValidSceneOrOneLine)
{
    Random random(20060511);
    const std::vector<std::string> all = seeds();
    int read = 0, refused = 0;
    for (int i = 0; i < 40000; ++i) {
        std::string text = all[below(random, all.size())];
        for (std::size_t n = 1 + below(random, 3); n > 0; --n)
            i % 2 ? mutateValue(text, random) : mutate(text, random, all);
        try {
            const SceneDescription scene = sceneFromJson(text, "fuzz.json");
            ASSERT_NO_THROW(validate(scene)) << text;
            const std::string written = sceneToJson(scene);
            ASSERT_EQ(sceneToJson(sceneFromJson(written, "")), written) << text;
            ++read;
        } catch (const InputError& error) {
            const std::string message = error.what();
            ASSERT_TRUE(message.starts_with("fuzz.json: ")) << message;
            ASSERT_EQ(message.find_first_of("\n\r\0"), std::string::npos) << message;
            ASSERT_LT(message.size(), 400u) << message;
            ++refused;
        }
    }
    // The mutations must reach both sides of the reader.
    EXPECT_GT(read, 1000);
    EXPECT_GT(refused, 10000);
}

}  // namespace
}  // namespace aeolic
