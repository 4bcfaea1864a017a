// What nearly every source of the program and of the tests includes, compiled once and put before each of them: a third of
// their time. Each source still names what it needs.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "library/analyses.hpp"
