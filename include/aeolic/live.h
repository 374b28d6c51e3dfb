#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "aeolic/renderer.h"

namespace aeolic {

/// Something on the page that changes a number in the program: a slider, a switch or a button.
struct Control {
    enum class Kind { number, toggle, button };
    std::string name;  ///< The text beside it, and its name in Live::value(). Not empty, at most 64 bytes.
    Kind kind = Kind::number;
    double value = 0;       ///< At first. A switch: 0 or 1. A button: how often it was pressed.
    double lo = 0, hi = 1;  ///< What a number may be, both included; finite, lo < hi.
    std::string unit;
};

struct LiveOptions {
    std::string host = "127.0.0.1";  ///< The address to listen on, on rank 0's host.
    std::uint16_t port = 0;          ///< 0: any that is free.
    std::string token;               ///< The secret in the address, 16 characters or more; empty: a random one.
    int largestSide = 4096;          ///< Pixels of a picture's longer side that a viewer may ask for.
    int maxViewers = 16;
    std::string title = "Program";  ///< The text over the controls.
    std::vector<Control> controls;  ///< Names are different from each other.
    bool embedded = false;          ///< Pages of this host, such as notebooks, may hold the page in a frame.
    /// Collective. Shows another surface, other vectors or colours in the renderer, because a viewer has asked for
    /// them; Renderer::reload() does. Empty: viewers cannot ask. What it throws as InputError the viewer is told.
    std::function<void(Renderer&, const SceneDescription&, const ProgressFunction&)> reload;
};

/// Shows in browsers what a program draws, while the program goes on: the page of `aeolic serve`, from a server in this
/// process. Viewers turn the scene and choose how it looks, each for itself; the scene stays the program's. They get
/// pictures when the program calls serve(), for instance between two steps of a simulation.
///
/// The server has one thread of its own on rank 0, and each rank two for its link, which all wait most of the time.
/// Every method is Collective, except address(), value() and waitForRequest(); not thread-safe. One that was moved into
/// another one can be destroyed and assigned to; everything else throws std::logic_error.
class Live {
public:
    /// Opens the server on rank 0 of the ranks that `renderer` draws on. Throws aeolic::InputError, on all ranks, for
    /// an address that cannot be had, a token that is too short, and invalid controls.
    explicit Live(const Renderer& renderer, LiveOptions options = {});
    ~Live();  ///< Tells the viewers that the server stops.
    Live(Live&&) noexcept;
    Live& operator=(Live&&) noexcept;

    /// What to open in a browser, with its token. Empty on other ranks than 0.
    const std::string& address() const;

    /// Tells the viewers what has changed in the scene since the last call, and draws the views asked for by now:
    /// a picture or two. Where nothing is asked for, waits up to `wait` for it. `renderer` has the options afterwards
    /// that it had before. Without viewers, or where there is nothing to do, it takes some microseconds, and with
    /// several ranks two small messages. False once no viewer can come any more; the program then goes on alone. Throws
    /// what drawing throws where a rank or a device failed.
    bool serve(Renderer& renderer, std::chrono::milliseconds wait = std::chrono::milliseconds(0));

    /// A control's value, the same on every rank. Throws std::out_of_range for a name that there is not.
    double value(const std::string& control) const;
    /// Sets a control, which viewers see at the next serve(). A number is kept within its range.
    void setValue(const std::string& control, double value);

    /// Local. Waits up to `time` until serve() has something to do for a viewer, and says whether it has. A program
    /// that draws in a thread of its own may call it while another thread uses the renderer.
    bool waitForRequest(std::chrono::milliseconds time);

private:
    struct State;
    State& held() const;
    std::unique_ptr<State> state_;
};

}  // namespace aeolic
