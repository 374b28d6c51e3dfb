#include "stream/link/link_tls.h"

#include <fmt/format.h>
#include <openssl/err.h>
#include <openssl/evp.h>
#include <openssl/rand.h>
#include <openssl/ssl.h>
#include <openssl/x509.h>

#include <array>
#include <stdexcept>

#include "stream/token.h"

namespace aeolic::stream {
namespace {

[[noreturn]] void fail(const char* what)
{
    char reason[256] = "";
    const unsigned long error = ERR_get_error();
    ERR_error_string_n(error, reason, sizeof(reason));
    ERR_clear_error();
    throw std::runtime_error(std::string(what) + (error ? std::string(": ") + reason : std::string()));
}

std::string fingerprintOf(const X509* certificate)
{
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
    unsigned bytes = 0;
    if (X509_digest(certificate, EVP_sha256(), digest.data(), &bytes) != 1) fail("no fingerprint of a certificate");
    return fmt::format("{:02x}", fmt::join(digest.begin(), digest.begin() + bytes, ""));
}

TlsSide newSide(const SSL_METHOD* method)
{
    TlsSide side(SSL_CTX_new(method), SSL_CTX_free);
    if (!side || SSL_CTX_set_min_proto_version(side.get(), TLS1_3_VERSION) != 1) fail("TLS cannot be had");
    SSL_CTX_set_session_cache_mode(side.get(), SSL_SESS_CACHE_OFF);
    SSL_CTX_set_num_tickets(side.get(), 0);  // Nobody comes twice.
    return side;
}

/// The certificate signs itself, so nothing but its fingerprint counts.
int isTheGateway(X509_STORE_CTX* shown, void* fingerprint)
{
    const X509* certificate = X509_STORE_CTX_get0_cert(shown);
    return certificate && sameToken(fingerprintOf(certificate), *static_cast<std::string*>(fingerprint)) ? 1 : 0;
}

}  // namespace

TlsSide makeTlsServer(std::string& fingerprint)
{
    const std::unique_ptr<EVP_PKEY, void (*)(EVP_PKEY*)> key(EVP_EC_gen("P-256"), EVP_PKEY_free);
    const std::unique_ptr<X509, void (*)(X509*)> certificate(X509_new(), X509_free);
    if (!key || !certificate) fail("no key for the links");
    X509_set_version(certificate.get(), X509_VERSION_3);
    ASN1_INTEGER_set(X509_get_serialNumber(certificate.get()), 1);
    X509_gmtime_adj(X509_getm_notBefore(certificate.get()), -86400);
    X509_gmtime_adj(X509_getm_notAfter(certificate.get()), 365L * 86400);
    X509_NAME* name = X509_get_subject_name(certificate.get());
    X509_NAME_add_entry_by_txt(name, "CN", MBSTRING_ASC, reinterpret_cast<const unsigned char*>("aeolic"), -1, -1, 0);
    X509_set_issuer_name(certificate.get(), name);
    X509_set_pubkey(certificate.get(), key.get());
    if (X509_sign(certificate.get(), key.get(), EVP_sha256()) == 0) fail("no certificate for the links");
    TlsSide side = newSide(TLS_server_method());
    if (SSL_CTX_use_certificate(side.get(), certificate.get()) != 1 ||
        SSL_CTX_use_PrivateKey(side.get(), key.get()) != 1)
        fail("no certificate for the links");
    fingerprint = fingerprintOf(certificate.get());
    return side;
}

TlsSide makeTlsClient(const std::string& fingerprint)
{
    TlsSide side = newSide(TLS_client_method());
    const auto right = std::make_shared<std::string>(fingerprint);
    SSL_CTX_set_verify(side.get(), SSL_VERIFY_PEER, nullptr);
    SSL_CTX_set_cert_verify_callback(side.get(), isTheGateway, right.get());
    return {side.get(), [side, right](ssl_ctx_st*) mutable { side.reset(); }};
}

LinkTls::LinkTls(const TlsSide& side, bool isServer) : side_(side), ssl_(SSL_new(side.get()), SSL_free)
{
    BIO *in = BIO_new(BIO_s_mem()), *out = BIO_new(BIO_s_mem());
    if (!ssl_ || !in || !out) fail("TLS cannot be had");
    SSL_set_bio(ssl_.get(), in, out);
    isServer ? SSL_set_accept_state(ssl_.get()) : SSL_set_connect_state(ssl_.get());
}

bool LinkTls::shakeHands()
{
    ERR_clear_error();
    const int result = SSL_do_handshake(ssl_.get());
    if (result == 1) return true;
    if (SSL_get_error(ssl_.get(), result) != SSL_ERROR_WANT_READ) fail("no TLS with the other end");
    return false;
}

void LinkTls::putIn(ByteView wireBytes)
{
    if (BIO_write(SSL_get_rbio(ssl_.get()), wireBytes.data(), int(wireBytes.size())) != int(wireBytes.size()))
        fail("TLS takes no more");
}

std::size_t LinkTls::read(std::uint8_t* to, std::size_t most)
{
    ERR_clear_error();
    std::size_t got = 0;
    const int result = SSL_read_ex(ssl_.get(), to, most, &got);
    if (result == 1) return got;
    if (SSL_get_error(ssl_.get(), result) != SSL_ERROR_WANT_READ) fail("the other end broke TLS");
    return 0;
}

ByteVector LinkTls::write(ByteView plain)
{
    ERR_clear_error();
    std::size_t written = 0;
    // A memory takes everything at once.
    if (!plain.empty() && SSL_write_ex(ssl_.get(), plain.data(), plain.size(), &written) != 1) fail("TLS cannot write");
    return takeOut();
}

ByteVector LinkTls::takeOut()
{
    BIO* out = SSL_get_wbio(ssl_.get());
    ByteVector bytes(BIO_ctrl_pending(out));
    if (!bytes.empty() && BIO_read(out, bytes.data(), int(bytes.size())) != int(bytes.size())) fail("TLS loses bytes");
    return bytes;
}

}  // namespace aeolic::stream
