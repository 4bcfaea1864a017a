"""The library by Python. Expected: sizes of the library itself, central differences, the same flight twice, and refusals
with the library's sentence. Ends with status 0 and nothing printed when all is well."""
import ctypes
import math

import tiltrotor as t


def near(a, b, tolerance):
    assert abs(a - b) <= tolerance, (a, b)


def refused(error, words, call, *arguments, **named):
    try:
        call(*arguments, **named)
    except error as found:
        assert all(word in str(found) for word in words), str(found)
    else:
        raise AssertionError(f"accepted: {arguments} {named}")


single = t.tr_real is ctypes.c_float
assert t.tr_sim_size() <= ctypes.sizeof(t.tr_sim) == t.TR_SIM_SIZE
assert t.tr_work_size() <= ctypes.sizeof(t.tr_work) == t.TR_WORK_SIZE
assert ctypes.sizeof(t.tr_outputs) >= 8 + t.TR_OUTPUTS * ctypes.sizeof(t.tr_real)
for name in dir(t):
    if name.startswith("tr_") and not isinstance(getattr(t, name), type):
        assert getattr(t, name).__doc__.startswith(("tr_status ", "const char* ", "size_t ", "int32_t ")), name

aircraft = t.Aircraft(mast_deg=30, mass_kg=5500)
assert aircraft.setup.mass_kg == 5500 and aircraft.trim(speed_mps=40).status == t.TR_OK
near(aircraft.outputs.airspeed_mps, 40, 1e-4 if single else 1e-9)
near(aircraft.outputs.load_factor, 1, 1e-3 if single else 1e-9)

# A and C by differences of rates and outputs.
model = aircraft.linearize(outputs=True)
assert model.states[:4] == ["u", "w", "q", "theta"] and model.controls == ["collective", "long_stick", "lat_stick", "pedal"]
assert len(model.A) == 23 and len(model.B[0]) == 4 and len(model.C) == t.TR_OUTPUTS and len(model.D[0]) == 4
assert model.state_units[0] == "m/s" and model.control_units[1] == "in"
near(model.y0[0], 40, 1e-4 if single else 1e-9)
place, step, ways = t.TR_W, 1e-2 if single else 1e-4, []
for sign in (1, -1):
    moved = aircraft.state
    moved.x[place] += sign * step
    aircraft.state = moved
    rates = (t.tr_real * t.TR_STATES)()
    aircraft.call(t.tr_derivative, rates, len(rates))
    ways.append((rates[t.TR_Q], aircraft.outputs.airspeed_mps))
    moved.x[place] -= sign * step
    aircraft.state = moved
tolerance = 2e-3 if single else 1e-7
near(model.A[2][1], (ways[0][0] - ways[1][0]) / (2 * step), tolerance)
near(model.C[0][1], (ways[0][1] - ways[1][1]) / (2 * step), 10 * tolerance)

# Modes are the roots of A: their sum, a conjugate pair counted twice, is its trace.
modes = aircraft.modes()
trace = sum(model.A[k][k] for k in range(23))
near(sum(m.eigenvalue.real * (2 if m.eigenvalue.imag else 1) for m in modes), trace, abs(trace) * (1e-4 if single else 1e-10))
assert {"phugoid", "short_period", "dutch_roll"} <= {m.name for m in modes}

# A saved aircraft flies on bit for bit; systems and configuration by name.
aircraft.set(long_stick=0.2)
aircraft.change(scas=1, governor=t.TR_GOVERNOR_PI, flap_deg=20, throttle=(0.4, 0.4))
assert aircraft.systems.scas == 1 and aircraft.configuration.flap_deg == 20
saved = aircraft.save()
aircraft.step(0.005, 20)
flown = bytes(aircraft.state)
again = t.Aircraft().load(saved)
again.step(0.005, 20)
assert bytes(again.state) == flown
full = aircraft.linearize(t.TR_ALL_INPUTS, outputs=True)
assert len(full.u0) == t.TR_INPUTS and full.controls[-1] == "throttle_L" and len(full.states) > 23
near(full.u0[14], math.radians(30), 1e-6)
motion = t.tr_motion()
aircraft.call(t.tr_motion_at, (t.tr_real * 3)(5, 0, 2), motion)
near(sum(q * q for q in motion.quaternion), 1, 1e-5 if single else 1e-12)

refused(t.Error, ["mass 2000 kg", "3000..10000"], t.Aircraft, mass_kg=2000)
refused(t.Error, ["mast angle 95 deg", "0..90"], t.Aircraft, mast_deg=95)
refused(TypeError, ["mas_kg", "did you mean mass_kg"], t.Aircraft, mas_kg=2000)
refused(t.Error, ["aircraft=7"], t.Aircraft, aircraft=7)
refused(t.Error, ["500 m/s", "0..150 m/s"], aircraft.trim, 500)
refused(t.Error, ["trim at 20 m/s", "no trim"], t.Aircraft(mast_deg=90).trim, 20)
refused(t.Error, ["tr_set_controls, long_stick: 20", "range"], aircraft.set, long_stick=20)
refused(t.Error, ["tr_set_controls, pedal", "NaN"], aircraft.set, pedal=math.nan)
refused(TypeError, ["no control long_stik (did you mean long_stick?)"], aircraft.set, long_stik=1)
refused(TypeError, ["did you mean flap_deg"], aircraft.change, flap=1)
refused(TypeError, ["governer (did you mean governor?)", "mass_kg"], aircraft.change, governer=1)
refused(ValueError, ["throttle takes 2 numbers"], aircraft.change, throttle=(1,))
refused(t.Error, ["0.1 s", "0..0.02 s"], aircraft.step, 0.1)
refused(t.Error, ["fast", "0..0.02 s"], aircraft.step, "fast")
refused(TypeError, ["mast_deg takes a number", "'x'"], t.Aircraft, mast_deg="x")
refused(TypeError, ["speed_mps takes a number", "[40, 50]"], aircraft.trim, [40, 50])
refused(TypeError, ["scas takes a whole number"], aircraft.change, scas="on")
refused(TypeError, ["throttle takes numbers, not 1"], aircraft.change, throttle=1)
refused(TypeError, ["throttle takes numbers, not (1, 'x')"], aircraft.change, throttle=(1, "x"))
refused(TypeError, ["aircraft takes a whole number, not 'XV-15'"], t.Aircraft, aircraft="XV-15")
refused(t.Error, ["long_stick=[1, 2]", "a number"], aircraft.set, long_stick=[1, 2])
before = bytes(aircraft.sim)
refused(t.Error, ["flap_deg=700", "flap_deg 700 lies outside 0..75"], aircraft.change, scas=1 - aircraft.systems.scas, flap_deg=700)
assert bytes(aircraft.sim) == before, "half of a refused change stays"
refused(t.Error, ["changed since"], aircraft.load, saved[:-1] + bytes([saved[-1] ^ 1]))
refused(t.Error, ["governor=7", "governor 7 lies outside 0..2"], aircraft.change, governor=7)
refused(t.Error, ["interconnect=2", "lies outside 0..1"], aircraft.change, interconnect=2)
refused(t.Error, ["grid 1..2"], t.Aircraft, grid=9)
refused(t.Error, ["count = -1"], aircraft.step, 0.005, -1)
refused(t.Error, ["load of 3 bytes", "too short"], aircraft.load, b"abc")
refused(TypeError, ["bytes-like"], aircraft.load, "abc")
refused(t.Error, ["linearize", "77", "1..4"], aircraft.linearize, 77)
refused(t.Error, ["linearize", "1.0", "1..4"], aircraft.linearize, 1.0)
refused(t.Error, ["modes: 5 is no model"], aircraft.modes, 5)
refused(TypeError, ["tr_set_state(", "argument 2"], setattr, aircraft, "state", 5)
refused(ctypes.ArgumentError, [], t.tr_step, aircraft.sim, aircraft.work, "fast")
assert bytes(aircraft.state) == flown

# What ctypes would wrap, cut or fill up; whole numbers of any kind are taken.
refused(ValueError, ["grid takes -2147483648..2147483647, not 4294967297"], t.Aircraft, grid=2**32 + 1)
refused(ValueError, ["aircraft takes"], t.Aircraft, aircraft=2**40 + 1)
refused(ValueError, ["turbulence_seed takes 0..18446744073709551615, not -1"], aircraft.change, turbulence_seed=-1)
for gusts in ([1, 2], [1, 2, 3, 4]):
    refused(ValueError, ["gust_mps[0] takes 3 numbers, not"], t.tr_environment().set, gust_mps=[gusts] * 4)
air = t.tr_environment()
t.check(t.tr_default_environment(air))
air.set(gust_mps=[[1, 2, 3]] * 3 + [(4, 5, 6)])
assert list(air.gust_mps[t.TR_AT_TAIL]) == [4, 5, 6]


class Three:
    def __index__(self):
        return 3


aircraft.step(0.005, Three())
assert aircraft.state.steps == 23

# A refused number stands in the sentence, with the range of its field or of the control, as the library has it.
ends = t.Aircraft()
for end in (-1e6, 1e6):
    ends.call(t.tr_saturate_controls, (t.tr_real * t.TR_CONTROLS)(*[end] * t.TR_CONTROLS), t.TR_CONTROLS, t.c_uint32())
    pedal = ends.state.u[t.TR_PEDAL]
    ends.set(pedal=pedal)
    refused(t.Error, [f"pedal: {1.01 * pedal:g}: ", f"{-abs(pedal):.4g}..{abs(pedal):.4g}"], ends.set, pedal=1.01 * pedal)
lost = aircraft.state
lost.x[t.TR_V] = 9999
refused(t.Error, ["tr_set_state, v: 9999: ", "range"], setattr, aircraft, "state", lost)
refused(t.Error, ["tr_set_environment: gust_mps[3][2] -2000 lies outside -"], aircraft.call, t.tr_set_environment,
        air.set(gust_mps=[[0, 0, 0]] * 3 + [[0, 0, -2000]]))
