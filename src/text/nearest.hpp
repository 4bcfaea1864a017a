// What somebody may have meant by a word that is none of the known ones.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tiltrotor::text {

// " (did you mean speed?)" when one of the choices is about as near as a slip of the hand, else nothing.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& choices);

// 'word' for a message: in quotation marks, and cut when it is very long.
std::string quoted(std::string_view word);

}  // namespace tiltrotor::text
