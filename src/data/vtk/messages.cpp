#include "data/vtk/messages.h"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <mutex>
#include <utility>
#include <vector>

namespace aeolic {

namespace {

/// "ERROR: In ../IO/XML/vtkXMLReader.cxx, line 578\nvtkXMLReader (0x5581): Error opening file x\n\n" -> "Error opening
/// file x"; "Generic Warning: In ../vtkDataReader.cxx, line 1519\nError reading binary data!" -> "Error reading binary
/// data!".
std::string oneLine(const char* text)
{
    std::string line = text ? text : "";
    if (const std::size_t place = line.find(", line "), end = line.find('\n'); place < end && end != std::string::npos)
        line.erase(0, end + 1);
    if (const std::size_t address = line.find("(0x"); address != std::string::npos)
        if (const std::size_t end = line.find("): ", address); end != std::string::npos) line.erase(0, end + 3);
    std::string out;
    for (const char c : line) {
        const bool space = static_cast<unsigned char>(c) <= ' ';
        if (!space)
            out += c;
        else if (!out.empty() && out.back() != ' ')
            out += ' ';
    }
    while (!out.empty() && (out.back() == ' ' || out.back() == '.')) out.pop_back();
    return out.empty() ? "no reason was given" : out;
}

/// What does no harm: keys that tell the range of an array's values cannot tell an infinite one, and a block of no
/// points may do without Points.
bool isHarmless(const std::string& line)
{
    return line.starts_with("Error reading InformationKey") || line.starts_with("No Points element available");
}

/// What does not name the array: the line that follows does.
bool isVague(const std::string& line)
{
    return line.starts_with("Error reading extent") || line.starts_with("Error reading uncompressed") ||
           line.find("ompression header") != std::string::npos;
}

std::mutex scopesMutex;
std::vector<VtkMessages*> scopes;
vtkSmartPointer<vtkOutputWindow> outletBefore;
thread_local VtkMessages* innermostScope = nullptr;
thread_local std::string fileBeingRead;

}  // namespace

/// VTK has one outlet per process: this one, as long as any scope lives.
class MessageOutlet : public vtkOutputWindow {
public:
    static MessageOutlet* New() { VTK_STANDARD_NEW_BODY(MessageOutlet); }
    vtkTypeMacro(MessageOutlet, vtkOutputWindow)

        void DisplayText(const char*) override
    {
    }
    void DisplayDebugText(const char*) override {}
    void DisplayErrorText(const char* text) override { keep(oneLine(text)); }
    void DisplayWarningText(const char* text) override { keepIfError(text); }
    void DisplayGenericWarningText(const char* text) override { keepIfError(text); }

private:
    static void keep(const std::string& line)
    {
        if (isHarmless(line)) return;
        const std::lock_guard lock(scopesMutex);
        for (VtkMessages* scope : innermostScope ? std::vector<VtkMessages*>{innermostScope} : scopes)
            if (scope->error_.empty() || isVague(scope->error_)) scope->error_ = line, scope->place_ = fileBeingRead;
    }
    /// Some readers call it a warning that data ended too early.
    static void keepIfError(const char* text)
    {
        const std::string line = oneLine(text);
        if (line.starts_with("Error") || line.starts_with("File operation failed")) keep(line);
    }
};

VtkMessages::VtkMessages()
{
    const std::lock_guard lock(scopesMutex);
    outer_ = std::exchange(innermostScope, this);
    scopes.push_back(this);
    if (scopes.size() > 1) return;
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    outletBefore = vtkOutputWindow::GetInstance();
    vtkOutputWindow::SetInstance(vtkSmartPointer<MessageOutlet>::New());
}

VtkMessages::~VtkMessages()
{
    const std::lock_guard lock(scopesMutex);
    innermostScope = outer_;
    std::erase(scopes, this);
    if (!scopes.empty()) return;
    vtkOutputWindow::SetInstance(outletBefore);
    outletBefore = nullptr;
}

std::string VtkMessages::firstError() const
{
    const std::lock_guard lock(scopesMutex);
    return error_;
}

std::string VtkMessages::place() const
{
    const std::lock_guard lock(scopesMutex);
    return place_;
}

VtkMessages::About::About(std::string file) : before_(std::exchange(fileBeingRead, std::move(file))) {}

VtkMessages::About::~About()
{
    fileBeingRead = std::move(before_);
}

}  // namespace aeolic
