/// Scenes in JSON: one that is read can be written, and is then read as the same.
#include <string_view>

#include "aeolic/error.h"
#include "description/scene_json.h"
#include "memory_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    aeolic::SceneDescription scene;
    try {
        scene = aeolic::sceneFromJson({reinterpret_cast<const char*>(data), size}, "scene.json");
    } catch (const aeolic::InputError& error) {
        aeolic::fuzz::requireOneLine(error.what());
        return 0;
    }
    const std::string text = aeolic::sceneToJson(scene);
    if (aeolic::sceneToJson(aeolic::sceneFromJson(text, "scene.json")) != text) __builtin_trap();
    return 0;
}
