#pragma once

#include <functional>

#include "aeolic/renderer.h"
#include "stream/message.h"
#include "stream/requests.h"

namespace aeolic::stream {

/// Local. Encodes a rank's finished rows in bands, on all threads of the current arena. Each band is handed to `send`
/// as a Tile message as soon as it is ready, in any order; several threads may call `send` at once. Returns the bytes
/// of all messages together.
std::size_t sendStripe(const DrawnFrame& stripe, const DrawRequest& draw, int rank,
                       const std::function<void(WireMessage)>& send);

}  // namespace aeolic::stream
