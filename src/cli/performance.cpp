#include "cli/performance.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "tiltrotor/math/bracketed_root.hpp"
#include "tiltrotor/systems/ground_effect.hpp"

namespace tiltrotor::cli {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double speed_step = 4, altitude_step = 1000;       // of the first look, m/s and m
constexpr double speed_width = 1e-3, altitude_width = 1e-2;  // of the searches, m/s and m
constexpr double golden = 0.381966;
constexpr double climb_width = 1e-7, steepest = 1.5;  // rad
constexpr double kilo = 1000;

struct Words {
  const char* name;
  const char* unit;
};
constexpr Words words[] = {{"least_power", "kW"},
                           {"best_range", "kJ/m"},
                           {"top_speed_power", "m/s"},
                           {"top_speed_torque", "m/s"},
                           {"best_climb", "m/s"},
                           {"hover_ceiling", "m"},
                           {"hover_ceiling_in_ground", "m"},
                           {"one_engine_least_speed", "m/s"},
                           {"one_engine_top_speed", "m/s"},
                           {"one_engine_ceiling", "m"},
                           {"one_engine_hover_ceiling", "m"}};
static_assert(sizeof words / sizeof words[0] == kFigures, "a name for each figure");

// What the flight may take: engines that run at a rating, and the masts' torque where it counts.
struct Supply {
  int engines;
  double rating;  // of one at sea level, W
  bool power = true, torque = true;
};

struct Flight {
  bool flies = false;  // trimmed, and short of every limit but power and torque
  double speed = nothing, climb = 0, altitude = 0, power = nothing, torque = nothing;
  std::string limit;  // why it does not fly
};

// The lowest f between a and b, f having one minimum there.
double lowest(const std::function<double(double)>& f, double a, double b, double width) {
  constexpr int most = 60;
  double inner[2] = {a + golden * (b - a), b - golden * (b - a)};
  double at[2] = {f(inner[0]), f(inner[1])};
  for (int k = 0; k < most && b - a > width; ++k) {
    if (at[0] <= at[1]) {
      b = inner[1];
      inner[1] = inner[0];
      at[1] = at[0];
      at[0] = f(inner[0] = a + golden * (b - a));
    } else {
      a = inner[0];
      inner[0] = inner[1];
      at[0] = at[1];
      at[1] = f(inner[1] = b - golden * (b - a));
    }
  }
  return at[0] <= at[1] ? inner[0] : inner[1];
}

class Performer {
 public:
  Performer(const Configuration<double>& c, double wheel_height, Analyses& work)
      : c_(c), given_altitude_(c.setup.altitude), wheel_height_(wheel_height), work_(work) {
    const Aircraft<double>& a = *c.aircraft;
    all_ = {a.controls.engines, a.controls.engine_power};
    one_ = {1, a.systems.drive.contingency};
  }

  std::vector<Performance> find() {
    look();
    add_minimum(Figure::least_power, [this](double v) { return level(v).power; });
    add_minimum(Figure::best_range, [this](double v) { return level(v).power / v; });
    add_speed(Figure::top_speed_power, {all_.engines, all_.rating, true, false}, true);
    add_speed(Figure::top_speed_torque, {all_.engines, all_.rating, false, true}, true);
    add_climb();
    add_ceiling(Figure::hover_ceiling, all_, [this](double) { return level(0); });
    in_ground_ = true;
    add_ceiling(Figure::hover_ceiling_in_ground, all_, [this](double) { return level(0); });
    in_ground_ = false;
    add_speed(Figure::one_engine_least_speed, one_, false);
    add_speed(Figure::one_engine_top_speed, one_, true);
    add_ceiling(Figure::one_engine_ceiling, one_, [this](double) { return easiest(); });
    add_ceiling(Figure::one_engine_hover_ceiling, one_, [this](double) { return level(0); });
    return found_;
  }

 private:
  void set_altitude(double altitude) {
    ConfigurationSetting<double> setting = c_.setup;
    setting.altitude = altitude;
    (void)reconfigure(setting, c_);  // inside the range
  }

  Flight level(double speed, double climb = 0) {
    const SteadyFlight<double> flight{speed, climb, 0, 0};
    c_.ground_wash[right] = c_.ground_wash[left] = c_.download = 1;
    (void)trim(c_, flight, work_, trim_);
    constexpr int rounds = 2;  // the ground hardly depends on the trim
    for (int k = 0; in_ground_ && k < rounds && is_trimmed(trim_.status); ++k) {
      feel_ground();
      (void)trim(c_, flight, work_, trim_);
    }
    Flight out;
    out.speed = speed;
    out.climb = climb;
    out.altitude = c_.setup.altitude;
    out.flies = is_trimmed(trim_.status);
    if (!out.flies) out.limit = trim_status_word(trim_.status);
    for (int k = 0; k < trim_.limits.count && out.flies; ++k) {
      const TrimLimit limit = trim_.limits.exceeded[k].limit;
      if (limit >= TrimLimit::power) continue;
      out.flies = false;
      out.limit = limit_name(limit).word;
    }
    if (!out.flies) return out;
    out.power = trim_.power[right] + trim_.power[left];
    out.torque = std::max(trim_.power[right], trim_.power[left]) / c_.setup.rotor_speed;
    return out;
  }

  // Hubs as high as with level wheels at their height.
  void feel_ground() {
    const State<double>& x = trim_.state;
    AboveGround<double> above = above_ground(GroundPlane<double>{}, x.roll, x.pitch, 0.0, Vec3<double>{});
    const double hub =
        component(above.up_b, c_.hub[right].arm_b) / 2 + component(above.up_b, c_.hub[left].arm_b) / 2;
    above.height = wheel_height_ + c_.aircraft->ground.hub_height_on_gear - hub;
    const double inflow[2] = {x.rotor[right].lambda_0, x.rotor[left].lambda_0};
    const GroundEffect<double> felt = ground_effect(c_, above, x.velocity, x.rates, inflow);
    c_.ground_wash[right] = felt.wash[right];
    c_.ground_wash[left] = felt.wash[left];
    c_.download = felt.download;
  }

  // Power and torque over what there is, the larger; above 1 where the flight needs more.
  double share(const Flight& f, const Supply& supply, const char** decides = nullptr) const {
    const ControlTables<double>& t = c_.aircraft->controls;
    const double available = shaft_power(c_, supply.rating) * supply.engines / t.engines;
    const double power = supply.power ? f.power / available : -HUGE_VAL;
    const double torque = supply.torque ? f.torque / t.mast_torque : -HUGE_VAL;
    if (decides != nullptr) *decides = power >= torque ? "power" : "torque";
    return std::max(power, torque);
  }

  void add(Figure figure, double value, const Flight& f, const std::string& limit) {
    if (!f.flies) return add_none(figure, f.limit);
    found_.push_back({figure, value, f.speed, f.power / kilo, f.altitude, limit});
  }
  void add_none(Figure figure, const std::string& limit) {
    found_.push_back({figure, std::nullopt, nothing, nothing, nothing, limit});
  }

  // Level flights at the steps of speed; those that fly lie together around the one of least power.
  void look() {
    flights_.clear();
    beyond_.clear();
    for (double v = 0; v <= c_.aircraft->limits.speed; v += speed_step) {
      const Flight f = level(v);
      if (f.flies) {
        flights_.push_back(f);
      } else if (!flights_.empty()) {
        beyond_ = f.limit;
        break;
      } else {
        below_ = f.limit;
      }
    }
    if (beyond_.empty()) beyond_ = "speed_max";
  }

  // Speeds beside the flight that is least in f.
  void around(const std::function<double(const Flight&)>& f, double& low, double& high) const {
    std::size_t best = 0;
    for (std::size_t k = 0; k < flights_.size(); ++k)
      if (f(flights_[k]) < f(flights_[best])) best = k;
    low = flights_[best > 0 ? best - 1 : best].speed;
    high = flights_[std::min(best + 1, flights_.size() - 1)].speed;
  }

  void add_minimum(Figure figure, const std::function<double(double)>& f) {
    if (flights_.empty()) return add_none(figure, below_);
    const bool range = figure == Figure::best_range;
    double low = 0, high = 0;
    around([&](const Flight& g) { return range ? g.power / std::max(g.speed, 1e-3) : g.power; }, low, high);
    const double v = lowest(f, low, high, speed_width);
    const Flight there = level(v);
    add(figure, f(v) / kilo, there, "");
  }

  // Where what is needed meets what there is, beyond or below the flight that needs least.
  void add_speed(Figure figure, const Supply& supply, bool upwards) {
    if (flights_.empty()) return add_none(figure, below_);
    const auto excess = [&](const Flight& f) { return share(f, supply) - 1; };
    std::size_t k = 0;
    for (std::size_t j = 0; j < flights_.size(); ++j)
      if (excess(flights_[j]) < excess(flights_[k])) k = j;
    if (excess(flights_[k]) > 0) return add_none(figure, "power");
    const std::size_t end = upwards ? flights_.size() - 1 : 0;
    while (k != end && excess(flights_[k]) <= 0) upwards ? ++k : --k;
    if (excess(flights_[k]) <= 0) {
      // The slowest flight there is needs no more than there is.
      if (!upwards && flights_[k].speed == 0) return add(figure, 0, flights_[k], "");
      return add_none(figure, upwards ? beyond_ : below_);
    }
    const double v =
        bracketed_root([&](double at) { return excess(level(at)); }, flights_[upwards ? k - 1 : k + 1].speed,
                       flights_[k].speed, speed_width / 10);
    const char* decides = "";
    const Flight there = level(v);
    (void)share(there, supply, &decides);
    add(figure, v, there, decides);
  }

  // Climb angle at which the flight takes all there is; none below level flight.
  Flight steepest_climb(double speed) {
    const auto excess = [&](double climb) { return share(level(speed, climb), all_) - 1; };
    const Flight here = level(speed);
    const double room = 1 - share(here, all_);
    if (!here.flies || !(room > 0) || speed <= 0) return here;
    const double weight = c_.mass.mass * kGravity<double>;
    const double guess = std::min(room * here.power / (1 - room) / (weight * speed), 1.0);
    double low = 0, high = std::asin(guess);
    for (int k = 0; k < 8 && excess(high) < 0 && high < steepest; ++k) {
      low = high;
      high = std::min(1.3 * high, steepest);
    }
    return level(speed, bracketed_root(excess, low, high, climb_width));
  }

  void add_climb() {
    if (flights_.empty()) return add_none(Figure::best_climb, below_);
    const auto rate = [this](double v) {
      const Flight f = steepest_climb(v);
      return f.flies ? v * std::sin(f.climb) : 0;
    };
    std::size_t best = 0;
    double most = -1;
    for (std::size_t k = 0; k < flights_.size(); k += 2) {
      const double now = rate(flights_[k].speed);
      if (now > most) most = now, best = k;
    }
    if (!(most > 0)) return add_none(Figure::best_climb, "power");
    const double low = flights_[best >= 2 ? best - 2 : 0].speed;
    const double high = flights_[std::min(best + 2, flights_.size() - 1)].speed;
    const double v = lowest([&](double at) { return -rate(at); }, low, high, 10 * speed_width);
    const char* decides = "";
    const Flight there = steepest_climb(v);
    (void)share(there, all_, &decides);
    add(Figure::best_climb, v * std::sin(there.climb), there, decides);
  }

  // The level flight that needs least of one engine, at the altitude that is set.
  Flight easiest() {
    if (flights_.empty()) return {};
    double low = 0, high = 0;
    around([](const Flight& f) { return f.power; }, low, high);
    low = std::max(low - speed_step, 0.0);
    high += 3 * speed_step;  // faster in thin air
    const auto power = [this](double v) {
      const Flight f = level(v);
      return f.flies ? f.power : HUGE_VAL;
    };
    return level(lowest(power, low, high, 10 * speed_width));
  }

  void add_ceiling(Figure figure, const Supply& supply, const std::function<Flight(double)>& flight) {
    const auto excess = [&](double altitude) {
      set_altitude(altitude);
      return share(flight(altitude), supply) - 1;
    };
    const Bounds<double> range = c_.aircraft->limits.altitude;
    double below = nothing, altitude = range.low;
    double now = excess(altitude);
    const Flight lowest_flight = flight(altitude);
    std::string limit = lowest_flight.flies ? "power" : lowest_flight.limit;
    while (now <= 0 && altitude < range.high) {
      below = altitude;
      altitude = std::min(altitude + altitude_step, range.high);
      now = excess(altitude);
      limit = now <= 0 ? "altitude_max" : flight(altitude).limit;
    }
    if (!(now > 0) || std::isnan(below)) {
      add_none(figure, limit);
    } else {
      const double ceiling = bracketed_root(excess, below, altitude, altitude_width);
      const char* decides = "";
      set_altitude(ceiling);
      const Flight there = flight(ceiling);
      (void)share(there, supply, &decides);
      add(figure, ceiling, there, decides);
    }
    set_altitude(given_altitude_);
  }

  Configuration<double> c_;
  double given_altitude_, wheel_height_;
  Analyses& work_;
  Supply all_{}, one_{};
  bool in_ground_ = false;
  TrimResult<double> trim_{};
  std::vector<Flight> flights_;
  std::string below_, beyond_;  // what ends the flights
  std::vector<Performance> found_;
};

}  // namespace

const char* figure_name(Figure figure) { return words[static_cast<int>(figure)].name; }
const char* figure_unit(Figure figure) { return words[static_cast<int>(figure)].unit; }

std::vector<Performance> performance(const Configuration<double>& c, double wheel_height, Analyses& work) {
  return Performer(c, wheel_height, work).find();
}

}  // namespace tiltrotor::cli
