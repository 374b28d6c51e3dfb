#pragma once

#include "cluster/balance/stripes.h"
#include "cluster/comm/communicator.h"
#include "render/edge_exchange.h"

namespace aeolic {

/// Edges of a surface in pieces: the owner of a row says where its edges are, and every rank answers with what its
/// piece shows there. A message of edges holds the rows' words of bits (EdgeMask). A message of samples holds
/// EdgePixelSeen after EdgePixelSeen. Throws std::runtime_error naming the sender of any other message.
class EdgeComposite final : public EdgeExchange {
public:
    EdgeComposite(Communicator& communicator, const Stripes& stripes, int width)
        : communicator_(communicator), stripes_(stripes), width_(width)
    {
    }

    EdgeMask gather(const EdgeMask& mine) override;
    std::vector<EdgePixelSeen> exchange(const std::vector<EdgePixelSeen>& mine) override;

private:
    Communicator& communicator_;
    const Stripes& stripes_;
    int width_;
};

}  // namespace aeolic
