// CG and inertia against mast angle: printed values, the motion of the tilting mass about the conversion
// axis, switches.
#include "tiltrotor/model/setup/mass_properties.hpp"

#include "check.hpp"
#include "tiltrotor/model/aircraft/aircraft_data.hpp"

using namespace tiltrotor;

namespace {

constexpr double kInch = 0.0254;
constexpr double kPound = 0.45359237;
constexpr double kSlugSquareFoot = 0.45359237 * 9.80665 / 0.3048 * 0.3048 * 0.3048;

Options quoted() {
  Options options;
  options.nacelle_mass = NacelleMass::quoted;
  return options;
}

MassProperties<double> at(double mast, double sl_cg0_in = 301.2, const Options& options = quoted(),
                          double mass = 13000 * kPound) {
  return mass_properties(aircraft_data<double>(), mast, sine_and_cosine(mast * kRadPerDeg<double>), mass,
                         sl_cg0_in * kInch, 81.65 * kInch, options);
}

}  // namespace

// CG positions of the reference simulation, ft: Kleinhesselink 2007, app. C; some printed to a tenth.
TEST_OF_XV15(mass_properties_printed_cg) {
  struct Row {
    double mast, sl, wl, rounding;
  };
  for (const Row& row : {Row{15, 24.99, 6.73, 0.005}, Row{30, 24.9, 6.6, 0.05}, Row{60, 24.8, 6.4, 0.05},
                         Row{90, 24.85, 6.13, 0.005}}) {
    const MassProperties<double> here = at(row.mast, 301.2, Options{});
    CHECK_NEAR(here.sl_cg / kInch / 12, row.sl, row.rounding);
    CHECK_NEAR(here.wl_cg / kInch / 12, row.wl, row.rounding);
  }
}

// Hand-evaluated numbers with 4200 lb of nacelles for SL 300, WL 81.65 at mast 0 (in, two decimals).
TEST_OF_XV15(mass_properties_printed_stations) {
  struct Row {
    double mast, sl, wl;
  };
  for (const Row& row :
       {Row{0, 300, 81.65}, Row{30, 297.45, 79.53}, Row{60, 296.30, 76.42}, Row{90, 296.87, 73.15}}) {
    CHECK_NEAR(at(row.mast, 300).sl_cg / kInch, row.sl, 0.006);
    CHECK_NEAR(at(row.mast, 300).wl_cg / kInch, row.wl, 0.006);
  }
}

// 4200 lb of 13000 lb turn about SL 300, WL 100; their own CG lies at SL 291.7, WL 118 with the mast up.
// Explicit rotation of that point, nose down, and the moment balance of fixed and turning part.
TEST_OF_XV15(mass_properties_by_rotation_of_the_nacelles) {
  for (double mast = 0; mast <= 90; mast += 7.5) {
    const double angle = mast * kRadPerDeg<double>;
    const double aft = 291.7 - 300;
    const double up = 118 - 100;
    const double aft_turned =
        aft * std::cos(angle) - up * std::sin(angle);  // forward tilt moves an upper mass forward
    const double up_turned = up * std::cos(angle) + aft * std::sin(angle);
    const double share = 4200.0 / 13000;
    CHECK_NEAR(at(mast).sl_cg / kInch, 301.2 + share * (aft_turned - aft), 1e-9);
    CHECK_NEAR(at(mast).wl_cg / kInch, 81.65 + share * (up_turned - up), 1e-9);
  }
  // A lighter aircraft shifts more.
  const double light = 10000 * kPound;
  CHECK_NEAR((at(90, 301.2, quoted(), light).sl_cg - 301.2 * kInch) * light,
             (at(90).sl_cg - 301.2 * kInch) * 13000 * kPound, 1e-9);
}

TEST_OF_XV15(mass_properties_inertia) {
  for (const double mast : {0.0, 45.0, 90.0}) {
    const Inertia<double> i = at(mast).inertia;
    CHECK_REL(i.xx / kSlugSquareFoot, 52795 - 20.5 * mast, 1e-6);
    CHECK_REL(i.yy / kSlugSquareFoot, 21360 - 11.24 * mast, 1e-6);
    CHECK_REL(i.zz / kSlugSquareFoot, 66335 + 9.26 * mast, 1e-6);
    CHECK_REL(i.xz / kSlugSquareFoot, 1234 - 1.76 * mast, 1e-6);
    // A real body: each moment below the sum of the others.
    CHECK_LT(i.zz, i.xx + i.yy);
    CHECK_LT(i.xx, i.zz + i.yy);
  }
  Options design_1975;
  design_1975.inertia = InertiaSet::design_1975;
  const Inertia<double> old_0 = at(0, 301.2, design_1975).inertia;
  const Inertia<double> old_45 = at(45, 301.2, design_1975).inertia;
  const Inertia<double> old_90 = at(90, 301.2, design_1975).inertia;
  CHECK_REL(old_0.xx / kSlugSquareFoot, 42400, 1e-6);
  CHECK_REL(old_0.yy / kSlugSquareFoot, 14300, 1e-6);
  CHECK_REL(old_90.zz / kSlugSquareFoot, 50300, 1e-6);
  CHECK_REL(old_45.yy / kSlugSquareFoot, (14300 + 13200) / 2.0, 1e-6);
  CHECK_EQ(old_45.xz, at(45).inertia.xz);
  CHECK_EQ(at(0).mass, 13000 * kPound);
}
