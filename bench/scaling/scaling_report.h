#pragma once

#include <string>

#include "scaling/scaling.h"

namespace aeolic {

/// The tables for people, in parts as they are measured. Lines have at most 110 columns for up to eight numbers of
/// ranks.
class ScalingTables {
public:
    /// `plan` must outlive the tables.
    explicit ScalingTables(const ScalingBenchPlan& plan) : plan_(plan) {}

    /// What `soFar` has more than the last time: at first the heading, then rows, and what sums them up.
    std::string next(const ScalingBench& soFar);

    /// What the numbers mean, to be shown below.
    std::string notes(const ScalingBench& all) const;

private:
    std::string nodesRow(const ScalingRow& row);
    std::string otherRow(const ScalingRow& row);

    const ScalingBenchPlan& plan_;
    bool begun_ = false, summedUp_ = false;
    std::size_t rows_ = 0, simulations_ = 0;  // Shown so far.
    int lastRanks_ = 0;
    std::string lastSetting_;
};

/// "100 Gbit/s and 2 us a message"
std::string networkText(const NetworkModel& network);

/// Pictures a second; 0 where they take no time.
double framesPerSecond(double ms);

/// For programs: machine, scene, networks, rows with every rank of the median frame, costs, simulations.
std::string scalingJson(const ScalingBenchPlan& plan, const ScalingBench& bench);

/// An SVG picture: speedup against the number of nodes, modelled, for every balancer, beside the paper's and the ideal.
/// Needs the plan's part `nodes`.
std::string scalingPlot(const ScalingBenchPlan& plan, const ScalingBench& bench);

}  // namespace aeolic
