#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "aeolic/picture.h"

namespace aeolic {

/// A view to be drawn by a server.
struct StreamView {
    int width = 800, height = 800;
    bool moving = false;  ///< More will follow soon: the picture may be smaller and lossy.
    std::string
        options;  ///< JSON: {"camera":{…},"lic":{…},"shading":{…}} as in a scene file; empty: as the scene has it.
};

/// A picture from a server.
struct StreamFrame {
    Picture picture;
    std::uint32_t frame = 0, view = 0;  ///< The server's number of it; the number requestView() gave.
    std::uint32_t viewer = 0;           ///< Whose view it shows.
    int askedWidth = 0;                 ///< Larger than the picture where it is to be scaled up.
    bool lossless = false;
    std::string stats;        ///< JSON: times and bytes (docs/protocol.md, FrameEnd).
    std::uint64_t bytes = 0;  ///< That came over the network.
};

/// A viewer without a window: connects to `aeolic serve` and gets pictures (docs/protocol.md). Not thread-safe. Every
/// call throws aeolic::InputError for an address that is none, std::runtime_error with one line where the server cannot
/// be reached, refuses, hangs up, or does not answer in time, which ends the connection.
class StreamClient {
public:
    struct Options {
        std::chrono::milliseconds timeout{30000};  ///< For each call.
        bool lossy = true;                         ///< Takes jpeg while moving.
        bool trustAnyCertificate = false;
        std::string name = "aeolic";
    };

    /// `address` as the server printed it: http://HOST:PORT/?token=… or https://…
    explicit StreamClient(const std::string& address);
    StreamClient(const std::string& address, const Options& options);
    ~StreamClient();
    StreamClient(StreamClient&&) noexcept;
    StreamClient& operator=(StreamClient&&) noexcept;

    /// Waits until a scene is loaded. JSON: docs/protocol.md, Scene.
    std::string scene();

    /// Asks for a view; it replaces any that was not drawn yet. Returns its number.
    std::uint32_t requestView(const StreamView& view);

    /// Changes the scene of all viewers. JSON: docs/protocol.md, Change.
    void change(const std::string& json);

    /// The next complete picture, and tells the server that it was shown. Throws where the server says that the view
    /// cannot be drawn.
    StreamFrame nextFrame();

    /// The lossless picture of one view, however many others come before.
    StreamFrame grab(StreamView view);

    /// What the server last said of itself: JSON, docs/protocol.md, State.
    const std::string& state() const;
    std::uint32_t viewer() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace aeolic
