#include "cli/chosen_columns.hpp"

#include <algorithm>
#include <limits>

#include "cli/errors.hpp"
#include "cli/output_names.hpp"
#include "text/csv_line.hpp"
#include "text/nearest.hpp"

namespace tiltrotor::cli {

OptionList columns_option() {
  return {{"--columns", "A,B,..",
           "only these, in this order: of those printed without it, and of the outputs\n"
           "of linearize by their names (airspeed, power_right, nz@230/0/75 at a\n"
           "station, htail_force_z), in SI; a name may end in another unit\n"
           "(speed_kt, altitude_ft, mass_lb, power_hp)"}};
}

ChosenColumns::ChosenColumns(const Arguments& arguments, const std::vector<std::string>& own) : names_(own) {
  if (!arguments.given("--columns")) {
    for (std::size_t k = 0; k < own.size(); ++k) place_.push_back(k);
    size_.assign(own.size(), 1);
    return;
  }
  const auto place_in = [](const std::vector<std::string>& names, const std::string& name) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  };
  std::vector<std::string> outputs, all = own;
  for (const OutputName& output : kOutputNames) {
    outputs.emplace_back(output.name);
    if (place_in(own, output.name) == own.size()) all.emplace_back(output.name);
  }
  names_.clear();
  const std::string where = arguments.where("--columns");
  for (const std::string& text : split(arguments.text("--columns", ""), ',')) {
    const std::string name(csv::trimmed(text));
    std::size_t place = place_in(own, name);
    double size = 1;
    if (const InUnit in = in_own_unit(name); place == own.size() && place_in(own, in.name) < own.size()) {
      place = place_in(own, in.name);
      size = in.size;
    }
    if (place == own.size()) place += place_in(outputs, name);
    const bool is_reading = place >= own.size() && place < own.size() + outputs.size();
    if (place == own.size() + outputs.size()) {
      const std::optional<NamedOutput> output = output_named(name, where);
      if (!output) {
        std::vector<std::string> near = all;
        for (const std::string& other : output_names()) near.push_back(other);
        throw UsageError(where + ": no column " + quoted(name) + did_you_mean(name, near) + "; choose " +
                         one_of(all) + "; or " + kOtherOutputs);
      }
      place += airframe_.size();
      airframe_.push_back(output->output);
    }
    if (std::find(names_.begin(), names_.end(), name) != names_.end() ||
        std::find(place_.begin(), place_.end(), place) != place_.end())
      throw UsageError(where + ": " + name + " stands there twice");
    names_.push_back(name);
    place_.push_back(place);
    size_.push_back(size);
    have_readings_ = have_readings_ || is_reading;
  }
}

Row ChosenColumns::row(const Row& own, const Instruments<double>& readings,
                       const std::vector<double>& airframe) const {
  double reading[Instruments<double>::kCount];
  flatten(readings, reading);
  std::vector<double> beside(reading, reading + Instruments<double>::kCount);
  beside.insert(beside.end(), airframe.begin(), airframe.end());
  beside.resize(Instruments<double>::kCount + airframe_.size(), std::numeric_limits<double>::quiet_NaN());
  Row row;
  for (std::size_t k = 0; k < place_.size(); ++k) {
    const std::size_t place = place_[k];
    row.push_back(in_unit(place < own.size() ? own[place] : Cell(beside[place - own.size()]), size_[k]));
  }
  return row;
}

Instruments<double> no_readings() {
  Instruments<double> readings;
  Instruments<double>::each(readings, [](double& x) { x = std::numeric_limits<double>::quiet_NaN(); });
  return readings;
}

}  // namespace tiltrotor::cli
