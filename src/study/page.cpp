#include "study/page.hpp"

#include "plot/svg.hpp"

namespace tiltrotor::study {

using namespace plot;

namespace {

constexpr const char* kStyle = R"css(
:root { color-scheme: light; }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 16px; max-width: 1180px; color: #222; background: #fff;
  font: 16px/1.5 system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif; }
h1 { font-size: 1.6rem; line-height: 1.2; margin: .3em 0; }
h2 { font-size: 1.25rem; margin: 2.2em 0 .3em; padding-top: .6em; border-top: 1px solid #ddd; }
p { max-width: 75ch; margin: .5em 0; }
nav { display: flex; flex-wrap: wrap; gap: .3em .9em; margin: 1em 0; }
a { color: #00588a; }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 400px), 1fr)); gap: 12px; }
.pictures > svg { display: block; width: 100%; max-width: 560px; height: auto; }
.findings { list-style: none; padding: 0; }
.findings li { margin: .5em 0; padding-left: .8em; border-left: 4px solid #777; max-width: 80ch; }
.findings .holds { border-color: #009e73; }
.findings .partly { border-color: #e69f00; }
.findings .differs { border-color: #d55e00; }
.verdict { font-weight: 600; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: .85rem; font-variant-numeric: tabular-nums; }
th, td { padding: .2em .6em; text-align: right; border-bottom: 1px solid #e4e4e4; white-space: nowrap; }
th { font-weight: 600; vertical-align: bottom; }
td.text, th.text { text-align: left; }
td.long { text-align: left; white-space: normal; min-width: 40em; }
summary { cursor: pointer; }
.files { font-size: .9rem; }
@page { size: A4; margin: 14mm 12mm; }
@page wide { size: A4 landscape; margin: 12mm; }
@media print {
  nav, summary { display: none; }
  body { max-width: none; padding: 0; font-size: 10.5pt; }
  p, .findings li { max-width: none; }
  h2 { break-after: avoid; }
  .pictures { grid-template-columns: 1fr 1fr; }
  .pictures svg, .findings li, tr { break-inside: avoid; }
  .scroll { overflow: visible; }
  .wide { page: wide; }
  table { width: 100%; font-size: 6.5pt; line-height: 1.25; }
  th, td { white-space: normal; padding: .15em .3em; }
  td.number { white-space: nowrap; }
  td.long { min-width: 14em; }
}
)css";

constexpr std::size_t kMostRowsShown = 80;
constexpr std::size_t kMostColumnsUpright = 13;  // on paper
constexpr std::size_t kLongText = 40;            // characters: longer cells may break into lines

bool is_number(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789.-+e") == std::string::npos;
}

// The percent encoding of a data address.
std::string percent_encoded(const std::string& text) {
  constexpr const char* digits = "0123456789ABCDEF";
  std::string out;
  out.reserve(text.size() * 5 / 4);
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = (byte >= '0' && byte <= '9') || (byte >= 'A' && byte <= 'Z') ||
                       (byte >= 'a' && byte <= 'z') || c == '-' || c == '_' || c == '.' || c == ',';
    if (plain) {
      out += c;
    } else {
      out += '%';
      out += digits[byte >> 4];
      out += digits[byte & 15];
    }
  }
  return out;
}

// Names are long and without spaces: a narrow screen or column may break them at each underscore.
std::string breakable(const std::string& column) {
  std::string out;
  for (const char c : escaped(column)) {
    out += c;
    if (c == '_') out += "<wbr/>";
  }
  return out;
}

bool has_words(const Table& table, std::size_t column) {
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const std::string& cell = table.text(i, column);
    if (!cell.empty()) return !is_number(cell);
  }
  return false;
}

std::string html_table(const Table& table) {
  std::string out = "<div class=\"scroll\"><table><thead><tr>";
  for (std::size_t j = 0; j < table.columns().size(); ++j)
    out += std::string(has_words(table, j) ? "<th class=\"text\">" : "<th>") + breakable(table.columns()[j]) +
           "</th>";
  out += "</tr></thead><tbody>\n";
  for (std::size_t i = 0; i < table.rows(); ++i) {
    out += "<tr>";
    for (std::size_t j = 0; j < table.columns().size(); ++j) {
      const std::string& cell = table.text(i, j);
      out += (cell.empty() || is_number(cell) ? "<td class=\"number\">"
              : cell.size() > kLongText       ? "<td class=\"long\">"
                                              : "<td class=\"text\">") +
             breakable(cell) + "</td>";
    }
    out += "</tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

std::string html_tables(const std::vector<NumberedTable>& tables) {
  std::string out;
  for (const NumberedTable& t : tables) {
    const std::string link = "<a download=\"" + t.name + ".csv\" href=\"data:text/csv;charset=utf-8," +
                             percent_encoded(t.table.csv()) + "\">" + t.name + ".csv</a>";
    const std::string what = escaped(t.what) + " (" + std::to_string(t.table.rows()) + " rows)";
    const bool shown = t.whole || t.table.rows() <= kMostRowsShown;
    const bool wide = t.whole && t.table.columns().size() > kMostColumnsUpright;
    out += std::string("<div class=\"files") + (wide ? " wide" : "") + "\">" + link + ": " + what;
    if (shown) {
      out += std::string(t.whole ? "<details open=\"open\">" : "<details>") + "<summary>show</summary>\n" +
             html_table(t.table) + "</details>";
    }
    out += "</div>\n";
  }
  return out;
}

std::string html_findings(const std::vector<Finding>& findings) {
  if (findings.empty()) return "";
  std::string out = "<ul class=\"findings\">\n";
  for (const Finding& f : findings) {
    const std::string word = verdict_word(f.verdict);
    out += "<li class=\"" + word + "\"><span class=\"verdict\">" + word + ".</span> " + escaped(f.statement) +
           " " + escaped(f.found) + "</li>\n";
  }
  return out + "</ul>\n";
}

}  // namespace

const char* verdict_word(Finding::Verdict verdict) {
  switch (verdict) {
    case Finding::holds:
      return "holds";
    case Finding::partly:
      return "partly";
    case Finding::differs:
      return "differs";
    default:
      return "remark";
  }
}

std::string page(const PageHead& head, const std::vector<Section>& sections) {
  std::string out =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>" +
      escaped(head.title) + "</title>\n<style>" + kStyle + "</style>\n</head>\n<body>\n<h1>" +
      escaped(head.title) + "</h1>\n<p>" + escaped(head.lead) + "</p>\n<ul>\n";
  for (const std::string& fact : head.facts) out += "<li>" + escaped(fact) + "</li>\n";
  out += "</ul>\n<nav>\n";
  for (const Section& s : sections) out += "<a href=\"#" + s.id + "\">" + escaped(s.title) + "</a>\n";
  out += "</nav>\n<main>\n";
  for (const Section& s : sections) {
    out += "<section id=\"" + s.id + "\">\n<h2>" + escaped(s.title) + "</h2>\n<p>" + escaped(s.reading) +
           "</p>\n" + html_findings(s.findings) + "<div class=\"pictures\">\n";
    for (const Picture& p : s.pictures) out += p.svg;
    out += "</div>\n" + html_tables(s.tables) + "</section>\n";
  }
  return out + "</main>\n</body>\n</html>\n";
}

}  // namespace tiltrotor::study
