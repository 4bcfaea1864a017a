#include "tablegen/composition.hpp"

#include "tablegen/fault.hpp"

namespace tablegen {

void Composition::read(const std::string& file, int flap_settings) {
  csv_ = read_csv(file);
  flap_settings_ = flap_settings;
  const std::size_t table = csv_.column("table");
  const std::size_t part = csv_.column("part");
  const std::size_t mast = csv_.column("mast_deg");
  const std::size_t setting = csv_.column("flap_setting");
  const std::size_t name = csv_.column("file");
  const std::string ending = ".csv";
  for (const Row& row : csv_.rows) {
    Entry entry{row.line, row.cell[table], row.cell[part], !row.cell[mast].empty(), {0, 0, row.cell[name]}};
    std::string& path = entry.place.file;
    if (path.size() <= ending.size() || path.compare(path.size() - ending.size(), ending.size(), ending) != 0)
      throw Fault{csv_.file, row.line, "'" + path + "' is no name of a .csv file"};
    path.erase(path.size() - ending.size());
    if (entry.at_mast) entry.place.mast_deg = number(csv_, row, mast);
    if (entry.place.mast_deg < 0 || entry.place.mast_deg > 90)
      throw Fault{csv_.file, row.line, "mast angle " + row.cell[mast] + " lies outside 0..90 deg"};
    if (!row.cell[setting].empty()) {
      const double k = number(csv_, row, setting);
      entry.place.setting = static_cast<int>(k);
      if (!entry.at_mast || k != entry.place.setting || k < 1 || k > flap_settings)
        throw Fault{csv_.file, row.line,
                    "flap setting " + row.cell[setting] + " is none of 1.." + std::to_string(flap_settings) +
                        " at a mast angle"};
    }
    entries_.push_back(entry);
  }
}

std::vector<Composition::Entry*> Composition::rows_of(const std::string& table, const std::string& part,
                                                      bool at_mast) {
  std::vector<Entry*> rows;
  for (Entry& entry : entries_)
    if (entry.table == table && entry.part == part && entry.at_mast == at_mast) rows.push_back(&entry);
  if (rows.empty())
    throw Fault{csv_.file, csv_.rows.back().line,
                "no row for table '" + table + "'" + (part.empty() ? "" : ", part '" + part + "'") +
                    (at_mast ? ", by mast angle" : "")};
  for (Entry* row : rows) row->used = true;
  return rows;
}

std::string Composition::file(const std::string& table, const std::string& part) {
  const std::vector<Entry*> rows = rows_of(table, part, false);
  if (rows.size() > 1) throw Fault{csv_.file, rows[1]->line, "table '" + table + "' has its file already"};
  return rows.front()->place.file;
}

std::vector<Composition::Part> Composition::by_mast(const std::string& table) {
  std::vector<Part> parts;
  for (const Entry* row : rows_of(table, "", true)) {
    if (row->place.setting != 0)
      throw Fault{csv_.file, row->line, "table '" + table + "' has no files by flap setting"};
    if (!parts.empty() && !(parts.back().mast_deg < row->place.mast_deg))
      throw Fault{csv_.file, row->line, "mast angles of '" + table + "' do not increase"};
    parts.push_back(row->place);
  }
  return parts;
}

std::vector<Composition::Part> Composition::by_mast_and_flap(const std::string& table) {
  std::vector<Part> parts;
  int line = 0;
  for (const Entry* row : rows_of(table, "", true)) {
    line = row->line;
    const auto place = static_cast<int>(parts.size()) % flap_settings_;
    const bool same_mast = place == 0 || parts.back().mast_deg == row->place.mast_deg;
    const bool next_mast = parts.empty() || place > 0 || parts.back().mast_deg < row->place.mast_deg;
    if (row->place.setting != place + 1 || !same_mast || !next_mast)
      throw Fault{csv_.file, line,
                  "rows of '" + table + "': mast angles that increase, each with flap settings 1.." +
                      std::to_string(flap_settings_)};
    parts.push_back(row->place);
  }
  if (static_cast<int>(parts.size()) % flap_settings_ != 0)
    throw Fault{csv_.file, line, "flap settings of '" + table + "' are missing at the last mast angle"};
  return parts;
}

void Composition::check_all_used() const {
  for (const Entry& entry : entries_)
    if (!entry.used)
      throw Fault{csv_.file, entry.line,
                  "the model has no table '" + entry.table + "'" +
                      (entry.part.empty() ? "" : ", part '" + entry.part + "'") +
                      (entry.at_mast ? ", by mast angle" : "")};
}

}  // namespace tablegen
