#include "cli/matrix_log.hpp"

#include <algorithm>

#include "text/number.hpp"

namespace tiltrotor::cli {

namespace {

// Of each name among others; -1 where it is not there.
std::vector<int> places(const std::vector<std::string>& names, const std::vector<std::string>& among) {
  std::vector<int> found;
  for (const std::string& name : names) {
    const auto at = std::find(among.begin(), among.end(), name);
    found.push_back(at == among.end() ? -1 : static_cast<int>(at - among.begin()));
  }
  return found;
}

}  // namespace

MatrixLog::MatrixLog(const std::string& folder, const std::string& where, const std::string& beginning) {
  require_writable_folder(folder, where);
  a_ = std::make_unique<Sink>(folder + "/a.csv", where);
  b_ = std::make_unique<Sink>(folder + "/b.csv", where);
  a_->write(beginning);
  b_->write(beginning);
}

void MatrixLog::set_columns(const std::vector<std::string>& states,
                            const std::vector<std::string>& controls) {
  states_ = states;
  controls_ = controls;
  std::string a = "time_s,row";
  std::string b = a;
  for (const std::string& name : states_) a += "," + name;
  for (const std::string& name : controls_) b += "," + name;
  a_->write(a + "\n");
  b_->write(b + "\n");
  has_header_ = true;
}

void MatrixLog::add(double time, const ShownModel& model) {
  std::vector<std::string> states, controls;
  for (int i = 0; i < model.states; ++i) states.emplace_back(model.state_name(i));
  for (int j = 0; j < model.controls; ++j) controls.emplace_back(model.control_name(j));
  if (!has_header_) set_columns(states, controls);
  const std::vector<int> state_place = places(states_, states), control_place = places(controls_, controls);
  std::string a, b;
  for (int i = 0; i < model.states; ++i) {
    const std::string begin = number_text(time, 12) + "," + model.state_name(i);
    a += begin;
    b += begin;
    for (const int j : state_place) a += j < 0 ? "," : "," + number_text(model.a(i, j));
    for (const int j : control_place) b += j < 0 ? "," : "," + number_text(model.b(i, j));
    a += "\n";
    b += "\n";
  }
  a_->write(a);
  b_->write(b);
}

void MatrixLog::finish() {
  a_->finish();
  b_->finish();
}

}  // namespace tiltrotor::cli
