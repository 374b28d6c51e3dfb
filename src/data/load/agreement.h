#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/uninitialized.h"
#include "data/bricks.h"
#include "data/mesh/surface_mesh.h"
#include "data/vector_field.h"

namespace aeolic {

/// What the ranks that load one scene tell each other, where each may hold a part of it. *Collective* operations must
/// be called by all ranks, in the same order.
class Agreement {
public:
    virtual ~Agreement() = default;

    /// Local. Which rank of how many this one is.
    virtual FieldPart part() const = 0;

    /// Collective. Runs `action`, which is Local, on every rank. Where it throws on any rank, every rank throws that
    /// error.
    virtual void together(const std::function<void()>& action) = 0;

    /// Collective. together() where some ranks read for all: who it was that could not is of no interest to the user.
    virtual void readTogether(const std::function<void()>& action) = 0;

    /// Local. Whether this rank is the first of its host.
    virtual bool isFirstOnHost() const = 0;

    /// Collective. The least, the greatest, or the sum of what the ranks give.
    virtual double least(double mine) = 0;
    virtual double greatest(double mine) = 0;
    virtual std::int64_t sum(std::int64_t mine) = 0;

    /// Collective. values[i] becomes the sum of the ranks' values[i]; as many everywhere. It rounds unless of each i
    /// all ranks but one give zero.
    virtual void sum(std::span<double> values) = 0;

    /// Collective. Whether it holds on any rank, or on all.
    bool any(bool mine) { return sum(mine ? 1 : 0) > 0; }
    bool all(bool mine) { return sum(mine ? 0 : 1) == 0; }

    /// Collective. The texts of all ranks, by rank, each text once.
    virtual std::vector<std::string> distinct(const std::vector<std::string>& mine) = 0;

    /// Collective. What every rank gives, by rank. Bytes travel as they lie in memory.
    virtual std::vector<Bytes> gatherAll(Bytes mine) = 0;

    /// Collective. What the first rank gives.
    virtual Bytes ofFirst(Bytes bytes) = 0;

    /// Collective. What the first rank of each host gives, in memory that the host has once. Nobody may write to it. It
    /// has to go before this does. `bytes`: of what this rank gives.
    virtual std::shared_ptr<const void> shareOnHost(std::shared_ptr<const void> mine, std::size_t bytes) = 0;

    /// Collective. Throws on every rank InputError that names `what`, unless `value` is the same on all.
    virtual void requireSame(const std::string& what, const std::string& value) = 0;

    /// Collective. Gives every rank the triangles that reach into its brick (cluster/composite/deal_triangles.h).
    virtual SurfaceMesh dealToBricks(SurfaceMesh piece, const GridField& field, const GridField* dealtBy) = 0;
};

/// The agreement of a rank that loads alone. All of it is Local.
class OneRank final : public Agreement {
public:
    FieldPart part() const override { return {}; }
    void together(const std::function<void()>& action) override { action(); }
    void readTogether(const std::function<void()>& action) override { action(); }
    bool isFirstOnHost() const override { return true; }
    double least(double mine) override { return mine; }
    double greatest(double mine) override { return mine; }
    std::int64_t sum(std::int64_t mine) override { return mine; }
    void sum(std::span<double>) override {}
    std::vector<std::string> distinct(const std::vector<std::string>& mine) override { return mine; }
    std::vector<Bytes> gatherAll(Bytes mine) override
    {
        std::vector<Bytes> all;
        all.push_back(std::move(mine));
        return all;
    }
    Bytes ofFirst(Bytes bytes) override { return bytes; }
    std::shared_ptr<const void> shareOnHost(std::shared_ptr<const void> mine, std::size_t) override { return mine; }
    void requireSame(const std::string&, const std::string&) override {}
    SurfaceMesh dealToBricks(SurfaceMesh piece, const GridField&, const GridField*) override { return piece; }
};

}  // namespace aeolic
