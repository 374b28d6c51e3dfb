#include "render/gl/device/stage_timers.h"

#include <iterator>

namespace aeolic::gl {
namespace {

/// Which member of DeviceTimes counts a stage, by the stage's number.
constexpr double DeviceTimes::*kTimeOf[] = {&DeviceTimes::projectMs, &DeviceTimes::convolveMs, &DeviceTimes::shadeMs,
                                            &DeviceTimes::readBackMs};
static_assert(std::size(kTimeOf) == std::size_t(Stage::readBack) + 1);

Query makeQuery()
{
    GLuint id = 0;
    glCreateQueries(GL_TIMESTAMP, 1, &id);
    return Query(id);
}

double milliseconds(const Query& begin, const Query& end)
{
    GLuint64 from = 0, to = 0;
    glGetQueryObjectui64v(begin, GL_QUERY_RESULT, &from);
    glGetQueryObjectui64v(end, GL_QUERY_RESULT, &to);
    return double(to - from) * 1e-6;
}

}  // namespace

void StageTimers::begin(Stage stage)
{
    if (used_ == intervals_.size()) intervals_.push_back({stage, makeQuery(), makeQuery()});
    intervals_[used_].stage = stage;
    glQueryCounter(intervals_[used_].begin, GL_TIMESTAMP);
}

void StageTimers::end()
{
    glQueryCounter(intervals_[used_].end, GL_TIMESTAMP);
    ++used_;
}

DeviceTimes StageTimers::read()
{
    DeviceTimes times;
    for (std::size_t i = 0; i < used_; ++i) {
        const Interval& interval = intervals_[i];
        times.*kTimeOf[std::size_t(interval.stage)] += milliseconds(interval.begin, interval.end);
    }
    used_ = 0;
    return times;
}

}  // namespace aeolic::gl
