// The plain driver of the fuzz targets: corpus first, then random mutations of it.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

#include "fuzz/target.hpp"

namespace fuzz {

namespace {

using Input = std::vector<std::uint8_t>;
constexpr unsigned kSeed = 20260605;
constexpr int kMutations = 400;  // of the quick run
constexpr std::size_t kLongest = 4096;

std::vector<Input> corpus(const std::string& name) {
  const std::filesystem::path folder =
      std::filesystem::path(TILTROTOR_SOURCE_DIR "/tests/fuzz/corpus") / name;
  std::vector<std::filesystem::path> paths;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<Input> inputs;
  for (const auto& path : paths) {
    std::ifstream in(path, std::ios::binary);
    inputs.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return inputs;
}

class Mutator {
 public:
  explicit Mutator(const std::vector<Input>& parents) : parents_(parents) {}

  Input next() {
    Input input = parents_[below(parents_.size())];
    for (std::size_t changes = 1 + below(6); changes > 0; --changes) change(input);
    if (input.size() > kLongest) input.resize(kLongest);
    return input;
  }

 private:
  std::size_t below(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(engine_);
  }
  std::uint8_t any() { return static_cast<std::uint8_t>(below(256)); }
  static Input::iterator at(Input& input, std::size_t place) {
    return input.begin() + static_cast<std::ptrdiff_t>(place);
  }

  void change(Input& input) {
    const std::size_t place = below(input.size() + 1);
    const std::size_t length = std::min(input.size() - place, 1 + below(16));
    switch (input.empty() ? 2 : below(6)) {
      case 0:
        input[place % input.size()] = any();
        break;
      case 1:
        input[place % input.size()] ^= static_cast<std::uint8_t>(1u << below(8));
        break;
      case 2:
        input.insert(at(input, place), any());
        break;
      case 3:
        input.erase(at(input, place), at(input, place + length));
        break;
      case 4: {  // say it twice
        const Input part(at(input, place), at(input, place + length));
        input.insert(at(input, below(input.size() + 1)), part.begin(), part.end());
        break;
      }
      default: {  // the beginning of one, the end of another
        const Input& other = parents_[below(parents_.size())];
        input.resize(place);
        const std::size_t from = below(other.size() + 1);
        input.insert(input.end(), other.begin() + static_cast<std::ptrdiff_t>(from), other.end());
      }
    }
  }

  const std::vector<Input>& parents_;
  std::mt19937 engine_{kSeed};
};

}  // namespace

void replay_and_mutate(const std::string& name, Target target) {
  const std::vector<Input> inputs = corpus(name);
  if (!CHECK(!inputs.empty())) return;
  for (const Input& input : inputs) target(input.data(), input.size());

  const char* const wanted = std::getenv("FUZZ_SECONDS");
  const std::chrono::duration<double> duration(wanted != nullptr ? std::atof(wanted) : 0);
  const auto start = std::chrono::steady_clock::now();
  Mutator mutator(inputs);
  long runs = 0;
  while (runs < kMutations || std::chrono::steady_clock::now() - start < duration) {
    const Input input = mutator.next();
    target(input.data(), input.size());
    ++runs;
  }
  NOTE(name << ": " << inputs.size() << " inputs of the corpus, " << runs << " mutations, seed " << kSeed);
}

}  // namespace fuzz
