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
    /// far as traces sample them. Local without `guards`. `fresh`: where `buffer` is a window that goes down a plane,
    /// the rows that are new. Only the jumps that depend on them are computed.
    void run(GBuffer& buffer, const LicOptions& lic, const Extent& compute, GuardExchange* guards,
             const FreshRows& fresh = {});

    /// What Backend::smooth() does. `fine`: where the flow is kept in more bits.
    void smooth(const GBuffer& buffer, const LicOptions& lic, const Extent& compute, RowExchange* beside, int more = 0,
                const FineFlow* fine = nullptr);

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

    FlowCells flow_;
    FineCells fine_;
    Hierarchy hierarchy_;
    FlattenStage flatten_;
    LicImage lic_;
    Image<std::uint32_t> words_;  // A pixel's value and links in one (along_flow.h).
};

}  // namespace aeolic::cpu
