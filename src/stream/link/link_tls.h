#pragma once

#include <memory>
#include <string>

#include "stream/wire.h"

struct ssl_ctx_st;
struct ssl_st;

namespace aeolic::stream {

/// What one end of the job's links needs for TLS 1.3.
using TlsSide = std::shared_ptr<ssl_ctx_st>;

/// The gateway's side: a key and a certificate that are made now and written nowhere. `fingerprint` becomes the SHA-256
/// of the certificate, in hexadecimal digits. Throws std::runtime_error.
TlsSide makeTlsServer(std::string& fingerprint);

/// A rank's side, which speaks with nobody but the owner of the certificate with this fingerprint.
TlsSide makeTlsClient(const std::string& fingerprint);

/// TLS without a socket: it makes wire bytes of plain ones and back. Not thread-safe. Everything throws
/// std::runtime_error where the other end is not who it should be, or sends nonsense.
class LinkTls {
public:
    LinkTls(const TlsSide& side, bool isServer);

    /// Goes on with the handshake. False while bytes of the other end are needed. The wire bytes are taken by
    /// takeOut().
    bool shakeHands();
    /// Bytes from the wire.
    void putIn(ByteView wireBytes);
    /// The next plain bytes that are there; returns how many, 0 while more have to come from the wire.
    std::size_t read(std::uint8_t* to, std::size_t most);
    /// The bytes for the wire that carry these plain ones, and whatever else is due.
    ByteVector write(ByteView plain);
    /// The bytes for the wire that are due.
    ByteVector takeOut();

private:
    TlsSide side_;
    std::unique_ptr<ssl_st, void (*)(ssl_st*)> ssl_;
};

}  // namespace aeolic::stream
