#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <string>

#include "aeolic/error.h"
#include "aeolic/stream_client.h"
#include "cli/commands.h"
#include "cli/given_token.h"
#include "description/option_rules.h"
#include "description/scene_json.h"
#include "description/scene_text.h"
#include "description/validate.h"
#include "output/output_check.h"
#include "stream/requests.h"

namespace aeolic {

namespace {

struct GrabCommand {
    std::string address, output, tokenFile;
    std::string size = "800x800", options;
    double timeoutS = 60;
    bool insecure = false;

    void run() const;
};

constexpr NumberRule timeout{0, 86400, true};

/// Throws InputError for what no server takes.
StreamView viewOf(const std::string& size, const std::string& options)
{
    SceneDescription asked;
    if (!options.empty()) {
        asked = sceneFromJson(options, "--view");
        const stream::Json view = stream::parseJson(options);
        for (const auto& [key, value] : view.items())
            if (key != "camera" && key != "lic" && key != "shading")
                throw InputError("--view: " + key, "found in a view", "camera, lic or shading");
    }
    setOption(asked, "--size", size);
    validate(asked, commandLineName);
    StreamView view;
    view.width = asked.output.width;
    view.height = asked.output.height;
    view.options = options;
    return view;
}

void GrabCommand::run() const
{
    if (!output.ends_with(".png")) throw InputError("-o", "found '" + output + "'", "a name ending in .png");
    checkWritable(output);
    const StreamView view = viewOf(size, options);
    if (!timeout.accepts(timeoutS))
        throw InputError("--timeout", fmt::format("found {}", timeoutS), rangeText(timeout));
    StreamClient::Options client;
    client.timeout = std::chrono::milliseconds(std::int64_t(std::ceil(timeoutS * 1000)));
    client.trustAnyCertificate = insecure;
    client.name = "aeolic grab";
    const std::string fromEnvironment = tokenFromEnvironment();
    client.token = tokenFile.empty() ? fromEnvironment : tokenFromFile(tokenFile);
    const Picture picture = StreamClient(address, client).grab(view).picture;
    if (picture.width != view.width || picture.height != view.height)
        throw InputError("--size", fmt::format("found {}", size),
                         fmt::format("at most what the server draws (its --max-size): {}x{} of these proportions",
                                     picture.width, picture.height));
    writePng(picture, output);
}

}  // namespace

void addGrabCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks)
{
    CLI::App* command =
        program.add_subcommand("grab", "Saves a picture from a running server, the same as render would.");
    const auto grab = std::make_shared<GrabCommand>();
    command->add_option("ADDRESS", grab->address, "as serve printed it; process lists show a token in it")
        ->required()
        ->type_name("");
    command->add_option("-o,--output", grab->output, "the PNG file to write")->required()->type_name("OUT.png");
    command
        ->add_option("--token-file", grab->tokenFile,
                     "a file with the token, for an address without one; without it AEOLIC_TOKEN in the environment")
        ->type_name("FILE");
    command->add_option("--size", grab->size, "the picture in pixels")->type_name("WxH")->capture_default_str();
    command->add_option("--view", grab->options, R"(JSON: {"camera":…,"lic":…,"shading":…} as in a scene file)")
        ->type_name("JSON");
    command->add_option("--timeout", grab->timeoutS, "for each step")->type_name("SECONDS")->capture_default_str();
    command->add_flag("--insecure", grab->insecure, "takes any TLS certificate");
    command->callback([grab, ranks] {
        if (ranks->isRoot()) grab->run();
    });
}

}  // namespace aeolic
