// identity.csv: number, name and description of the aircraft.
#pragma once

#include <string>

namespace tablegen {

struct Identity {
  std::string folder;  // name of the folder
  std::string name, description;
  int id;  // positive
};

Identity read_identity(const std::string& file, const std::string& folder);

}  // namespace tablegen
