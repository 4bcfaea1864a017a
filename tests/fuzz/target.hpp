// One fuzz target a file, in two uses.
//
//   FUZZ_TARGET(name) { fuzz::Bytes in(data, size); ... REQUIRE(condition); }
//
// In the test runner it becomes a test that replays the folder corpus/<name> and some thousand random
// mutations of it (printed seed; the environment variable FUZZ_SECONDS makes it go on for that long).
// Compiled with -DTILTROTOR_FUZZER it becomes the entry point of clang's libFuzzer: see `make fuzz`.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>

#include "temporary.hpp"

namespace fuzz {

/// The input as a sequence of whatever is asked for; zeros behind its end.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

  bool empty() const { return left_ == 0; }
  std::uint8_t byte() {
    if (left_ == 0) return 0;
    --left_;
    return *data_++;
  }
  int below(int count) { return byte() % count; }
  template <class Number>
  Number raw() {
    static_assert(sizeof(Number) <= sizeof(std::uint64_t));
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < sizeof(Number); ++k) bits |= std::uint64_t{byte()} << (8 * k);
    Number x{};
    std::memcpy(&x, &bits, sizeof x);
    return x;
  }
  /// Any bits, a special value, or a small plain number.
  double number() {
    static const double special[] = {0.0,
                                     -0.0,
                                     1.0,
                                     -1.0,
                                     0.5,
                                     1e-320,
                                     -1e-320,
                                     1e-300,
                                     1e300,
                                     -1e300,
                                     1.7976931348623157e308,
                                     90,
                                     44330.769,
                                     300,
                                     2,
                                     1.5707963267948966,
                                     std::numeric_limits<double>::quiet_NaN(),
                                     std::numeric_limits<double>::infinity(),
                                     -std::numeric_limits<double>::infinity()};
    const int kind = byte();
    if (kind < 40) return special[static_cast<std::size_t>(kind) % (sizeof special / sizeof *special)];
    if (kind < 80) return raw<double>();
    const double small = raw<std::int16_t>() / 32768.0;
    return kind < 160 ? small : kind < 220 ? 20 * small : 400 * small;
  }
  std::string rest() {
    std::string text(reinterpret_cast<const char*>(data_), left_);
    left_ = 0;
    return text;
  }

 private:
  const std::uint8_t* data_;
  std::size_t left_;
};

/// A temporary file whose text is replaced for every input, for readers that take a path.
class InputFile {
 public:
  InputFile() : path_(check::new_temporary_file()), file_(std::fopen(path_.c_str(), "wb")) {}
  ~InputFile() {
    if (file_ != nullptr) std::fclose(file_);
    std::remove(path_.c_str());
  }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::string& holding(const std::string& text) {
    std::FILE* const file = std::freopen(path_.c_str(), "wb", file_);
    if (file == nullptr) std::abort();
    file_ = file;
    std::fwrite(text.data(), 1, text.size(), file_);
    std::fflush(file_);
    return path_;
  }

 private:
  std::string path_;
  std::FILE* file_;
};

using Target = void (*)(const std::uint8_t* data, std::size_t size);

}  // namespace fuzz

#ifdef TILTROTOR_FUZZER

#define REQUIRE(...)                                                         \
  do {                                                                       \
    if (!(__VA_ARGS__)) {                                                    \
      std::fprintf(stderr, "%s:%d: " #__VA_ARGS__ "\n", __FILE__, __LINE__); \
      std::abort();                                                          \
    }                                                                        \
  } while (false)

#define FUZZ_TARGET(name)                                                             \
  static void target_##name(const std::uint8_t* data, std::size_t size);              \
  extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) { \
    target_##name(data, size);                                                        \
    return 0;                                                                         \
  }                                                                                   \
  static void target_##name(const std::uint8_t* data, std::size_t size)

#else

#include "check.hpp"

namespace fuzz {
void replay_and_mutate(const std::string& name, Target target);
}

#define REQUIRE(...) CHECK(__VA_ARGS__)

#define FUZZ_TARGET(name)                                                \
  static void target_##name(const std::uint8_t* data, std::size_t size); \
  TEST(fuzz_##name) { fuzz::replay_and_mutate(#name, target_##name); }   \
  static void target_##name(const std::uint8_t* data, std::size_t size)

#endif
