// index.html: one page with everything in it; no script, nothing fetched.
#pragma once

#include <string>
#include <vector>

#include "study/section.hpp"

namespace tiltrotor::study {

struct PageHead {
  std::string title;
  std::string lead;                // a paragraph
  std::vector<std::string> facts;  // "name: value" lines
};

std::string page(const PageHead& head, const std::vector<Section>& sections);

const char* verdict_word(Finding::Verdict verdict);

}  // namespace tiltrotor::study
