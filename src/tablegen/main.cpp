// tablegen FOLDER OUTPUT [single]: turns the CSV files of one aircraft into a C++ file with constant arrays, on request
// with the slopes of the airframe's large tables in single precision.
//
// Exit code 0, or 2 with one line `file:line: message` on stderr; then there is no OUTPUT.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>

#include "tablegen/aircraft_fields.hpp"
#include "tablegen/aircraft_tables.hpp"
#include "tablegen/emit.hpp"
#include "tablegen/entries.hpp"
#include "tablegen/fault.hpp"
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

void generate(const std::string& folder, const fs::path& output, tablegen::Slopes slopes) {
  if (!fs::is_directory(folder)) throw tablegen::Fault{folder, 1, "is not a folder of tables"};
  const fs::path base(folder);
  tablegen::Entries entries;
  entries.read_aircraft((base / "aircraft.csv").string());
  entries.read_choices((base / "choices.csv").string());
  tablegen::check_fields(entries);
  const std::vector<tablegen::TableArray> tables = tablegen::compose_tables(folder, entries);
  std::ostringstream text;
  const std::string name = fs::absolute(base).lexically_normal().filename().string();
  tablegen::emit(text, tablegen::read_identity((base / "identity.csv").string(), name), entries, tables,
                 slopes);
  write(output, text.str());
}

}  // namespace

int main(int count, char** argument) {
  const bool single = count == 4 && std::string(argument[3]) == "single";
  if (count != 3 && !single) {
    std::fputs("usage: tablegen FOLDER_OF_TABLES OUTPUT [single]\n", stderr);
    return 2;
  }
  const fs::path output = argument[2];
  std::string message;
  try {
    generate(argument[1], output, single ? tablegen::Slopes::single : tablegen::Slopes::as_values);
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
