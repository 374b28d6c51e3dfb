#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "aeolic/picture.h"

namespace aeolic {

/// A view that a server is asked to draw.
struct StreamView {
    int width = 800, height = 800;
    bool moving = false;  ///< More views will follow soon: the picture may be smaller and lossy.
    /// JSON as in a scene file: {"camera":{…},"lic":{…},"shading":{…}}. Empty: the scene's own options.
    std::string options;
};

/// A picture from a server.
struct StreamFrame {
    Picture picture;
    std::uint32_t frame = 0;   ///< The server's number of this frame.
    std::uint32_t view = 0;    ///< The number that requestView() gave.
    std::uint32_t viewer = 0;  ///< The viewer whose view it shows.
    int askedWidth = 0;        ///< Larger than the picture's width if the picture is to be scaled up.
    bool lossless = false;
    std::string stats;        ///< JSON: times and bytes (docs/protocol.md, FrameEnd).
    std::uint64_t bytes = 0;  ///< Bytes that came over the network.
};

/// A viewer without a window: it connects to `aeolic serve` and gets pictures (docs/protocol.md). Not thread-safe. The
/// constructor throws aeolic::InputError for a wrong address. Every call throws std::runtime_error with one line if the
/// server cannot be reached, refuses, hangs up, or does not answer in time; the connection has then ended. All tiles
/// come through the server, also where its ranks send theirs to browsers themselves (--direct). One that was moved into
/// another one can be destroyed and assigned to; everything else throws std::logic_error.
class StreamClient {
public:
    struct Options {
        std::chrono::milliseconds timeout{30000};  ///< For each call.
        bool lossy = true;                         ///< Takes jpeg while moving.
        bool trustAnyCertificate = false;
        std::string name = "aeolic";
        std::string token;  ///< For an address that holds none.
    };

    /// `address` as the server printed it: http://HOST:PORT/?token=… or https://…
    explicit StreamClient(const std::string& address);
    StreamClient(const std::string& address, const Options& options);
    ~StreamClient();
    StreamClient(StreamClient&&) noexcept;
    StreamClient& operator=(StreamClient&&) noexcept;

    /// Waits until a scene is loaded. JSON: docs/protocol.md, Scene.
    std::string scene();

    /// Asks for a view and returns its number. It replaces a view that was asked for before and not drawn yet.
    std::uint32_t requestView(const StreamView& view);

    /// Changes the scene of all viewers. JSON: docs/protocol.md, Change.
    void change(const std::string& json);

    /// Waits for the next complete picture, and tells the server that it was shown. Throws if the server says that the
    /// view cannot be drawn.
    StreamFrame nextFrame();

    /// Asks for one view and waits for its lossless picture. Other pictures that come before are left out.
    StreamFrame grab(StreamView view);

    /// The server's last message about itself. JSON: docs/protocol.md, State.
    const std::string& state() const;
    std::uint32_t viewer() const;

private:
    struct State;
    State& held() const;
    std::unique_ptr<State> state_;
};

}  // namespace aeolic
