// Is a text well-formed XML? Enough of the grammar for what this project writes: elements, attributes, text,
// character references, comments, a document type.
#pragma once

#include <cctype>
#include <cstring>
#include <string>
#include <vector>

namespace check {

class XmlChecker {
 public:
  /// Empty when well-formed; else what is wrong and at which byte.
  static std::string fault(const std::string& text) { return XmlChecker(text).run(); }

 private:
  explicit XmlChecker(const std::string& text) : text_(text) {}

  std::string run() {
    bool had_root = false;
    while (fault_.empty() && at_ < text_.size()) {
      if (text_[at_] != '<') {
        const bool blank = std::isspace(static_cast<unsigned char>(text_[at_])) != 0;
        if (open_.empty() && !blank) return wrong("text outside the root element");
        if (text_[at_] == '&') {
          reference();
        } else {
          ++at_;
        }
      } else if (starts("<!--")) {
        skip_past("-->");
      } else if (starts("<!DOCTYPE") || starts("<?")) {
        if (had_root) return wrong("declaration inside the document");
        skip_past(">");
      } else if (starts("</")) {
        at_ += 2;
        const std::string name = take_name();
        skip_space();
        if (!starts(">")) return wrong("closing tag not closed");
        ++at_;
        if (open_.empty() || open_.back() != name) return wrong("</" + name + "> closes nothing");
        open_.pop_back();
      } else {
        if (open_.empty() && had_root) return wrong("second root element");
        had_root = true;
        tag();
      }
    }
    if (!fault_.empty()) return fault_;
    if (!open_.empty()) return wrong("<" + open_.back() + "> is never closed");
    return had_root ? "" : wrong("no element");
  }

  void tag() {
    ++at_;
    const std::string name = take_name();
    if (name.empty()) return set("tag without name");
    std::vector<std::string> seen;
    for (;;) {
      const std::size_t before = at_;
      skip_space();
      if (starts("/>")) {
        at_ += 2;
        return;
      }
      if (starts(">")) {
        ++at_;
        open_.push_back(name);
        return;
      }
      if (at_ == before) return set("no space before an attribute of <" + name + ">");
      const std::string attribute = take_name();
      if (attribute.empty()) return set("bad attribute of <" + name + ">");
      for (const std::string& s : seen) {
        if (s == attribute) return set("attribute " + attribute + " twice");
      }
      seen.push_back(attribute);
      if (!starts("=\"")) return set("attribute " + attribute + " without quoted value");
      at_ += 2;
      while (at_ < text_.size() && text_[at_] != '"') {
        if (text_[at_] == '<') return set("< in an attribute");
        if (text_[at_] == '&') {
          reference();
          if (!fault_.empty()) return;
        } else {
          ++at_;
        }
      }
      if (at_ == text_.size()) return set("attribute never ends");
      ++at_;
    }
  }

  void reference() {
    const std::size_t end = text_.find(';', at_);
    const std::string name = end == std::string::npos ? "" : text_.substr(at_ + 1, end - at_ - 1);
    static const char* const known[] = {"amp", "lt", "gt", "quot", "apos"};
    bool good =
        name.size() > 1 && name[0] == '#' && name.find_first_not_of("0123456789", 1) == std::string::npos;
    for (const char* k : known) good = good || name == k;
    if (!good) return set("bare & or unknown reference");
    at_ = end + 1;
  }

  bool starts(const char* what) const { return text_.compare(at_, std::strlen(what), what) == 0; }
  void skip_past(const char* what) {
    const std::size_t end = text_.find(what, at_);
    if (end == std::string::npos) return set("comment or declaration never ends");
    at_ = end + std::strlen(what);
  }
  void skip_space() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
  }
  std::string take_name() {
    const std::size_t first = at_;
    while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '-' ||
                                  text_[at_] == '_' || text_[at_] == ':')) {
      ++at_;
    }
    return text_.substr(first, at_ - first);
  }
  void set(const std::string& what) { fault_ = what + " at byte " + std::to_string(at_); }
  std::string wrong(const std::string& what) {
    set(what);
    return fault_;
  }

  const std::string& text_;
  std::size_t at_ = 0;
  std::vector<std::string> open_;
  std::string fault_;
};

}  // namespace check
