#pragma once

#include <epoxy/gl.h>

#include <utility>

namespace aeolic::testkit {

/// Replaces a function of OpenGL for as long as it lives, e.g. Replaced spy(glFenceSync, counted). libepoxy calls
/// through pointers that the first call sets, so something must be drawn beforehand.
template <class Function>
class Replaced {
public:
    Replaced(Function& place, Function by) : place_(place), original_(std::exchange(place, by)) {}
    ~Replaced() { place_ = original_; }
    Replaced(const Replaced&) = delete;
    Replaced& operator=(const Replaced&) = delete;

    Function original() const { return original_; }

private:
    Function &place_, original_;
};

}  // namespace aeolic::testkit
