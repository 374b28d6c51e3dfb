#pragma once

#include <string>

#include "stages/stages.h"

namespace aeolic {

/// The table for people, in parts as it is measured. Lines have at most 110 columns, and on a GPU 150.
class StagesTable {
public:
    /// `plan` must outlive the table.
    explicit StagesTable(const StagesBenchPlan& plan) : plan_(plan) {}

    /// What `soFar` has more than the last time: at first the heading, then rows.
    std::string next(const StagesBench& soFar);

    /// What the numbers mean, to be shown below.
    static std::string notes(const StagesBench& all);

private:
    const StagesBenchPlan& plan_;
    bool begun_ = false;
    std::size_t rows_ = 0;  // Shown so far.
};

/// For programs: machine, scene, rates, rows.
std::string stagesJson(const StagesBenchPlan& plan, const StagesBench& bench);

}  // namespace aeolic
