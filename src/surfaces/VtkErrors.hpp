/// Errors of a VTK object, collected instead of printed.
#pragma once
#include "base/CaseError.hpp"
#include <fmt/format.h>
#include <string>
#include <vtkCommand.h>
#include <vtkObject.h>
#include <vtkSmartPointer.h>

namespace sph
{

class VtkErrors
{
    struct Listener : vtkCommand
    {
        std::string text;
        static Listener* New() { return new Listener; }
        void Execute(vtkObject*, unsigned long, void* message) override { text += static_cast<const char*>(message); }
    };
    vtkSmartPointer<vtkObject> source_;
    vtkSmartPointer<Listener> listener_ = vtkSmartPointer<Listener>::New();
    unsigned long tags_[2];

public:
    explicit VtkErrors(vtkObject* source)
        : source_(source),
          tags_{source->AddObserver(vtkCommand::ErrorEvent, listener_), source->AddObserver(vtkCommand::WarningEvent, listener_)}
    {}
    ~VtkErrors()
    {
        for (const auto tag : tags_) source_->RemoveObserver(tag);
    }
    VtkErrors(const VtkErrors&) = delete;
    VtkErrors& operator=(const VtkErrors&) = delete;

    /// Throws CaseError("<what>: <all that was said>").
    void throwIfAny(const std::string& what) const
    {
        if (!listener_->text.empty()) throw CaseError(fmt::format("{}: {}", what, listener_->text));
    }
};

}
