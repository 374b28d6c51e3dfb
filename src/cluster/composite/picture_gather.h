#pragma once

#include <cstdint>
#include <vector>

#include "cluster/balance/stripes.h"
#include "cluster/comm/communicator.h"
#include "cluster/composite/painted_pixels.h"

namespace aeolic {

/// The size of the list of columns that are painted in a stripe's rows.
constexpr std::int64_t paintedColumnsBytes(int rows)
{
    return std::int64_t(sizeof(std::int32_t)) * (1 + 2 * std::int64_t(rows));
}

/// Collective, on ranks other than 0: packs the painted pixels of `stripe` and sends them, with paintedColumnsBytes()
/// after it, in one message. Background stays where it is.
void sendPainted(Communicator& communicator, const Tile& stripe, PaintedPixels& packed);

/// Collective, on rank 0: what all others sent, by rank. Throws std::runtime_error naming the rank that sends anything
/// but rows of its own.
void receivePainted(Communicator& communicator, const Stripes& stripes, int width, std::vector<PaintedPixels>& others);

}  // namespace aeolic
