"""An LQR on the exact model in airplane mode, and the roots with and without it."""
import sys

import tiltrotor

try:
    import numpy
    import scipy.linalg
except ImportError as missing:
    sys.exit(f"lqr: {missing.name} is not installed, left out")

aircraft = tiltrotor.Aircraft(mast_deg=90)
aircraft.trim(speed_mps=100)
model = aircraft.linearize()
bend = {"m/s": 1, "rad": 0.02, "rad/s": 0.05}  # a unit of each state that is worth an inch of stick
weights = numpy.diag([bend.get(unit, 1e3) ** -2.0 for unit in model.state_units])
costs = numpy.diag([0.02 ** -2, 1, 1, 1])  # collective in rad, sticks and pedals in inches
riccati = scipy.linalg.solve_continuous_are(model.A, model.B, weights, costs)
gain = numpy.linalg.solve(costs, model.B.T @ riccati)
for name, a in ("open", model.A), ("closed", model.A - model.B @ gain):
    print(name, "slowest root", max(numpy.linalg.eigvals(a).real))
assert max(numpy.linalg.eigvals(model.A - model.B @ gain).real) < 0
