// The sources in the FMU. Importers know one folder for includes, sources/, and none of buildDescription.xml.
#include "tiltrotor/tiltrotor.h"

#ifndef TR_SINGLE_PRECISION
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

#include "check.hpp"
#include "plot/xml_check.hpp"
#include "run_program.hpp"

namespace fs = std::filesystem;

TEST(fmu_sources_find_every_include_from_one_folder) {
  const fs::path root = fs::path(TILTROTOR_BINARY_DIR) / "fmu/sources";
  const std::regex include("\\s*#\\s*include\\s*\"([^\"]+)\".*");
  int count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    if (!entry.is_regular_file() || entry.path().extension() == ".xml") continue;
    std::ifstream in(entry.path());
    std::smatch part;
    for (std::string line; std::getline(in, line);) {
      if (!std::regex_match(line, part, include)) continue;
      ++count;
      if (!CHECK(fs::exists(root / part[1].str()))) NOTE(entry.path().string() << " includes " << part[1]);
    }
  }
  CHECK_LE(100, count);
}

TEST(fmu_sources_that_are_to_be_compiled_are_there) {
  const fs::path root = fs::path(TILTROTOR_BINARY_DIR) / "fmu/sources";
  std::ifstream in(root / "buildDescription.xml");
  const std::regex file("\\s*<SourceFile name=\"([^\"]+)\"/>");
  int count = 0;
  std::smatch part;
  for (std::string line; std::getline(in, line);) {
    if (!std::regex_match(line, part, file)) continue;
    ++count;
    if (!CHECK(fs::exists(root / part[1].str()))) NOTE(part[1]);
  }
  CHECK_LE(20, count);
}

// The standard wants a PNG beside the SVG. Its size stands behind signature, length and name of the first chunk.
TEST(fmu_icon_is_there_in_both_formats) {
  const auto content = [](const char* name) {
    std::ifstream in(check::source_path(std::string("src/fmu/") + name), std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  for (const char* const name : {"icon.svg", "terminalsAndIcons.xml"}) {
    CHECK(!content(name).empty());
    CHECK_EQ(check::XmlChecker::fault(content(name)), "");
  }
  const std::string png = content("icon.png"), side("\0\0\0\x80", 4);
  CHECK_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  CHECK_EQ(png.substr(16, 8), side + side);
  CHECK(content("icon.svg").find("width=\"128\" height=\"128\"") != std::string::npos);
}

// The same parts under two masks, by zip and by what stands in where it is missing: the same bytes.
TEST(fmu_archive_has_the_same_bytes_whatever_the_umask) {
  const std::string folder = check::new_temporary_folder(), fmu = std::string(TILTROTOR_BINARY_DIR) + "/fmu";
  int packed = 0;
  for (const std::string& zip : {std::string("zip"), std::string("none")}) {
    std::string first;
    for (const std::string& mask : {std::string("022"), std::string("077")}) {
      const std::string to = folder + "/" + mask + ".fmu", parts = folder + "/" + mask;
      const auto done =
          check::run_program("cd " + check::quoted(check::source_path("")) + " && umask " + mask +
                             " && cp -R " + check::quoted(fmu) + " " + parts + " && ZIPPER=" + zip +
                             " sh src/fmu/pack.sh " + parts + " " + to + " && ls -R " + parts + "/packed");
      if (!CHECK_EQ(done.exit_status, 0)) NOTE(done.err);
      CHECK(done.out.find("index.html") != std::string::npos);
      if (done.out.find("not installed") != std::string::npos) continue;
      std::ifstream in(to, std::ios::binary);
      const std::string bytes(std::istreambuf_iterator<char>(in), {});
      CHECK_LE(100000u, bytes.size());
      if (!first.empty()) CHECK(bytes == first);
      first = bytes;
      ++packed;
      fs::remove_all(parts);
      fs::remove(to);
    }
  }
  NOTE(packed << " archives");
  fs::remove_all(folder);
}

#endif
