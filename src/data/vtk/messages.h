#pragma once

#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <string>

namespace aeolic {

class MessageCollector;

/// While it lives, whatever VTK's readers, filters and writers would print is kept instead, and nothing reaches the
/// user's terminal. VTK has one such outlet per process, so scopes of different threads wait for each other; scopes may
/// nest.
class VtkMessages {
public:
    VtkMessages();
    ~VtkMessages();
    VtkMessages(const VtkMessages&) = delete;
    VtkMessages& operator=(const VtkMessages&) = delete;

    bool failed() const { return !firstError().empty(); }
    std::string firstError() const;  ///< One line without VTK's file, line and addresses; empty if there was none.

private:
    vtkSmartPointer<vtkOutputWindow> previous_;
    vtkSmartPointer<MessageCollector> collector_;
};

}  // namespace aeolic
