#pragma once

namespace aeolic {

/// Told how far loading is: `fraction` from 0 to 1 of what `what` says.
using Progress = void (*)(const char* what, double fraction, void* context);

/// A caller's wish to hear how far loading is, or none.
struct ProgressReport {
    Progress function = nullptr;
    void* context = nullptr;

    void operator()(const char* what, double fraction) const
    {
        if (function) function(what, fraction, context);
    }
};

}  // namespace aeolic
