// A figure beside the rows of a command: --figure FILE.
#pragma once

#include <memory>
#include <vector>

#include "cli/arguments.hpp"
#include "plot/stack.hpp"
#include "text/sink.hpp"

namespace tiltrotor::cli {

// Its file is claimed at once, so that a place that cannot be written is refused before anything is computed.
class Figure {
 public:
  explicit Figure(const Arguments& arguments) {
    if (arguments.given("--figure"))
      sink_ = std::make_unique<text::Sink>(arguments.text("--figure", ""), arguments.where("--figure"));
  }
  bool wanted() const { return sink_ != nullptr; }
  void draw(const std::string& title, const std::vector<plot::Plot>& plots) {
    if (!wanted()) return;
    sink_->write(plot::stacked_svg(title, plots));
    sink_->finish();
  }

 private:
  std::unique_ptr<text::Sink> sink_;
};

inline OptionList figure_option(const char* help) { return {{"--figure", "FILE", help}}; }

}  // namespace tiltrotor::cli
