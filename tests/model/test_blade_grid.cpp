// Stations of the blade-element integrals: they tile the blade, stay inside their regions, integrate
// polynomials, and the azimuth weights are the blades.
#include "flight_cases.hpp"

using namespace flight_cases;

namespace {

const RotorTables<double>& kRotor = aircraft().rotor;
const double kRadius = kRotor.radius;
// Root cutout, section regions, tip (r/R).
const double kEdges[] = {kRotor.root_cutout, kRotor.region_edge[0], kRotor.region_edge[1],
                         kRotor.region_edge[2], 1.0};

// Width of a station as integrated: chord area over the chord at its radius.
double width(const BladeStation<double>& s, ChordSource source) {
  return 2 * s.half_chord_dr / blade_chord(aircraft().rotor, source, s.radius / kRadius);
}

}  // namespace

TEST(blade_grid_tiles_the_blade) {
  for (const BladeGrid grid : {BladeGrid::specification, BladeGrid::realtime}) {
    for (int refinement = 1; refinement <= 4; ++refinement) {
      Options options;
      options.grid = grid;
      options.grid_refinement = refinement;
      const BladeStations<double> blade = configuration(0, options).blade;
      if (grid == BladeGrid::specification) CHECK_EQ(blade.count, 20 * refinement);
      CHECK_LE(blade.count, kMaxBladeStations);
      CHECK_EQ(blade.region_end[kSectionRegions - 1], blade.count);
      double length = 0;
      double lift_length = 0;
      int i = 0;
      for (int region = 0; region < kSectionRegions; ++region) {
        double region_length = 0;
        for (; i < blade.region_end[region]; ++i) {
          const BladeStation<double>& s = blade.station[i];
          const double x = s.radius / kRadius;
          CHECK(x > kEdges[region] && x < kEdges[region + 1]);
          if (i > 0) CHECK(s.radius > blade.station[i - 1].radius);
          region_length += width(s, options.chord);
          lift_length += s.lift_weight * width(s, options.chord);
        }
        CHECK_NEAR(region_length, (kEdges[region + 1] - kEdges[region]) * kRadius, 1e-12);
        length += region_length;
      }
      CHECK_NEAR(length, (1 - kEdges[0]) * kRadius, 1e-12);
      CHECK_NEAR(lift_length, (kRotor.tip_loss - kEdges[0]) * kRadius, 1e-12);  // tip loss
    }
  }
}

// Thrust goes with the integral of x^2: the mid-point rule of 20 segments is within 2e-3 of it.
TEST(blade_grid_integrates_the_load) {
  for (const BladeGrid grid : {BladeGrid::specification, BladeGrid::realtime}) {
    for (int power = 1; power <= 3; ++power) {
      Options options;
      options.grid = grid;
      const BladeStations<double> blade = configuration(0, options).blade;
      double sum = 0;
      for (int i = 0; i < blade.count; ++i) {
        const BladeStation<double>& s = blade.station[i];
        sum += std::pow(s.radius / kRadius, power) * width(s, options.chord) / kRadius;
      }
      const double exact = (1 - std::pow(kEdges[0], power + 1)) / (power + 1);
      CHECK_REL(sum, exact, 4e-3);
    }
  }
}

TEST_OF_XV15(blade_grid_chord_and_twist) {
  const double edges[] = {0.0875, 0.55, 0.80, 0.95, 1.0};
  for (int k = 0; k < 5; ++k) CHECK_NEAR(kEdges[k], edges[k], 1e-15);
  CHECK_NEAR(kRadius, 12.5 * 0.3048, 1e-15);
  CHECK_EQ(kRotor.tip_loss, 0.97);
  const RotorTables<double>& rotor = aircraft().rotor;
  const double inch = 0.0254;
  CHECK_NEAR(blade_chord(rotor, ChordSource::cutout, 0.75), 14 * inch, 1e-12);
  CHECK_NEAR(blade_chord(rotor, ChordSource::cutout, 0.0875), 17 * inch, 1e-9);
  CHECK_NEAR(blade_chord(rotor, ChordSource::cutout, 1.0), 14 * inch, 1e-12);
  // Solidity 0.0891 with the outboard chord.
  CHECK_NEAR(3 * blade_chord(rotor, ChordSource::cutout, 0.75) / (kPi<double> * kRadius), 0.0891, 1e-4);
  // Root collective stands 34.43 deg above that at 0.75 R; the blade is twisted nose down outboard.
  CHECK_NEAR(blade_twist(rotor, TwistSource::table, 0.0) * kDegPerRad<double>, 34.43, 0.006);
  CHECK_EQ(blade_twist(rotor, TwistSource::table, 0.75), 0.0);
  CHECK_LT(blade_twist(rotor, TwistSource::table, 1.0), 0.0);
  CHECK_NEAR((blade_twist(rotor, TwistSource::linear, 1.0) - blade_twist(rotor, TwistSource::linear, 0.0)) *
                 kDegPerRad<double>,
             -41.0, 1e-9);
  CHECK_EQ(blade_twist(rotor, TwistSource::linear, 0.75), 0.0);
}

TEST(blade_grid_azimuth_weights) {
  for (const int count : {3, 8, 12, 24, 36, 72}) {
    const AzimuthStations<double> a = averaged_azimuth<double>(3, count);
    double blades = 0;
    double cosine = 0;
    double sine = 0;
    double cosine2 = 0;
    for (int k = 0; k < a.count; ++k) {
      blades += a.weight;
      cosine += a.weight * a.cosine[k];
      sine += a.weight * a.sine[k];
      cosine2 += a.weight * a.cosine[k] * a.cosine[k];
      CHECK_NEAR(a.cosine[k] * a.cosine[k] + a.sine[k] * a.sine[k], 1.0, 1e-15);
    }
    CHECK_EQ(a.count, count);
    CHECK_NEAR(blades, 3.0, 1e-14);
    CHECK_NEAR(cosine, 0.0, 1e-14);
    CHECK_NEAR(sine, 0.0, 1e-14);
    CHECK_NEAR(cosine2, 1.5, 1e-13);
  }
  AzimuthStations<double> blades;
  individual_azimuth(3, 0.4, blades);
  CHECK_EQ(blades.count, 3);
  CHECK_EQ(blades.weight, 1.0);
  for (int k = 0; k < 3; ++k) {
    CHECK_NEAR(blades.cosine[k], std::cos(0.4 + 2 * kPi<double> * k / 3), 1e-15);
    CHECK_NEAR(blades.sine[k], std::sin(0.4 + 2 * kPi<double> * k / 3), 1e-15);
  }
}
