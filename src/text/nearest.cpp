#include "text/nearest.hpp"

#include <algorithm>

namespace tiltrotor::text {

namespace {

// Capitals and the choice between dash and underscore are no difference; nor are leading dashes.
std::string plain(const std::string& word) {
  std::string text = word.substr(std::min(word.find_first_not_of('-'), word.size()));
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (c == '-') c = '_';
  }
  return text;
}

// Letters to insert, remove, replace or swap with their neighbour until `a` is `b`.
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t other = a[i - 1] == b[j - 1] ? 0 : 1;
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + other});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(last);
    last.swap(row);
  }
  return last[b.size()];
}

}  // namespace

std::string did_you_mean(const std::string& word, const std::vector<std::string>& choices) {
  constexpr std::size_t longest = 64;  // no name is as long
  const std::string meant = plain(word);
  const bool has_letter =
      std::any_of(meant.begin(), meant.end(), [](char c) { return c >= 'a' && c <= 'z'; });
  if (!has_letter || meant.size() > longest) return "";
  const std::string* nearest = nullptr;
  std::size_t least = std::max<std::size_t>(1, meant.size() / 3) + 1;
  for (const std::string& choice : choices) {
    const std::string name = plain(choice);
    const std::size_t steps = distance(meant, name);
    if (steps < std::min(least, name.size())) {  // not every letter another
      nearest = &choice;
      least = steps;
    }
  }
  return nearest == nullptr ? "" : " (did you mean " + *nearest + "?)";
}

std::string quoted(std::string_view word) {
  constexpr std::size_t most = 80;
  return "'" + std::string(word.substr(0, most)) + (word.size() > most ? "...'" : "'");
}

}  // namespace tiltrotor::text
