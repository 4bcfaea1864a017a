// index.html: one page with everything in it; no script, nothing fetched.
#pragma once

#include <string>
#include <vector>

#include "report/section.hpp"

namespace tiltrotor::report {

struct PageHead {
  std::string title;
  std::string lead;                // a paragraph
  std::vector<std::string> facts;  // "name: value" lines
};

std::string page(const PageHead& head, const std::vector<Section>& sections);

const char* verdict_word(Finding::Verdict verdict);

}  // namespace tiltrotor::report
