// A section of the report: figures, the tables they were drawn from, and what they say.
#pragma once

#include <string>
#include <vector>

#include "text/table.hpp"

namespace tiltrotor::study {

using text::Table;

struct Picture {
  std::string name;  // of the file, without .svg; unique
  std::string svg;
};

struct NumberedTable {
  std::string name;  // of the file, without .csv; unique
  std::string what;  // one line
  Table table;
  bool whole = false;  // shown on the page whatever its length, and unfolded
};

// Something published or expected, and what this run found.
struct Finding {
  enum class Verdict : unsigned char { holds, partly, differs, remark };
  static constexpr Verdict holds = Verdict::holds;
  static constexpr Verdict partly = Verdict::partly;
  static constexpr Verdict differs = Verdict::differs;
  static constexpr Verdict remark = Verdict::remark;

  Verdict verdict;
  std::string statement;
  std::string found;  // numbers of this run, with the cause where it differs
};

// By how many of several things hold.
constexpr Finding::Verdict verdict_of(int held, int of) {
  return held == of ? Finding::holds : held > 0 ? Finding::partly : Finding::differs;
}

struct Section {
  std::string id;  // anchor
  std::string title;
  std::string reading;  // one or two sentences: what to see
  std::vector<Picture> pictures;
  std::vector<NumberedTable> tables;
  std::vector<Finding> findings;
};

}  // namespace tiltrotor::study
