// Work areas of the analyses, on the heap.
#pragma once

#include <memory>
#include <new>

#include "library/analyses.hpp"

namespace tiltrotor::cli {

class AnalysesWorkspace {
 public:
  AnalysesWorkspace()
      : memory_(::operator new(analyses_size(), alignment())), analyses_(place_analyses(memory_.get())) {}

  Analyses& operator*() const { return *analyses_; }

 private:
  static std::align_val_t alignment() { return std::align_val_t(analyses_alignment()); }
  struct Release {
    void operator()(void* memory) const { ::operator delete(memory, alignment()); }
  };
  std::unique_ptr<void, Release> memory_;
  Analyses* analyses_;
};

}  // namespace tiltrotor::cli
