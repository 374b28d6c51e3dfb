#include "cli/scene_options.h"

#include <algorithm>

#include "aeolic/error.h"
#include "base/text.h"
#include "data/load/field/plane_image.h"
#include "description/option_help.h"
#include "description/scene_json.h"
#include "description/scene_text.h"
#include "description/validate.h"

namespace aeolic {

std::string wrapped(const std::string& text)
{
    constexpr std::size_t widest = 84;
    std::string lines;
    std::size_t lineStart = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find_first_of(" \n", at + 1), text.size());
        if (text[at] == '\n') lineStart = lines.size() + 1;
        if (text[at] == ' ' && lines.size() - lineStart + (end - at) > widest) {
            lines += '\n';
            lineStart = lines.size();
            ++at;  // The line break stands for the space.
        }
        lines += text.substr(at, end - at);
        at = end;
    }
    return lines;
}

std::shared_ptr<std::string> addFirstWord(CLI::App& command, const std::string& name, const std::string& help)
{
    auto text = std::make_shared<std::string>();
    command.add_option(name, *text, help)->required()->type_name("");
    return text;
}

SceneOptions::SceneOptions(CLI::App& command) : command_(command)
{
    command.add_option("SCENE.json", sceneFile_, "a scene file; the options override what it says")->type_name("");
    for (const OptionHelp& help : optionsHelp()) {
        const std::string name = help.name;
        const auto give = [this, name](const std::string& text) { given_[name] = text; };
        CLI::Option* const option =
            help.repeats ? command.add_option(name, repeated_[name], wrapped(help.text))->expected(1)->take_all()
                         : command.add_option_function<std::string>(name, give, wrapped(help.text))->take_last();
        option->type_name(help.value)->group(help.heading);
    }
}

/// Who forgets a value gives the option the next one's name for it. What is left over then is called what it is not.
void SceneOptions::refuseOptionsAsValues() const
{
    const auto refuse = [&](const std::string& name, const std::string& text) {
        if (text.starts_with('-') && command_.get_option_no_throw(text))
            throw InputError(
                name, "no value before " + text,
                "one, as in '" + command_.get_parent()->get_name() + " " + command_.get_name() + " --help'");
    };
    for (const auto& [name, text] : given_) refuse(name, text);
    for (const auto& [name, texts] : repeated_)
        for (const std::string& text : texts) refuse(name, text);
}

SceneDescription SceneOptions::scene() const
{
    refuseOptionsAsValues();
    if (sceneFile_ && sceneFile_->empty()) throw InputError("SCENE.json", "found ''", "a scene file, or none");
    if (sceneFile_ && lowerExtension(*sceneFile_) != ".json")
        throw InputError(*sceneFile_, "not a scene file",
                         "a .json file; a surface or a field is given with --surface or --field");
    const SceneInFile file = sceneFile_ ? readSceneFile(*sceneFile_) : SceneInFile{};
    SceneDescription scene = file.scene;
    // Options typed win over the file. Where both were typed, validate() says that they do not go together.
    if (given_.contains("--time") && !given_.contains("--time-range")) scene.time.range.reset();
    if (given_.contains("--time-range") && !given_.contains("--time")) {
        scene.time.moment.reset();
        scene.time.momentOf = MomentOf::first;
    }
    setSurfaces(scene, repeated_.at("--surface"), repeated_.at("--context"));
    for (const auto& [name, text] : given_) setOption(scene, name, text);
    validate(scene, commandLineName);
    requireSurface(scene, file.namesSurface || !repeated_.at("--surface").empty());
    chooseDefaultField(scene);
    if (!sceneFile_ && !given_.contains("--size"))
        if (const auto size = planeSize(scene)) {
            scene.output.width = size->width;
            scene.output.height = size->height;
        }
    return scene;
}

}  // namespace aeolic
