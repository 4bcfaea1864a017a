// The C interface: which aircraft the library holds, and what it refuses of a setup.
#include <string>

#include "capi/flying.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

using namespace capi;

TEST(capi_aircraft_has_a_name) {
  const int32_t aircraft = tr_aircraft_at(0);
  CHECK(aircraft > 0);
  CHECK_EQ(tr_aircraft_at(1), 0);
  CHECK_EQ(tr_aircraft_at(-1), 0);
  CHECK_EQ(std::string(tr_aircraft_name(aircraft)), std::string(tiltrotor::aircraft_identity().name));
  CHECK(tr_aircraft_description(aircraft)[0] != '\0');
  for (const int32_t unknown : {0, -1, aircraft + 1}) {
    CHECK_EQ(std::string(tr_aircraft_name(unknown)), std::string("unknown"));
    CHECK_EQ(std::string(tr_aircraft_description(unknown)), std::string());
    tr_setup setup = setup_at(0);
    setup.aircraft = unknown;
    tr_sim sim;
    CHECK_EQ(tr_init(&sim, TR_API_VERSION, &setup), TR_BAD_ARGUMENT);
  }
}

TEST_OF_XV15(capi_aircraft_of_the_xv15) {
  CHECK_EQ(tr_aircraft_at(0), static_cast<int32_t>(TR_XV15));
  CHECK_EQ(std::string(tr_aircraft_name(TR_XV15)), std::string("XV-15"));
  CHECK_EQ(std::string(tr_aircraft_name(TR_SCALED_XV15)), std::string("unknown"));  // not in this library
}

// Every field beyond its range: tr_check_setup and tr_init agree, and the line names the field.
TEST(capi_check_setup_names_the_field) {
  struct Case {
    tr_real tr_setup::*field;
    const char* name;
  };
  for (const Case& one :
       {Case{&tr_setup::mast_deg, "mast angle"}, Case{&tr_setup::flap_deg, "flap"},
        Case{&tr_setup::altitude_m, "altitude"}, Case{&tr_setup::mass_kg, "mass"},
        Case{&tr_setup::rotor_radps, "rotor speed"}, Case{&tr_setup::cg_station_m, "CG station"}}) {
    for (const tr_real bad : {tr_real(-1e6), tr_real(1e6), kNan, kInfinity}) {
      tr_setup setup = setup_at(30);
      setup.*one.field = bad;
      char text[100];
      CHECK_EQ(tr_check_setup(&setup, TR_API_VERSION, text, sizeof text), TR_OUT_OF_RANGE);
      CHECK(std::string(text).find(one.name) == 0);
      CHECK(std::string(text).find(" lies outside ") != std::string::npos);
      CHECK_EQ(tr_check_setup(&setup, TR_API_VERSION, nullptr, 0), TR_OUT_OF_RANGE);
      tr_sim sim;
      CHECK_EQ(tr_init(&sim, TR_API_VERSION, &setup), TR_OUT_OF_RANGE);
    }
  }
}

TEST(capi_check_setup_errors) {
  const tr_setup good = setup_at(30);
  char text[100] = "x";
  CHECK_EQ(tr_check_setup(&good, TR_API_VERSION, text, sizeof text), TR_OK);
  CHECK_EQ(text[0], '\0');
  CHECK_EQ(tr_check_setup(&good, TR_API_VERSION + 1, text, sizeof text), TR_WRONG_VERSION);
  CHECK_EQ(tr_check_setup(nullptr, TR_API_VERSION, text, sizeof text), TR_BAD_ARGUMENT);
  CHECK_EQ(tr_check_setup(&good, TR_API_VERSION, nullptr, 1), TR_BAD_ARGUMENT);
  tr_setup setup = good;
  setup.grid = 9;
  CHECK_EQ(tr_check_setup(&setup, TR_API_VERSION, text, sizeof text), TR_BAD_ARGUMENT);
  // A short text is cut and terminated; nothing is written beyond.
  setup = good;
  setup.mass_kg = 1;
  char little[8] = "1234567";
  CHECK_EQ(tr_check_setup(&setup, TR_API_VERSION, little, 6), TR_OUT_OF_RANGE);
  CHECK_EQ(std::string(little), std::string("mass "));
  CHECK_EQ(little[6], '7');
}
