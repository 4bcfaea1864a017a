#include "text/progress.hpp"

#include <unistd.h>

#include <cstdio>
#include <utility>

namespace tiltrotor::text {

namespace {

constexpr std::chrono::milliseconds redraw_interval{200};
constexpr const char* clear_line = "\r\033[K";

}  // namespace

Progress::Progress(std::string what, std::size_t total)
    : what_(std::move(what)),
      total_(total),
      visible_(isatty(STDERR_FILENO) != 0),
      start_(Clock::now()),
      last_drawn_(start_) {}

Progress::~Progress() { clear(); }

void Progress::clear() {
  if (drawn_) std::fputs(clear_line, stderr);
  drawn_ = false;
}

void Progress::message(const std::string& text) {
  clear();
  std::fprintf(stderr, "tiltrotor: %s\n", text.c_str());
}

void Progress::advance() {
  ++done_;
  const Clock::time_point now = Clock::now();
  if (!visible_ || now - last_drawn_ < redraw_interval) return;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double left = elapsed * static_cast<double>(total_ - done_) / static_cast<double>(done_);
  std::fprintf(stderr, "%s%s: %zu of %zu, %.0f s left", clear_line, what_.c_str(), done_, total_, left);
  std::fflush(stderr);
  last_drawn_ = now;
  drawn_ = true;
}

}  // namespace tiltrotor::text
