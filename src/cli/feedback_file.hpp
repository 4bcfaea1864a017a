// A feedback law from a CSV file: one row for every input, one column for every reading.
//
//   mast_deg,speed_mps,input,u,w,q,theta
//   90,80,long_stick,-0.02,0.05,-3.1,-6.4
//   90,100,long_stick,-0.01,0.04,-2.2,-6.1
//
// mast_deg and speed_mps, both or one or none: where the gains hold; between, they are linear (gain_shares()). Empty lines
// and those that begin with # do not count.
#pragma once

#include <string>
#include <vector>

#include "tiltrotor/analysis/linear/feedback.hpp"

namespace tiltrotor::cli {

// What a law may read in a model: its states, and of instruments those it has.
struct ReadingNames {
  std::vector<std::string> name;
  std::vector<int> reading;
  std::string remark;  // why there are no instruments, where there are none: "outputs go with ..."
};

class FeedbackFile {
 public:
  // Throws UsageError "FILE:LINE: ..." for anything that is not a complete schedule.
  FeedbackFile(const std::string& path, const ReadingNames& names);
  FeedbackFile(const FeedbackFile&) = delete;
  FeedbackFile& operator=(const FeedbackFile&) = delete;

  const FeedbackLaw<double>& law() const { return law_; }

 private:
  struct Row {
    std::size_t line;
    double mast_deg, speed;
    int input;  // row of the law
    std::vector<double> gain;
  };
  void read_header(const std::vector<std::string>& cells, const ReadingNames& names,
                   const std::string& where);
  Row read_row(const std::vector<std::string>& cells, std::size_t line, const std::string& where);
  void make_blocks(std::vector<Row> rows, const std::string& path);

  std::vector<std::string> header_;
  int input_ = -1, mast_ = -1, speed_ = -1;  // columns
  std::vector<GainBlock<double>> blocks_;
  FeedbackLaw<double> law_{};
};

}  // namespace tiltrotor::cli
