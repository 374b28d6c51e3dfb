#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/extent.h"
#include "cluster/balance/stripes.h"
#include "cluster/comm/communicator.h"
#include "render/guard_exchange.h"
#include "render/lic/row_flow.h"

namespace aeolic {

/// What one group of images gives to a message: these pixels of each, one image after the other.
struct RowLoad {
    const std::vector<ImageRows>* images;
    std::vector<Extent> pixels;
};

/// The bytes that all loads of a message take together.
std::size_t bytesOf(const std::vector<RowLoad>& loads);

/// Collective among those who exchange something. Packs the pixels of `toRank` [ranks], sends them, and copies what
/// comes to the pixels of `fromRank` [ranks]. Every rank knows what the others send. `room`: memory to pack messages
/// in. Its content means nothing after a call. It can be kept between frames, because new memory costs more than
/// copying into it. Cost: one message to each rank that is sent anything, and two copies.
void exchangeRows(Communicator& communicator, const std::vector<std::vector<RowLoad>>& toRank,
                  const std::vector<std::vector<RowLoad>>& fromRank, Bytes& room);

/// Collective. `whole`: so many bytes for each row of the image, of which each rank fills in those of its stripe. On
/// return it has those of all. Cost: every row from its owner to everyone.
void allGatherRows(Communicator& communicator, const Stripes& stripes, std::span<std::byte> whole,
                   std::size_t bytesPerRow);

/// Collective. Gathers the facts of the whole image from those of each rank's stripe. Cost: 6 bytes a row, from its
/// owner to everyone.
std::vector<RowFlow> gatherRowFlow(Communicator& communicator, const Stripes& stripes, const std::vector<RowFlow>& own);

}  // namespace aeolic
