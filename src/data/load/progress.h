#pragma once

#include "data/scene.h"

namespace aeolic {

/// A caller's wish to hear how far loading is, or none.
struct ProgressReport {
    Progress function = nullptr;
    void* context = nullptr;

    /// `fraction` from 0 to 1 of what `what` says.
    void operator()(const char* what, double fraction) const
    {
        if (function) function(what, fraction, context);
    }
};

}  // namespace aeolic
