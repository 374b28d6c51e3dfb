#pragma once

#include <string>

#include "codecs/codecs.h"

namespace aeolic {

/// The tables for people, in parts as they are measured. Lines have at most 110 columns.
class CodecsTables {
public:
    /// `plan` must outlive the tables.
    explicit CodecsTables(const CodecsBenchPlan& plan) : plan_(plan) {}

    /// What `soFar` has more than the last time: at first the heading, then rows.
    std::string next(const CodecsBench& soFar);

    /// What the numbers mean, to be shown below.
    static std::string notes(const CodecsBench& all);

private:
    const CodecsBenchPlan& plan_;
    bool begun_ = false;
    std::size_t bandRows_ = 0, wholeRows_ = 0;  // Shown so far.
};

/// For programs: machine, scene, rows with both ways of each codec.
std::string codecsJson(const CodecsBenchPlan& plan, const CodecsBench& bench);

}  // namespace aeolic
