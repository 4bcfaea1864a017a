// How far a long run has come, with the time left: one line on stderr, only when that is a terminal.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace tiltrotor::text {

class Progress {
 public:
  Progress(std::string what, std::size_t total);
  ~Progress();  // removes the line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void advance();
  // A line on stderr that does not collide with the display.
  void message(const std::string& text);

 private:
  void clear();

  using Clock = std::chrono::steady_clock;
  std::string what_;
  std::size_t total_;
  std::size_t done_ = 0;
  bool visible_;
  bool drawn_ = false;
  Clock::time_point start_;
  Clock::time_point last_drawn_;
};

}  // namespace tiltrotor::text
