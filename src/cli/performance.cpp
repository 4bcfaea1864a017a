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
constexpr Words words[] = {
    {"least_power", "kW"},           {"best_range", "kJ/m"},           {"top_speed", "m/s"},
    {"top_speed_power", "m/s"},      {"top_speed_torque", "m/s"},      {"best_climb", "m/s"},
    {"hover_ceiling", "m"},          {"hover_ceiling_in_ground", "m"}, {"one_engine_least_speed", "m/s"},
    {"one_engine_top_speed", "m/s"}, {"one_engine_ceiling", "m"},      {"one_engine_hover_ceiling", "m"}};
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

// The lowest f between a and b, f having one minimum there, perhaps beyond a part where it is infinite.
double lowest(const std::function<double(double)>& f, double a, double b, double width) {
  constexpr int most = 60;
  double inner[2] = {a + golden * (b - a), b - golden * (b - a)};
  double at[2] = {f(inner[0]), f(inner[1])};
  for (int k = 0; k < most && b - a > width; ++k) {
    if (at[0] < at[1]) {
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
      : c_(c),
        given_altitude_(c.setup.altitude),
        given_density_(c.air.density),
        wheel_height_(wheel_height),
        work_(work) {
    const Aircraft<double>& a = *c.aircraft;
    all_ = {a.controls.engines, a.controls.engine_power};
    one_ = {1, a.systems.drive.contingency};
  }

  std::vector<Performance> find() {
    look();
    add_minimum(Figure::least_power, [this](double v) { return level(v).power; });
    add_minimum(Figure::best_range, [this](double v) { return level(v).power / v; });
    add_speed(Figure::top_speed, all_, true);
    add_speed(Figure::top_speed_power, {all_.engines, all_.rating, true, false}, true);
    add_speed(Figure::top_speed_torque, {all_.engines, all_.rating, false, true}, true);
    add_climb();
    add_ceiling(Figure::hover_ceiling, all_, [this] { return level(0); });
    in_ground_ = true;
    add_ceiling(Figure::hover_ceiling_in_ground, all_, [this] { return level(0); });
    in_ground_ = false;
    add_speed(Figure::one_engine_least_speed, one_, false);
    add_speed(Figure::one_engine_top_speed, one_, true);
    add_ceiling(Figure::one_engine_ceiling, one_, [this] { return easiest(); });
    add_ceiling(Figure::one_engine_hover_ceiling, one_, [this] { return level(0); });
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
    c_.rotor[right].ground_wash = c_.rotor[left].ground_wash = c_.download = 1;
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
    c_.rotor[right].ground_wash = felt.wash[right];
    c_.rotor[left].ground_wash = felt.wash[left];
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

  // Level flights at the steps of speed: those next to each other that lead to the one of least power.
  void look() {
    std::vector<Flight> all;
    for (double v = 0; v <= c_.aircraft->limits.speed; v += speed_step) all.push_back(level(v));
    std::size_t best = 0;
    for (std::size_t k = 0; k < all.size(); ++k)
      if (all[k].flies && !(all[k].power >= all[best].power)) best = k;
    std::size_t first = best, last = best;
    while (first > 0 && all[first - 1].flies) --first;
    while (last + 1 < all.size() && all[last + 1].flies) ++last;
    if (all[best].flies)
      flights_.assign(all.begin() + static_cast<long>(first), all.begin() + static_cast<long>(last) + 1);
    below_ = first > 0 || flights_.empty() ? all[first > 0 ? first - 1 : 0].limit : "";
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

  // The last flight inside every limit on the way from one that is to one that is not, and what stops the next.
  // `at`: the flight at a place of the way.
  Flight last_inside(const Supply& supply, double inside, double outside, double width,
                     const std::function<Flight(double)>& at, std::string& limit) const {
    constexpr int most = 60;
    for (int k = 0; k < most && std::fabs(outside - inside) > width; ++k) {
      const double middle = (inside + outside) / 2;
      const Flight f = at(middle);
      (is_inside(f, supply) ? inside : outside) = middle;
    }
    limit = what_stops(at(outside), supply);
    return at(inside);
  }
  bool is_inside(const Flight& f, const Supply& supply) const { return f.flies && share(f, supply) <= 1; }
  std::string what_stops(const Flight& f, const Supply& supply) const {
    const char* decides = "";
    if (f.flies) (void)share(f, supply, &decides);
    return f.flies ? decides : f.limit;
  }

  // The fastest or slowest flight; of one limit alone: none where another one comes first.
  void add_speed(Figure figure, const Supply& supply, bool upwards) {
    if (flights_.empty()) return add_none(figure, below_);
    const Flight* easy = &flights_.front();
    for (const Flight& f : flights_)
      if (share(f, supply) < share(*easy, supply)) easy = &f;
    if (!is_inside(*easy, supply)) return add_none(figure, what_stops(*easy, supply));
    double inside = easy->speed;
    Flight next = *easy;
    const double end = upwards ? c_.aircraft->limits.speed : 0;
    while (is_inside(next, supply) && inside != end) {
      inside = next.speed;
      next = level(upwards ? std::min(inside + speed_step, end) : std::max(inside - speed_step, 0.0));
      if (next.speed == end && is_inside(next, supply)) inside = end;
    }
    if (inside == end) return upwards ? add_none(figure, "speed_max") : add(figure, end, level(end), "");
    std::string limit;
    const Flight f = last_inside(
        supply, inside, next.speed, speed_width / 10, [this](double v) { return level(v); }, limit);
    const bool other = supply.power != supply.torque && limit != (supply.power ? "power" : "torque");
    other ? add_none(figure, limit) : add(figure, f.speed, f, limit);
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
    const double faster = std::sqrt(given_density_ / c_.air.density);  // in thin air, at the same lift
    low = std::max(faster * low - speed_step, 0.0);
    high = std::min(faster * high + speed_step, c_.aircraft->limits.speed);
    const auto power = [this](double v) {
      const Flight f = level(v);
      return f.flies ? f.power : HUGE_VAL;
    };
    return level(lowest(power, low, high, 10 * speed_width));
  }

  // The highest altitude of a flight, from the lowest on.
  void add_ceiling(Figure figure, const Supply& supply, const std::function<Flight()>& flight) {
    const auto at = [&](double altitude) {
      set_altitude(altitude);
      return flight();
    };
    const Bounds<double> range = c_.aircraft->limits.altitude;
    double inside = range.low, next = range.low;
    Flight f = at(next);
    std::string limit = what_stops(f, supply);
    if (!is_inside(f, supply)) {
      add_none(figure, limit);
    } else {
      while (is_inside(f, supply) && next < range.high) {
        inside = next;
        next = std::min(inside + altitude_step, range.high);
        f = at(next);
      }
      if (is_inside(f, supply)) {
        add_none(figure, "altitude_max");
      } else {
        const Flight there = last_inside(supply, inside, next, altitude_width, at, limit);
        add(figure, there.altitude, there, limit);
      }
    }
    set_altitude(given_altitude_);
  }

  Configuration<double> c_;
  double given_altitude_, given_density_, wheel_height_;
  Analyses& work_;
  Supply all_{}, one_{};
  bool in_ground_ = false;
  TrimResult<double> trim_{};
  std::vector<Flight> flights_;
  std::string below_;  // what ends the flights on the slow side
  std::vector<Performance> found_;
};

}  // namespace

const char* figure_name(Figure figure) { return words[static_cast<int>(figure)].name; }
const char* figure_unit(Figure figure) { return words[static_cast<int>(figure)].unit; }

std::vector<Performance> performance(const Configuration<double>& c, double wheel_height, Analyses& work) {
  return Performer(c, wheel_height, work).find();
}

}  // namespace tiltrotor::cli
