/// What strangers and viewers send to the gateway: HTTP requests, and messages on an open stream.
#include <boost/beast/http/parser.hpp>

#include "fuzz_hub.h"
#include "stream/gateway/http_answers.h"

namespace aeolic::stream::fuzz {
namespace {

void http(ByteView bytes)
{
    namespace beast_http = boost::beast::http;
    static const HttpRules rules{"0123456789abcdef", false, "aeolic-8080", [] { return std::string("{}"); }, {}};
    static const HttpRules open{"", true, "aeolic-8080", [] { return std::string("{}"); }, {"node7"}};
    beast_http::request_parser<beast_http::string_body> parser;
    parser.header_limit(8 * 1024);
    parser.body_limit(1024);
    parser.eager(true);
    boost::system::error_code error;
    parser.put(boost::asio::buffer(bytes.data(), bytes.size()), error);
    if (error || !parser.is_header_done()) return;
    const HttpRequest& request = parser.get();
    for (const HttpRules* each : {&rules, &open}) {
        const bool enters = mayEnter(request, *each), own = isOwnOrigin(request, *each);
        const HttpResponse response = answer(request, *each);
        require(enters == (response.result() != beast_http::status::unauthorized));
        require(enters || response.body().empty());
        require(pathOf(request).find('?') == std::string::npos);
        require(own || request.count(beast_http::field::origin) > 0);
    }
    // The token is in the request wherever it opened the door.
    const std::string all(bytes.begin(), bytes.end());
    if (mayEnter(request, rules)) require(all.find(rules.token) != std::string::npos);
}

void play(FuzzHub& world, const Record& record)
{
    FuzzViewer& viewer = world.viewers[record.what % 3];
    switch (record.what / 3 % 9) {
        case 0:
        case 1:
        case 2:
            world.viewerSays(viewer, record.bytes);
            break;
        case 3:  // As a type and its payload: most inputs would stumble over the header.
            if (!record.bytes.empty()) {
                ByteVector message = beginMessage(MessageType(record.bytes[0] % 8));
                message.insert(message.end(), record.bytes.begin() + 1, record.bytes.end());
                world.viewerSays(viewer, *endMessage(std::move(message)));
            }
            break;
        case 4:
            if (world.drawing) world.drawRows(0, std::uint32_t(world.drawing->scene.output.height));
            world.endFrame();
            break;
        case 5:
            world.viewerSays(viewer, *numberMessage(MessageType::shown, viewer.lastFrame));
            break;
        case 6:
            world.now += std::chrono::milliseconds(record.bytes.size() * 20);
            break;
        case 7:
            world.restart();
            break;
        case 8:
            world.load();
            break;
    }
}

}  // namespace
}  // namespace aeolic::stream::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace aeolic::stream::fuzz;
    const aeolic::stream::ByteView input(data, size);
    if (input.empty()) return 0;
    if (input[0] == 'H') {
        http(input.subspan(1));
        return 0;
    }
    playAll(input, play);
    return 0;
}
