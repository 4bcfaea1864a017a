// Statements of the paper as numbers: what is claimed is a value or a bound.
#pragma once

#include "text/table.hpp"

namespace tiltrotor::study {

using text::Table;

// From tables of the report: trim_curves, trim_compared, modes, response, response_modes.
// Columns: point, mast_deg, quantity, here, reference.
Table compared_claims(const Table& curves, const Table& trims, const Table& modes, const Table& motion,
                      const Table& motion_modes);

}  // namespace tiltrotor::study
