#include "stream/byte_stream.h"

namespace aeolic::stream {

void ByteStream::read(const SomeBuffers<asio::mutable_buffer>& buffers, std::function<void(Error, std::size_t)> handler)
{
    std::visit([&](auto& stream) { stream.async_read_some(buffers, std::move(handler)); }, stream_);
}

void ByteStream::write(const SomeBuffers<asio::const_buffer>& buffers, std::function<void(Error, std::size_t)> handler)
{
    auto noted = [wroteAt = wroteAt_, handler = std::move(handler)](Error error, std::size_t bytes) {
        if (bytes > 0) *wroteAt = std::chrono::steady_clock::now();
        handler(error, bytes);
    };
    std::visit([&](auto& stream) { stream.async_write_some(buffers, std::move(noted)); }, stream_);
}

void ByteStream::tearDown(boost::beast::role_type role, std::function<void(Error)> handler)
{
    using boost::beast::websocket::async_teardown;
    std::visit([&](auto& stream) { async_teardown(role, stream, std::move(handler)); }, stream_);
}

}  // namespace aeolic::stream
