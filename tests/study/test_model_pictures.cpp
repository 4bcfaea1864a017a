// Pictures that are made from the model's own lists: what acts on what, and who carries the weight. Expected: what the
// components are, and Newton's second law.
#include <cmath>

#include "check.hpp"
#include "study/sections.hpp"
#include "tiltrotor/model/variables/loads.hpp"

using namespace tiltrotor;
using study::Section;

namespace {

const text::Table& table_of(const Section& section, const std::string& name) {
  for (const study::NumberedTable& t : section.tables)
    if (t.name == name) return t.table;
  throw std::logic_error("no table " + name);
}

}  // namespace

// Surfaces move their own component alone, a rotor's states no load of the other rotor, and a heading nothing at all.
TEST(report_marks_what_acts_on_what) {
  const Section section = study::data_flow();
  const text::Table& marks = table_of(section, "data_flow");
  const auto acts = [&](const char* moved, const std::string& on) {
    return !marks.where("moved", std::string(moved)).text(0, on).empty();
  };
  for (const char* const component : kComponentNames) {
    const std::string name = component;
    CHECK_EQ(acts("elevator", name), name == "htail");
    CHECK_EQ(acts("rudder", name), name == "fin_right" || name == "fin_left");
    CHECK_EQ(acts("aileron", name), name == "wing_free");
    CHECK_EQ(acts("eps", name), name == "htail");
    CHECK(!acts("psi", name) && !acts("phi", name) && !acts("theta", name));
    CHECK(acts("u", name) && acts("gust_u", name));
  }
  CHECK(acts("b1c_R", "rotor_right") && !acts("b1c_R", "rotor_left"));
  CHECK(acts("n0_L", "wing_wake_left") && !acts("n0_L", "wing_wake_right"));
  CHECK(acts("q", "rate_theta") && !acts("u", "rate_theta") && acts("theta", "rate_u"));
  CHECK_EQ(marks.columns().size(), 1 + component_count + marks.rows() - control_count);
}

// Level flight: all components together carry the weight, so that none is left out.
TEST(report_shares_make_up_the_weight) {
  study::Sweeps sweeps;
  for (const double mast : {0.0, 30.0, 60.0}) sweeps.push_back(study::speed_sweep(mast, 20, 60));
  const Section section = study::load_sharing(sweeps);
  for (const char* const name : {"load_sharing", "load_sharing_conversion"}) {
    const text::Table& table = table_of(section, name);
    CHECK(table.rows() >= 6);
    for (std::size_t i = 0; i < table.rows(); ++i) {
      double sum = 0;
      for (const char* const carrier : {"rotors", "wing", "wake_on_wing", "tail", "rest"})
        sum += table.number(i, carrier);
      CHECK_NEAR(sum, 1.0, 1e-6);
    }
  }
}
