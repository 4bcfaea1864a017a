// An aircraft with some of its numbers or tables changed, around a configuration that is there.
#pragma once

#include "study/copied_tables.hpp"
#include "tiltrotor/model/preparation.hpp"

namespace tiltrotor::cli {

class ChangedAircraft : public study::CopiedTables<double> {
 public:
  // Of the configuration; `change(*this)` may write to `aircraft`, scale and shift.
  template <class Change>
  ChangedAircraft(const Configuration<double>& base, Change&& change) : aircraft(*base.aircraft) {
    change(*this);
    remake(base);
  }
  ChangedAircraft(const ChangedAircraft&) = delete;
  ChangedAircraft& operator=(const ChangedAircraft&) = delete;

  const Configuration<double>& configuration() const { return c_; }

  Aircraft<double> aircraft;

 private:
  void remake(const Configuration<double>& base);

  Configuration<double> c_;
};

}  // namespace tiltrotor::cli
