#pragma once

#include <utility>

#include "cluster/comm/together.h"
#include "cluster/composite/deal_triangles.h"
#include "data/load/agreement.h"

namespace aeolic {

/// The agreement of the ranks of a communicator, which has to last as long as this. Errors that all ranks throw are
/// Agreed (cluster/comm/together.h).
class CommunicatorAgreement : public Agreement {
public:
    explicit CommunicatorAgreement(Communicator& ranks) : ranks_(ranks) {}

    FieldPart part() const override { return {ranks_.rank(), ranks_.size()}; }
    void together(const std::function<void()>& action) override { runTogether(ranks_, action); }
    void readTogether(const std::function<void()>& action) override { runTogether(ranks_, action, false); }
    bool isFirstOnHost() const override { return ranks_.isFirstOnHost(); }
    double least(double mine) override { return ranks_.allReduce(mine, Reduction::min); }
    double greatest(double mine) override { return ranks_.allReduce(mine, Reduction::max); }
    std::int64_t sum(std::int64_t mine) override { return ranks_.allReduce(mine, Reduction::sum); }
    void sum(std::span<double> values) override { ranks_.allReduce(values, Reduction::sum); }
    std::vector<std::string> distinct(const std::vector<std::string>& mine) override
    {
        return distinctOfAll(ranks_, mine);
    }
    std::vector<Bytes> gatherAll(Bytes mine) override { return ranks_.allGather(mine); }
    Bytes ofFirst(Bytes bytes) override
    {
        ranks_.broadcast(bytes);
        return bytes;
    }
    std::shared_ptr<const void> shareOnHost(std::shared_ptr<const void> mine, std::size_t bytes) override
    {
        return ranks_.shareOnHost(std::move(mine), bytes);
    }
    void requireSame(const std::string& what, const std::string& value) override
    {
        aeolic::requireSame(ranks_, what, value);
    }
    SurfaceMesh dealToBricks(SurfaceMesh piece, const GridField& field, const GridField* dealtBy) override
    {
        return aeolic::dealToBricks(ranks_, std::move(piece), field, dealtBy);
    }

private:
    Communicator& ranks_;
};

}  // namespace aeolic
