#include "cluster/balance/balancer.h"

namespace aeolic {
namespace {

/// Gives every rank equally many rows, whatever they show.
class StaticBalancer final : public Balancer {
public:
    std::string name() const override { return "static"; }
    bool needsCoverage() const override { return false; }
    Stripes partition(const BalanceInput& input) const override { return equalStripes(input.height, input.ranks); }
};

}  // namespace

std::unique_ptr<Balancer> makeStaticBalancer()
{
    return std::make_unique<StaticBalancer>();
}

}  // namespace aeolic
