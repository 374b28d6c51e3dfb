#pragma once

#include "cluster/balance/stripes.h"
#include "cluster/comm/communicator.h"
#include "render/guard_exchange.h"

namespace aeolic {

/// Finished rows from the ranks next to a stripe. Stripes may have fewer rows than are asked for: then rows come from
/// several.
class StripeNeighbours final : public RowExchange {
public:
    StripeNeighbours(Communicator& communicator, const Stripes& stripes)
        : communicator_(communicator), stripes_(stripes)
    {
    }

    void receive(const ImageRows& image, int rows) override;

private:
    Communicator& communicator_;
    const Stripes& stripes_;
};

}  // namespace aeolic
