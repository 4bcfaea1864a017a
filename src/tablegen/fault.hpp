// What is wrong with an input file, and where. Thrown by every check, reported once by main().
#pragma once

#include <string>

namespace tablegen {

struct Fault {
  std::string file;
  int line;  // from 1
  std::string message;
};

}  // namespace tablegen
