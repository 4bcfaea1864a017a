// JSON text.
#pragma once

#include <string>
#include <vector>

namespace tiltrotor::text {

// What is not UTF-8 becomes the replacement character.
std::string json_text(const std::string& text);
// Shortest digits that read back exactly; null for what JSON cannot write.
std::string json_number(double value);
std::string json_array(const std::vector<double>& values);
// Members are written as given: {"name", json_number(1)}.
using JsonMember = std::pair<std::string, std::string>;
std::string json_object(const std::vector<JsonMember>& members);

}  // namespace tiltrotor::text
