// Any text as a feedback law: a complete schedule of finite gains in order, or a UsageError that names the file.
// Expected: the contract: a law or one line.
#include <cmath>

#include "cli/errors.hpp"
#include "cli/feedback_file.hpp"
#include "fuzz/target.hpp"

FUZZ_TARGET(feedback_file) {
  using namespace tiltrotor;
  static fuzz::InputFile input;
  static const cli::ReadingNames names{{"u", "q", "theta", "airspeed"}, {0, 4, 7, vehicle_state_count}, ""};
  fuzz::Bytes in(data, size);
  const std::string& path = input.holding(in.rest());
  try {
    const cli::FeedbackFile file(path, names);
    const FeedbackLaw<double>& law = file.law();
    REQUIRE(law.blocks > 0 && law.inputs > 0 && law.readings > 0 && law.readings <= 4);
    for (int b = 0; b < law.blocks; ++b) {
      const GainBlock<double>& block = law.block[b];
      for (int i = 0; i < law.inputs; ++i)
        for (int k = 0; k < law.readings; ++k) REQUIRE(std::isfinite(block.gain(i, k)));
      const bool rises =
          b == 0 || block.mast_deg > law.block[b - 1].mast_deg ||
          (block.mast_deg == law.block[b - 1].mast_deg && block.speed > law.block[b - 1].speed);
      REQUIRE(rises);
    }
    REQUIRE(std::isfinite(gain_shares(law, 45.0, 60.0).gain(law, 0, 0)));
  } catch (const cli::UsageError& error) {
    REQUIRE(std::string(error.what()).compare(0, path.size() + 1, path + ":") == 0);
  }
}
