#include "cli/matrix_log.hpp"

#include "text/number.hpp"

namespace tiltrotor::cli {

MatrixLog::MatrixLog(const std::string& folder, const std::string& where) {
  require_writable_folder(folder, where);
  a_ = std::make_unique<Sink>(folder + "/a.csv", where);
  b_ = std::make_unique<Sink>(folder + "/b.csv", where);
}

void MatrixLog::add(double time, const LinearModel<double>& model) {
  if (!has_header_) write_header(model);
  std::string a, b;
  for (int i = 0; i < model.states; ++i) {
    const std::string begin = number_text(time, 12) + "," + model.state_name(i);
    a += begin;
    b += begin;
    for (int j = 0; j < model.states; ++j) a += "," + number_text(model.a(i, j));
    for (int j = 0; j < model.controls; ++j) b += "," + number_text(model.b(i, j));
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

void MatrixLog::write_header(const LinearModel<double>& model) {
  std::string a = "time_s,row";
  std::string b = a;
  for (int j = 0; j < model.states; ++j) a += std::string(",") + model.state_name(j);
  for (int j = 0; j < model.controls; ++j) b += std::string(",") + model.control_name(j);
  a_->write(a + "\n");
  b_->write(b + "\n");
  has_header_ = true;
}

}  // namespace tiltrotor::cli
