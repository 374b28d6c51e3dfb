#pragma once

#include "render/cpu/lic/cpu_flatten.h"
#include "render/cpu/lic/fine_cells.h"
#include "render/cpu/lic/flow_cells.h"
#include "render/cpu/lic/hierarchical.h"
#include "render/flatten.h"
#include "render/gbuffer.h"
#include "render/guard_exchange.h"

namespace aeolic::cpu {

/// The LIC stage (paper, section 3). Memory is kept between frames.
class LicStage {
public:
    /// What Backend::convolve() does, from `buffer`: vectors, links and jumps of rows that others own are received as
    /// far as traces sample them.
    void run(GBuffer& buffer, const LicOptions& lic, const Extent& compute, GuardExchange* guards);

    /// Local. The same for a window that goes down a plane: of jumps, only those are computed that depend on fresh
    /// rows. By the hierarchical method.
    void runOn(GBuffer& buffer, const LicOptions& lic, const Extent& compute, const FreshRows& fresh);

    /// What Backend::smooth() does.
    void smooth(const GBuffer& buffer, const LicOptions& lic, const Extent& compute, RowExchange* beside, int more = 0)
    {
        smooth(buffer, nullptr, lic, compute, beside, more);
    }

    /// Local. Both convolutions by the direct method, of flow that is kept in more bits. `buffer` holds `fine` as far
    /// as its bits go, and links.
    void runFine(const GBuffer& buffer, const FineFlow& fine, const LicOptions& lic, const Extent& compute);

    /// What Backend::flatten() does.
    void flatten(const GBuffer& buffer, const LicOptions& lic, const Extent& compute, RowExchange* beside, int more)
    {
        if (flatten::wanted(lic)) flatten_.run(buffer, lic, compute, beside, more, lic_);
    }

    /// The values of the rows computed last.
    LicImage& values() { return lic_; }

private:
    /// Brings vectors and links as far as traces of so many steps sample them. Returns where that is.
    static NearFlow receiveFlow(GBuffer& buffer, const Extent& compute, GuardExchange* guards, int steps);

    void runHierarchical(GBuffer& buffer, const LicOptions& lic, const Extent& compute, GuardExchange* guards,
                         const FreshRows& fresh);
    void smooth(const GBuffer& buffer, const FineFlow* fine, const LicOptions& lic, const Extent& compute,
                RowExchange* beside, int more);

    FlowCells flow_;
    FineCells fine_;
    Hierarchy hierarchy_;
    FlattenStage flatten_;
    LicImage lic_;
    Image<std::uint32_t> words_;  // along_flow::word; a float's bits where there is no second convolution.
};

}  // namespace aeolic::cpu
