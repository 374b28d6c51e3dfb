#include "stream/listen.h"

#include <boost/asio/ip/v6_only.hpp>

namespace aeolic::stream {
namespace {

using Error = boost::system::error_code;

/// Fills in `error` where the port cannot be had.
Tcp::acceptor listenAt(asio::io_context& io, const Tcp::endpoint& place, bool bothKinds, Error& error)
{
    Tcp::acceptor acceptor(io);
    acceptor.open(place.protocol(), error);
    if (!error && bothKinds) acceptor.set_option(asio::ip::v6_only(false), error);
    if (!error && place.port() != 0) acceptor.set_option(Tcp::acceptor::reuse_address(true), error);
    if (!error) acceptor.bind(place, error);
    if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
    return acceptor;
}

}  // namespace

Tcp::acceptor listenOn(asio::io_context& io, const std::string& host, PortRange ports)
{
    asio::ip::address address = asio::ip::address_v6::any();
    if (!host.empty())
        address = Tcp::resolver(io).resolve(host, "0", Tcp::resolver::passive).begin()->endpoint().address();
    Error error;
    for (unsigned port = ports.first; port <= ports.last; ++port) {
        const auto number = std::uint16_t(port);
        Tcp::acceptor acceptor = listenAt(io, {address, number}, address.is_unspecified() && address.is_v6(), error);
        // A host without IPv6.
        if (error && host.empty() && error != asio::error::address_in_use)
            acceptor = listenAt(io, {asio::ip::address_v4::any(), number}, false, error);
        if (!error) return acceptor;
    }
    throw boost::system::system_error(error);
}

asio::ip::address plainAddress(const asio::ip::address& address)
{
    if (!address.is_v6() || !address.to_v6().is_v4_mapped()) return address;
    return asio::ip::make_address_v4(asio::ip::v4_mapped, address.to_v6());
}

}  // namespace aeolic::stream
