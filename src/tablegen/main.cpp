// tablegen FOLDER OUTPUT [single] [c2]: turns the CSV files of one aircraft into a C++ file with constant arrays, on
// request with the slopes of the airframe's large tables in single precision, and with the C2 fit instead of the C1
// interpolant; what the fit moved is printed then, a line a table.
//
// Exit code 0, or 2 with one line `file:line: message` on stderr; then there is no OUTPUT.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "tablegen/aircraft_fields.hpp"
#include "tablegen/aircraft_tables.hpp"
#include "tablegen/c2_fit.hpp"
#include "tablegen/emit.hpp"
#include "tablegen/entries.hpp"
#include "tablegen/fault.hpp"
#include "tablegen/flat_knots.hpp"
#include "tablegen/identity.hpp"

namespace fs = std::filesystem;

namespace {

// Complete or not at all: written beside its place and moved there.
void write(const fs::path& output, const std::string& text) {
  const fs::path part = output.string() + ".tmp";
  std::ofstream out(part, std::ios::binary);
  out << text;
  out.close();
  std::error_code error;
  if (out) {
    fs::rename(part, output, error);
    if (!error) return;
  }
  fs::remove(part, error);
  throw tablegen::Fault{output.string(), 1, "cannot be written"};
}

void fit(std::vector<tablegen::TableArray>& tables) {
  std::printf("table,nodes,deviation_half_units,roughness_ratio\n");
  for (tablegen::TableArray& table : tables) {
    if (!tablegen::is_fitted(table)) continue;
    const tablegen::TableArray graded = tablegen::with_flat_knots(table);
    tablegen::C2Fit fit = tablegen::c2_fit(graded);
    std::printf("%s,%zu,%.3g,%.3g\n", table.field.c_str(), table.value.size(), fit.deviation, fit.roughness);
    table.smooth = graded.smooth;
    table.fitted = std::move(fit.node);
  }
}

void generate(const std::string& folder, const fs::path& output, tablegen::Slopes slopes, bool c2) {
  if (!fs::is_directory(folder)) throw tablegen::Fault{folder, 1, "is not a folder of tables"};
  const fs::path base(folder);
  tablegen::Entries entries;
  entries.read_aircraft((base / "aircraft.csv").string());
  entries.read_choices((base / "choices.csv").string());
  tablegen::check_fields(entries);
  std::vector<tablegen::TableArray> tables = tablegen::compose_tables(folder, entries);
  if (c2) fit(tables);
  std::ostringstream text;
  const std::string name = fs::absolute(base).lexically_normal().filename().string();
  tablegen::emit(text, tablegen::read_identity((base / "identity.csv").string(), name), entries, tables,
                 slopes);
  write(output, text.str());
}

}  // namespace

int main(int count, char** argument) {
  const std::vector<std::string> words(argument + std::min(count, 3), argument + count);
  const auto asked = [&](const char* word) { return std::count(words.begin(), words.end(), word) == 1; };
  if (count < 3 || words.size() != std::size_t{asked("single")} + std::size_t{asked("c2")}) {
    std::fputs("usage: tablegen FOLDER_OF_TABLES OUTPUT [single] [c2]\n", stderr);
    return 2;
  }
  const fs::path output = argument[2];
  std::string message;
  try {
    generate(argument[1], output, asked("single") ? tablegen::Slopes::single : tablegen::Slopes::as_values,
             asked("c2"));
    return 0;
  } catch (const tablegen::Fault& fault) {
    message = fault.file + ":" + std::to_string(fault.line) + ": " + fault.message;
  } catch (const std::exception& error) {
    message = std::string(argument[1]) + ":1: " + error.what();
  }
  std::fprintf(stderr, "%s\n", message.c_str());
  std::error_code ignored;
  if (fs::is_regular_file(output, ignored)) fs::remove(output, ignored);  // nor that of an earlier run
  return 2;
}
