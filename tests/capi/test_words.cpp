// The C interface: sizes, words and hashes.
// Expected: the header's text, the constants of FNV-1a as published.
#include <string>

#include "capi/flying.hpp"

using namespace capi;

TEST(capi_sizes) {
  CHECK_LE(tr_sim_size(), sizeof(tr_sim));
  CHECK_LE(tr_work_size(), sizeof(tr_work));
  NOTE("tr_sim uses " << tr_sim_size() << " of " << sizeof(tr_sim) << " bytes, tr_work " << tr_work_size()
                      << " of " << sizeof(tr_work));
}

TEST(capi_words) {
  for (int status = 0; status < TR_STATUS_COUNT; ++status) {
    CHECK(std::strlen(tr_status_word(status)) > 0);
    CHECK(std::strcmp(tr_status_word(status), "unknown") != 0);
    CHECK(std::strlen(tr_status_text(status)) > 0);
  }
  for (const int status : {-1, int{TR_STATUS_COUNT}, 1000000}) {
    CHECK_EQ(std::string(tr_status_word(status)), "unknown");
    CHECK_EQ(std::string(tr_status_text(status)), "");
  }
  CHECK_EQ(std::string(tr_state_name(TR_PITCH)), "theta");
  CHECK_EQ(std::string(tr_state_unit(TR_DOWN)), "m");
  CHECK_EQ(std::string(tr_control_name(TR_PEDAL)), "pedal");
  CHECK_EQ(std::string(tr_control_unit(TR_GUST_W)), "m/s");
  CHECK_EQ(std::string(tr_state_name(TR_ROTOR_SPEED)), "rotor_speed");
  CHECK_EQ(std::string(tr_state_unit(TR_POWER_LEFT)), "W");
  CHECK_EQ(std::string(tr_control_name(TR_CONTROLS)), "mast_command");
  CHECK_EQ(std::string(tr_control_unit(TR_INPUTS - 1)), "-");
  for (const int index : {-1, int{TR_STATES}}) CHECK_EQ(std::string(tr_state_name(index)), "unknown");
  for (const int index : {-1, int{TR_INPUTS}}) CHECK_EQ(std::string(tr_control_unit(index)), "");
  CHECK(std::strlen(tr_version()) >= 5);
}

TEST(capi_hash) {
  // FNV-1a of the bytes of 1.0 (double 00..f03f, float 0000803f), computed by hand with the published
  // constants.
  std::uint64_t expected = TR_HASH_START;
  const unsigned char tail[] = {0xf0, 0x3f};
  const unsigned char tail_single[] = {0x80, 0x3f};
  for (std::size_t k = 0; k + 2 < sizeof(tr_real); ++k) expected *= 1099511628211u;
  for (const unsigned char byte : sizeof(tr_real) == 8 ? tail : tail_single)
    expected = (expected ^ byte) * 1099511628211u;
  std::uint64_t hash = TR_HASH_START;
  const tr_real one = 1;
  CHECK_EQ(tr_hash(&one, 1, &hash), TR_OK);
  CHECK_EQ(hash, expected);
  CHECK_EQ(tr_hash(nullptr, 0, &hash), TR_OK);
  CHECK_EQ(hash, expected);
}
