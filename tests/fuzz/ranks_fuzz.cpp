/// What comes over a rank's link: whole messages of any type, and tiles that are nearly right.
#include "fuzz_hub.h"

namespace aeolic::stream::fuzz {
namespace {

void play(FuzzHub& world, const Record& record)
{
    const auto number = [&](std::size_t at) { return at < record.bytes.size() ? std::uint32_t(record.bytes[at]) : 0u; };
    switch (record.what % 6) {
        case 0:  // As it comes off the link, header and all.
            try {
                const MessageHeader header = parseHeader(record.bytes, Sender::rank);
                require(header.payloadBytes <= payloadLimit(std::uint8_t(header.type), Sender::rank));
            } catch (const ProtocolError&) {
            }
            world.jobSays(std::make_shared<const ByteVector>(record.bytes.begin(), record.bytes.end()));
            break;
        case 1:  // A type and its payload.
            if (!record.bytes.empty()) {
                ByteVector message = beginMessage(MessageType(record.bytes[0]));
                message.insert(message.end(), record.bytes.begin() + 1, record.bytes.end());
                world.jobSays(endMessage(std::move(message)));
            }
            break;
        case 2:  // A Join is JSON to its end before anything of it is looked at.
            try {
                parseJson(parseMessage(record.bytes, Sender::rank).payload);
            } catch (const ProtocolError&) {
            }
            break;
        case 3:
            world.viewerSays(
                world.viewers[number(0) % 3],
                *jsonMessage(MessageType::view, number(1) % 2 ? R"({"view":1,"moving":true,"width":40,"height":30})"
                                                              : R"({"view":2,"moving":false,"width":7,"height":9})"));
            break;
        case 4:
            world.drawRows(number(0), number(1));
            break;
        case 5:
            world.endFrame();
            break;
    }
}

}  // namespace
}  // namespace aeolic::stream::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace aeolic::stream::fuzz;
    playAll({data, size}, play);
    return 0;
}
