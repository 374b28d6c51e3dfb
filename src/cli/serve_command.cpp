#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "aeolic/error.h"
#include "base/memory.h"
#include "base/nearest_name.h"
#include "base/text.h"
#include "cli/address_file.h"
#include "cli/commands.h"
#include "cli/given_token.h"
#include "cli/scene_options.h"
#include "description/option_table.h"
#include "output/print.h"
#include "stream/gateway/serve.h"
#include "stream/job/render_job.h"
#include "stream/token.h"

namespace aeolic {

namespace {

struct ServeCommand {
    ServeCommand(CLI::App& command, std::shared_ptr<Communicator> theRanks)
        : sceneOptions(command), ranks(std::move(theRanks))
    {
        const auto option = [&](const char* name, auto& value, const std::string& text, const char* type) {
            CLI::Option* added = command.add_option(name, value, wrapped(text));
            added->type_name(type)->take_last()->capture_default_str()->group("Server");
            return added;
        };
        const auto number = [&](const char* name, NumberRule rule, int& value, const std::string& text,
                                const char* type) {
            option(name, value, text + "; " + rangeText(rule), type)->check([](const std::string& typed) {
                return typed.empty() ? "found ''; expected a number" : "";
            });
            numbers.push_back({name, rule, &value});
        };
        number("--ranks", {1, 65536}, serve.job.ranks, "processes that draw; several are started by --launcher", "N");
        option("--launcher", serve.launcher, "what starts them; given, they may run on other hosts [mpirun -n {ranks}]",
               "COMMAND");
        option("--job-host", serve.jobHost,
               "the address of this host that ranks connect to [loopback; with --launcher all addresses]", "ADDRESS");
        number("--job-port", {0, 65535}, jobPort, "the port for that; 0: any that is free", "PORT");
        command
            .add_flag("--direct", serve.job.told.direct,
                      "ranks send their rows to viewers themselves, past this process")
            ->group("Server");
        option("--direct-ports", directPorts,
               "where ranks listen for viewers; as many as ranks on a host, or more [any]", "LO-HI");
        option("--host", serve.web.host, "address to listen on; others than this host's own need a token", "ADDRESS");
        number("--port", {0, 65535}, port, "0: any that is free", "PORT");
        option("--token", token,
               "the secret in the address, 16 characters or more, which process lists show; none: nobody is asked for "
               "one. Without it --token-file counts, without that AEOLIC_TOKEN in the environment [random]",
               "TOKEN|none");
        option("--token-file", tokenFile, "a file with the token, which only you may read", "FILE");
        option("--address-file", addressFile,
               "writes the address with its token to this file of mode 0600, and removes it at the end; where standard "
               "output is a file, the token goes here alone [~/.aeolic/HOST-PORT]",
               "FILE");
        command.add_flag("--i-know", iKnow, "--token none even where other hosts can connect")->group("Server");
        option("--tls-cert", serve.certificate, "certificate chain (PEM): https", "FILE");
        option("--tls-key", serve.key, "its private key (PEM)", "FILE");
        number("--max-viewers", {1, 256}, maxViewers, "further ones are turned away",
               "N");  // Every State message names them all.
        number("--viewer-memory", {16, 1 << 24}, viewerMiB,
               "for pictures on their way to all viewers together; by default a quarter of the free memory", "MIB");
        number("--max-size", {16, options::side.hi}, serve.hub.largestSide,
               "longest side of a picture that viewers may ask for", "PIXELS");
        number("--draw-limit", {1, 86400}, drawLimitS, "the renderer is started again if one picture takes longer",
               "SECONDS");
        number("--load-limit", {1, 86400}, loadLimitS, "the same if loading does not get on for longer", "SECONDS");
        number("--silence-limit", {2, 3600}, serve.job.told.silenceLimitS,
               "the same if a rank, its host or the network between is silent for longer", "SECONDS");
        option("--codec", codec, "how pictures travel, where the viewer can: auto, lz4, lzo, png, or while moving jpeg",
               "CODEC");
    }

    std::string givenToken() const;
    stream::ServeOptions serveOptions() const;
    void announce(const std::string& address, std::optional<AddressFile>& file) const;
    void run() const;

    struct Number {
        const char* name;
        NumberRule rule;
        const int* value;
    };
    std::vector<Number> numbers;
    SceneOptions sceneOptions;
    std::shared_ptr<Communicator> ranks;
    stream::ServeOptions serve;  ///< What needs no conversion is read into it; serveOptions() fills in the rest.
    int port = 8080, jobPort = 0, maxViewers = 64;
    int viewerMiB = int(std::clamp<std::uint64_t>(availableMemoryBytes() / 4 >> 20, 256, 1 << 24));
    int drawLimitS = 60, loadLimitS = 600;
    std::string directPorts, token, tokenFile, addressFile, codec = "auto";
    bool iKnow = false;
};

bool isLoopback(const std::string& host)
{
    return host == "localhost" || host == "::1" || host.starts_with("127.");
}

std::optional<stream::Codec> askedCodec(const std::string& name)
{
    if (name == "auto") return std::nullopt;
    const auto codec = stream::codecFromName(name);
    if (!codec || *codec == stream::Codec::raw)
        throw InputError("--codec", "found '" + name + "'",
                         "auto, lz4, lzo, jpeg or png" +
                             didYouMean(name, std::vector<std::string>{"auto", "lz4", "lzo", "jpeg", "png"}));
    if (!stream::available(*codec))
        throw InputError("--codec", name + ", which this build lacks", "a build with AEOLIC_LZO");
    return codec;
}

/// The token that the user gave; empty where there is none.
std::string ServeCommand::givenToken() const
{
    const std::string fromEnvironment = tokenFromEnvironment();  // The ranks get it in no case.
    if (!token.empty()) {
        if (token != "none") stream::checkToken("--token", token);
        return token;
    }
    return tokenFile.empty() ? fromEnvironment : tokenFromFile(tokenFile);
}

stream::PortRange portRange(const std::string& text)
{
    if (text.empty()) return {};
    const auto ports = splitText(text, '-');
    const bool areShort = std::ranges::all_of(ports, [](const auto& port) { return port.size() <= 5; });
    const auto first = wholeTextAs<std::uint16_t>(ports.front()), last = wholeTextAs<std::uint16_t>(ports.back());
    if (ports.size() != 2 || !areShort || !first || !last || *first < 1 || *first > *last)
        throw InputError("--direct-ports", "found '" + text + "'", "two ports such as 41000-41015");
    return {*first, *last};
}

stream::ServeOptions ServeCommand::serveOptions() const
{
    for (const Number& number : numbers) checkWhole(number.name, *number.value, number.rule);
    const std::string& host = serve.web.host;
    if (host.empty()) throw InputError("--host", "found ''", "an address of this host");
    if (serve.certificate.empty() != serve.key.empty())
        throw InputError(serve.certificate.empty() ? "--tls-key" : "--tls-cert", "found without the other",
                         "--tls-cert and --tls-key together");
    for (const auto& [name, path] : {std::pair{"--tls-cert", &serve.certificate}, {"--tls-key", &serve.key}})
        if (!path->empty() && access(path->c_str(), R_OK) != 0)
            throw InputError(name, *path + ": " + std::strerror(errno), "a file that can be read");
    if (serve.job.told.direct && !serve.certificate.empty())
        throw InputError("--direct", "found with --tls-cert", "one of them: ranks have no certificates of their own");
    if (token == "none" && !isLoopback(host) && !iKnow)
        throw InputError("--token", "none, and " + host + " can be reached by others",
                         "a token, or --i-know to let everyone in");
    stream::ServeOptions asked = serve;
    asked.hub.scene = sceneOptions.scene();
    asked.hub.maxViewers = std::size_t(maxViewers);
    asked.hub.drawLimit = std::chrono::seconds(drawLimitS);
    asked.hub.loadLimit = std::chrono::seconds(loadLimitS);
    asked.hub.frameBytes = std::uint64_t(viewerMiB) << 20;
    asked.hub.codec = askedCodec(codec);
    asked.web.port = std::uint16_t(port);
    if (const std::string given = givenToken(); given != "none")
        asked.web.rules.token = given.empty() ? stream::makeToken() : given;
    asked.job.linkPort = std::uint16_t(jobPort);
    const stream::PortRange ports = asked.job.told.directPorts = portRange(directPorts);
    const int places = ports.last - ports.first + 1, ranksHere = serve.launcher.empty() ? serve.job.ranks : 0;
    if (!directPorts.empty() && ranksHere > places)
        throw InputError("--direct-ports", directPorts + " for " + std::to_string(ranksHere) + " ranks on this host",
                         "a port for each");
    asked.program = std::filesystem::read_symlink("/proc/self/exe").string();
    return asked;
}

bool isFile(int number)
{
    struct stat status {};
    return fstat(number, &status) == 0 && S_ISREG(status.st_mode);
}

/// Says where viewers find the server. A file that standard output goes to is a log, which others may read: the token
/// does not stand there.
void ServeCommand::announce(const std::string& address, std::optional<AddressFile>& file) const
{
    const std::size_t query = address.find("?token=");
    const bool hidden = query != address.npos && isFile(STDOUT_FILENO);
    std::string path = addressFile;
    if (hidden && path.empty()) path = defaultAddressFile(address);
    if (!path.empty()) file.emplace(path, address + "\n");
    print(address.substr(0, hidden ? query : address.npos) + "\n" +
          (hidden ? "The address with its token is in " + path + "\n" : ""));
}

void ServeCommand::run() const
{
    if (ranks->size() > 1)
        throw InputError("serve", "started as " + std::to_string(ranks->size()) + " ranks",
                         "one process, which starts the others itself (--ranks N)");
    std::optional<AddressFile> file;
    stream::ServeOptions options = serveOptions();
    options.ready = [&](const std::string& address) { announce(address, file); };
    stream::serve(options);
}

}  // namespace

void addServeCommand(CLI::App& program, const std::shared_ptr<Communicator>& ranks)
{
    CLI::App* command = program.add_subcommand(
        "serve", "Shows a scene in browsers: prints the address to open, and serves it until interrupted.");
    const auto state = std::make_shared<ServeCommand>(*command, ranks);
    command->callback([state] { state->run(); });

    CLI::App* job = program.add_subcommand("render-job", "What serve starts to draw with; of no use by itself.");
    job->group("");
    job->callback([ranks] { stream::runRenderJob(ranks, std::cin); });
}

}  // namespace aeolic
