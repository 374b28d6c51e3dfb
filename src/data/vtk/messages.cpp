#include "data/vtk/messages.h"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>

#include <mutex>

namespace aeolic {

namespace {

std::recursive_mutex outletMutex;

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

}  // namespace

/// Filters report from their own threads, so the texts are guarded.
class MessageCollector : public vtkOutputWindow {
public:
    static MessageCollector* New() { VTK_STANDARD_NEW_BODY(MessageCollector); }
    vtkTypeMacro(MessageCollector, vtkOutputWindow)

        void DisplayText(const char*) override
    {
    }
    void DisplayDebugText(const char*) override {}
    void DisplayErrorText(const char* text) override { keep(oneLine(text)); }
    void DisplayWarningText(const char* text) override { keepIfError(text); }
    void DisplayGenericWarningText(const char* text) override { keepIfError(text); }

    std::string firstError()
    {
        const std::lock_guard lock(textMutex_);
        return error_;
    }

private:
    void keep(const std::string& line)
    {
        const std::lock_guard lock(textMutex_);
        if (error_.empty()) error_ = line;
    }
    /// The legacy readers call it a warning that data ended too early.
    void keepIfError(const char* text)
    {
        const std::string line = oneLine(text);
        if (line.starts_with("Error")) keep(line);
    }
    std::mutex textMutex_;
    std::string error_;
};

VtkMessages::VtkMessages()
{
    outletMutex.lock();
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    previous_ = vtkOutputWindow::GetInstance();
    collector_ = vtkSmartPointer<MessageCollector>::New();
    vtkOutputWindow::SetInstance(collector_);
}

VtkMessages::~VtkMessages()
{
    vtkOutputWindow::SetInstance(previous_);
    outletMutex.unlock();
}

std::string VtkMessages::firstError() const
{
    return collector_->firstError();
}

}  // namespace aeolic
