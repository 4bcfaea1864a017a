// Whether a text is JSON (RFC 8259), for tests.
#pragma once

#include <string>

namespace check {

class JsonGrammar {
 public:
  static bool accepts(const std::string& text) {
    JsonGrammar grammar(text);
    return grammar.value(0) && (grammar.skip_blanks(), grammar.at_ == text.size());
  }

 private:
  static constexpr int max_depth = 50;
  explicit JsonGrammar(const std::string& text) : text_(text) {}

  char now() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void skip_blanks() {
    while (now() == ' ' || now() == '\n' || now() == '\r' || now() == '\t') ++at_;
  }
  bool take(char c) {
    skip_blanks();
    if (now() != c) return false;
    ++at_;
    return true;
  }
  bool word(const std::string& w) {
    if (text_.compare(at_, w.size(), w) != 0) return false;
    at_ += w.size();
    return true;
  }
  bool digits() {
    const std::size_t start = at_;
    while (now() >= '0' && now() <= '9') ++at_;
    return at_ > start;
  }
  bool number() {
    if (now() == '-') ++at_;
    if (now() == '0') {
      ++at_;
    } else if (!digits()) {
      return false;
    }
    if (now() == '.' && (++at_, !digits())) return false;
    if (now() == 'e' || now() == 'E') {
      ++at_;
      if (now() == '+' || now() == '-') ++at_;
      return digits();
    }
    return true;
  }
  bool string() {
    if (!take('"')) return false;
    for (; now() != '"'; ++at_) {
      if (at_ >= text_.size() || static_cast<unsigned char>(now()) < 0x20) return false;
      if (now() == '\\') ++at_;
    }
    ++at_;
    return true;
  }
  bool list(char end, int depth, bool members) {
    ++at_;
    if (take(end)) return true;
    do {
      if (members && !(string() && take(':'))) return false;
      if (!value(depth + 1)) return false;
    } while (take(','));
    return take(end);
  }
  bool value(int depth) {
    skip_blanks();
    if (depth > max_depth) return false;
    if (now() == '{') return list('}', depth, true);
    if (now() == '[') return list(']', depth, false);
    if (now() == '"') return string();
    return word("true") || word("false") || word("null") || number();
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

}  // namespace check
