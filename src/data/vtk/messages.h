#pragma once

#include <string>

namespace aeolic {

class MessageOutlet;

/// While it lives, whatever VTK's readers, filters and writers would print is kept instead, and nothing reaches the
/// user's terminal. Several threads may have one each: each gets what was said on its own thread, and all get what a
/// filter said on a thread of its own. Scopes may nest: the innermost of a thread gets it.
class VtkMessages {
public:
    VtkMessages();
    ~VtkMessages();
    VtkMessages(const VtkMessages&) = delete;
    VtkMessages& operator=(const VtkMessages&) = delete;

    bool failed() const { return !firstError().empty(); }
    std::string firstError() const;  ///< One line without VTK's file, line and addresses; empty if there was none.
    std::string place() const;       ///< The file that it is about, where that is known.

    /// While it lives, what is said on this thread is about that file: one of several that VTK reads as one.
    class About {
    public:
        explicit About(std::string file);
        ~About();
        About(const About&) = delete;
        About& operator=(const About&) = delete;

    private:
        std::string before_;
    };

private:
    friend class MessageOutlet;

    VtkMessages* outer_;         // The next outer scope of this thread.
    std::string error_, place_;  // Guarded by the mutex of all scopes.
};

}  // namespace aeolic
