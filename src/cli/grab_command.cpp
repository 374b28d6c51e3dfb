#include <memory>
#include <string>

#include "aeolic/error.h"
#include "aeolic/stream_client.h"
#include "cli/commands.h"
#include "cli/given_token.h"
#include "cli/scene_options.h"
#include "output/output_check.h"

namespace aeolic {

namespace {

struct GrabCommand {
    std::string address, output, tokenFile;
    std::string size = "800x800", options;
    double timeoutS = 60;
    bool insecure = false;

    void run() const;
};

StreamView viewOf(const std::string& size)
{
    StreamView view;
    char x = 0, end = 0;
    if (std::sscanf(size.c_str(), "%d%c%d%c", &view.width, &x, &view.height, &end) != 3 || x != 'x' || view.width < 1 ||
        view.height < 1)
        throw InputError("--size", "found '" + size + "'", "WIDTHxHEIGHT");
    return view;
}

void GrabCommand::run() const
{
    if (!output.ends_with(".png")) throw InputError("-o", "found '" + output + "'", "a name ending in .png");
    checkWritable(output);
    StreamView view = viewOf(size);
    view.options = options;
    StreamClient::Options client;
    client.timeout = std::chrono::milliseconds(std::int64_t(timeoutS * 1000));
    client.trustAnyCertificate = insecure;
    client.name = "aeolic grab";
    const std::string fromEnvironment = tokenFromEnvironment();
    client.token = tokenFile.empty() ? fromEnvironment : tokenFromFile(tokenFile);
    writePng(StreamClient(address, client).grab(view).picture, output);
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
