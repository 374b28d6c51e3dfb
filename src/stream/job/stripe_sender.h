#pragma once

#include <functional>

#include "aeolic/renderer.h"
#include "stream/message.h"
#include "stream/requests.h"

namespace aeolic::stream {

/// Local. Encodes a rank's finished rows in bands, on all threads of the current arena, and hands each on as a Tile
/// message as soon as it is ready, in any order; `send` may be called from several threads at once. Returns the bytes
/// of all messages together.
std::size_t sendStripe(const PictureStripe& stripe, const DrawRequest& draw, int rank,
                       const std::function<void(WireMessage)>& send);

}  // namespace aeolic::stream
