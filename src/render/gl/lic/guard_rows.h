#pragma once

#include <vector>

#include "render/gl/device/read_back.h"
#include "render/gl/device/stage_timers.h"
#include "render/gl/project/frame_images.h"
#include "render/guard_exchange.h"

namespace aeolic::gl {

/// The way of guard rows between GPUs: off this one, through the ranks' exchange, onto it, by memory that device and
/// process share. Only the rows that others read, and that are read here, move. What is computed between send() and
/// receive() keeps the device busy meanwhile.
class GuardRowExchange {
public:
    /// A layer of a texture of the rows held.
    struct Plane {
        const Texture* texture;
        int layer;
    };

    /// `compute`: this rank's stripe of the rows `valid`.
    void begin(GuardExchange& guards, const Extent& compute, const Extent& valid, StageTimers& timers);

    /// Local. Planes of one kind of texel whose rows around the stripe, as far as traces of `reach` steps go, are to
    /// come from others by the next send() and receive().
    void add(const std::vector<Plane>& planes, int reach);

    /// Local. Rows of the added images, at the stripe's upper and lower end, that others read.
    GuardRows sent() const;

    /// Local. Starts the way of those rows off the device, as the commands given so far leave them.
    void send();

    /// Collective. Waits for them, exchanges them, and starts the way of the others' onto the device.
    void receive();

private:
    struct Transfer {
        std::vector<Plane> planes;
        int reach;
        std::size_t offset;  ///< Where its planes' rows begin in the memory, one after the other.
    };
    ImageRows rowsOf(const Transfer& transfer, std::size_t plane) const;
    std::size_t planeBytes(const Transfer& transfer) const;
    /// Calls move(plane, first row of the rows held, past the last, offset into the memory) for rows [y0, y1), global.
    template <class Move>
    void forEachPlane(const Transfer& transfer, int y0, int y1, const Move& move) const;

    GuardExchange* guards_ = nullptr;
    StageTimers* timers_ = nullptr;  // Stopped while others are waited for.
    Extent compute_, valid_;
    std::vector<Transfer> transfers_;
    std::size_t bytes_ = 0;
    SharedMemory memory_{true};
    Fence copied_;
};

}  // namespace aeolic::gl
