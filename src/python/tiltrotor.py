"""tiltrotor: flight dynamics of a tilt-rotor aircraft, from Python.

    import tiltrotor
    aircraft = tiltrotor.Aircraft(mast_deg=30)
    print(aircraft.trim(speed_mps=40).text)
    model = aircraft.linearize()          # model.A, model.B, model.states, model.controls, ...
    for mode in aircraft.modes(): print(mode)
    aircraft.step(0.005)

Aircraft is the comfortable way. Below it lies the whole C interface: structures with the fields of the headers,
constants under their names, and the functions tr_NAME, whose docstring is their declaration; units, ranges, statuses and
costs stand in include/tiltrotor/*.h. SI and radians unless a name says otherwise; body axes x forward, y right, z down;
right rotor first. Needs nothing but ctypes; matrices are arrays of numpy where numpy is installed, else lists of rows.
The library is the one that TILTROTOR_LIBRARY names, that of the prefix or tree in which this file lies, or the system's.
Of a library in single precision tr_real is float."""

import collections
import ctypes.util
import difflib
import math
import numbers
import operator
import os
import re
from ctypes import c_char, c_double, c_int32, c_uint32, c_uint64

try:
    import numpy
except ImportError:
    numpy = None

# ---- the library ----
_INTERFACE = 7
_NAMES = (f"libtiltrotor.so.{_INTERFACE}", "libtiltrotor.so", "libtiltrotor.dylib", "libtiltrotor.dll")

def _load():
    here = os.path.dirname(os.path.abspath(__file__))
    places = [os.path.join(here, *up) for up in ((os.pardir,), (os.pardir, os.pardir, "build"), ())]
    named = os.environ.get("TILTROTOR_LIBRARY")
    paths = [named] if named else [os.path.join(place, name) for place in places for name in _NAMES]
    paths = [path for path in paths if named or os.path.exists(path)] or [_NAMES[0], ctypes.util.find_library("tiltrotor")]
    reasons = []
    for path in filter(None, paths):
        try:
            return ctypes.CDLL(path)
        except OSError as reason:
            reasons.append(str(reason))
    raise ImportError("tiltrotor: no shared library: " + "; ".join(reasons) + "; set TILTROTOR_LIBRARY to its path")

_library = _load()
_single = not hasattr(_library, "tr_init")
if _single and not hasattr(_library, "tr_init_single"):
    raise ImportError(f"tiltrotor: {_library._name} is no library of tiltrotor")
tr_real = ctypes.c_float if _single else ctypes.c_double

# ---- constants ----
TR_API_VERSION = 0x00070004 if _single else 0x00070008
TR_SIM_SIZE = 3968 if _single else 7424  # bytes
TR_WORK_SIZE = 135168 if _single else 245760
TR_HASH_START = 14695981039346656037
(TR_SAVED_SIZE, TR_MOST_LOADS) = (2048, 8)
# tr_status
(TR_OK, TR_NOT_CONVERGED, TR_SINGULAR, TR_NOT_FINITE, TR_OUT_OF_RANGE, TR_BAD_ARGUMENT, TR_SHORT_BUFFER, TR_WRONG_VERSION, TR_NOT_INITIALIZED, TR_WING_STALL,
 TR_CONTROL_LIMIT, TR_FLAP_LIMIT, TR_ROTOR_STALL, TR_DAMAGED, TR_BAD_ARITHMETIC, TR_VORTEX_RING_STATE, TR_POWER_LIMIT, TR_TORQUE_LIMIT, TR_STATUS_COUNT) = range(0, 19)
# tr_aircraft, tr_grid, tr_tables, tr_columns, tr_governor and tr_wind_shear
(TR_XV15, TR_SCALED_XV15) = range(1, 3)
(TR_GRID_REALTIME, TR_GRID_SPECIFICATION) = range(1, 3)
(TR_TABLES_SMOOTH, TR_TABLES_LINEAR) = range(1, 3)
(TR_INCEPTORS, TR_BLADE_CONTROLS, TR_ALL_CONTROLS, TR_ALL_INPUTS) = range(1, 5)
(TR_GOVERNOR_OFF, TR_GOVERNOR_IDEAL, TR_GOVERNOR_PI) = range(0, 3)
(TR_SHEAR_NONE, TR_SHEAR_TERMINAL, TR_SHEAR_OTHER) = range(0, 3)
# places in tr_state.x
(TR_U, TR_V, TR_W, TR_P, TR_Q, TR_R, TR_ROLL, TR_PITCH, TR_YAW, TR_ROTOR_RIGHT) = range(0, 10)
(TR_B1C, TR_B1S, TR_B1C_RATE, TR_B1S_RATE, TR_MEAN_INFLOW, TR_COSINE_INFLOW, TR_SINE_INFLOW) = range(0, 7)
(TR_ROTOR_LEFT, TR_DOWNWASH, TR_CONING_RIGHT, TR_CONING_LEFT) = (16, 23, 24, 26)
(TR_NORTH, TR_EAST, TR_DOWN, TR_MAST, TR_MAST_RATE, TR_FLAP, TR_ROTOR_SPEED, TR_SHAFT_TWIST, TR_TWIST_RATE,
 TR_POWER_RIGHT, TR_POWER_LEFT, TR_GOVERNOR, TR_FUEL, TR_ACTUATORS) = range(28, 42)
TR_SERIES_ACTUATORS = 48
(TR_WASHOUT, TR_HELD_PITCH, TR_HELD_ROLL, TR_HOLDS_PITCH, TR_HOLDS_ROLL, TR_REST_LONG, TR_REST_LAT, TR_GEAR, TR_GUST_FILTERS) = range(51, 60)
(TR_STATES, TR_MAX_LINEAR_STATES) = (75, 48)
# places in tr_state.u, of air, of tr_get_flags
(TR_COLLECTIVE, TR_LONG_STICK, TR_LAT_STICK, TR_PEDAL, TR_LONG_CYCLIC, TR_DIFF_COLLECTIVE, TR_DIFF_LONG_CYCLIC, TR_ELEVATOR,
 TR_AILERON, TR_RUDDER, TR_LATERAL_CYCLIC, TR_GUST_U, TR_GUST_V, TR_GUST_W, TR_CONTROLS) = range(0, 15)
(TR_INPUTS, TR_OUTPUTS) = (19, 23)
(TR_AT_RIGHT_ROTOR, TR_AT_LEFT_ROTOR, TR_AT_WING, TR_AT_TAIL, TR_PLACES) = range(0, 5)
(TR_SATURATED, TR_AT_GIMBAL_STOP, TR_OVER_POWER, TR_OVER_TORQUE, TR_TABLE_EDGE, TR_VORTEX_RING, TR_ON_GROUND, TR_BELOW_GROUND) = (1, 2, 4, 8, 16, 32, 64, 128)

# ---- structures, fields as the headers declare them ----
_WORDS = {"char": c_char, "void*": ctypes.c_void_p, "char*": ctypes.c_char_p, "size_t": ctypes.c_size_t, "int32_t": c_int32,
          "uint32_t": c_uint32, "tr_status": c_int32, "tr_real": tr_real, "double": c_double, "uint64_t": c_uint64}
_WHOLE = (c_int32, c_uint32, c_uint64, ctypes.c_size_t)

def _type(declared):
    words = declared.replace("const ", "").strip()
    known = _WORDS.get(words) or globals().get(words)
    return known or ctypes.POINTER(_type(words[:-1]))

def _fields(declared):
    fields = []
    for line in declared.split(";"):
        kind, _, names = line.strip().partition(" ")
        for name, sizes in re.findall(r"(\w+)((?:\[[^]]*\])*)", names):
            of = _type(kind)
            for size in reversed(re.findall(r"\[([^]]*)\]", sizes)):
                of = of * eval(size.replace("/", "//"), globals())
            fields.append((name, of))
    return fields

def _plain(value):
    return [_plain(item) for item in value] if isinstance(value, ctypes.Array) else value

def _known(given, names, refusal):
    for name in (name for name in given if name not in names):
        near = difflib.get_close_matches(name, names, 1)
        raise TypeError(f"{refusal} {name}" + (f" (did you mean {near[0]}?)" if near else "") + "; there are " + ", ".join(names))

def _fitting(name, of, value):
    """The value as a field of that type holds it: ctypes itself would wrap what is too large and fill up what is too short."""
    whole, array = of in _WHOLE, issubclass(of, ctypes.Array) and of._type_ is not c_char
    try:
        if array and len(value) != of._length_:
            raise ValueError(f"{name} takes {of._length_} numbers, not {len(value)}")
        if array:
            return of(*(_fitting(f"{name}[{k}]", of._type_, item) for k, item in enumerate(value)))
        held = of(operator.index(value)).value if whole else of(value).value if of in (tr_real, c_double) else value
    except (TypeError, OverflowError):
        raise TypeError(f"{name} takes {'a whole number' if whole else 'numbers' if array else 'a number'}, not {value!r}") from None
    if whole and held != value:
        raise ValueError(f"{name} takes {'-2147483648..2147483647' if of is c_int32 else f'0..{of(-1).value}'}, not {value}")
    return held

class _Structure(ctypes.Structure):
    def __repr__(self):
        return f"{type(self).__name__}({', '.join(f'{n}={_plain(getattr(self, n))}' for n, *_ in self._fields_)})"

    def set(self, **values):
        """Fields by name, arrays from any sequence of their length. Returns itself."""
        types = dict(self._fields_)
        _known(values, types, f"{type(self).__name__} has no")
        for name, value in [(name, _fitting(name, types[name], value)) for name, value in values.items()]:
            setattr(self, name, value)
        return self

def _structure(name, doc, fields):
    return type(name, (_Structure,), {"__doc__": f"{doc}\n\n{fields}", "_fields_": _fields(fields)})

tr_sim = _structure("tr_sim", "The aircraft, opaque: a copy of it is a snapshot.", "uint64_t reserved[TR_SIM_SIZE / 8]")
tr_work = _structure("tr_work", "Scratch of the calls that name it.", "uint64_t reserved[TR_WORK_SIZE / 8]")
tr_setup = _structure("tr_setup", "What a flight begins with: grid 1..2 (tr_grid), tables 1..2 (tr_tables), coning_states 0..1; tr_check_setup says the ranges.",
    "int32_t aircraft, grid, tables, coning_states; tr_real mast_deg, flap_deg, altitude_m, mass_kg, rotor_radps, cg_station_m")
tr_state = _structure("tr_state", "The state of a flight: x and u in the order of the constants TR_U..., TR_COLLECTIVE...; SI, inceptors in inches.",
    "double time_s; uint64_t steps; tr_real x[TR_STATES], u[TR_CONTROLS]; double roll_rad, yaw_rad, position_m[3]")
tr_outputs = _structure("tr_outputs", "What instruments read; airspeed and angles relative to the air, specific force what an accelerometer reads.",
    "double time_s; tr_real airspeed_mps, angle_of_attack_rad, sideslip_rad, specific_force_mps2[3], load_factor, climb_rate_mps, thrust_n[2], "
    "torque_nm[2], power_w[2], collective_rad[2], long_cyclic_rad[2], gimbal_tilt_rad[2], elevator_rad, aileron_rad, rudder_rad")
tr_flight = _structure("tr_flight", "Steady flight: speed 0..150 m/s, climb within 90 deg, turn rate and sideslip within 60 deg(/s), in radians.", "tr_real speed_mps, climb_rad, turn_rate_radps, sideslip_rad")
tr_trim_result = _structure("tr_trim_result", "How a trim ended, in a sentence; residual in accelerations over gravity.", "int32_t iterations, attempts; tr_real residual; char text[160]")
tr_linear_shape = _structure("tr_linear_shape", "Rows and columns of A and B: places in tr_state.x and tr_state.u, from TR_CONTROLS on commands of systems.",
    "int32_t states, controls, state[TR_MAX_LINEAR_STATES], control[TR_INPUTS]")
tr_mode = _structure("tr_mode", "Eigenvalue in 1/s, imag >= 0; time_to_half_s is negative where it is one to double.", "tr_real real, imag, frequency_radps, damping_ratio, time_to_half_s; char name[32]")
tr_configuration = _structure("tr_configuration", "Now: mast_deg 0..90, rate within 1 rad/s, acceleration 10; flap_deg 0..75; rotor_radps 20..80, acceleration within 50; mass_kg 3000..10000; cg_station_m 7..8, cg_waterline_m 1.5..2.5.",
    "tr_real mast_deg, mast_rate_radps, mast_acceleration_radps2, flap_deg, rotor_radps, rotor_acceleration_radps2, mass_kg, cg_station_m, cg_waterline_m")
tr_environment = _structure("tr_environment", "Air and ground: wind north east down, gusts in body axes by place.",
    "tr_real wind_mps[3], gust_mps[TR_PLACES][3], gust_rates_radps[3], altitude_origin_m, temperature_offset_k, pressure_ratio, ground_down_m")
tr_load = _structure("tr_load", "A load from outside, at a station aft, right, up; force and moment in body axes.", "tr_real station_m[3], force_n[3], moment_nm[3]")
tr_fault = _structure("tr_fault", "What the last failing call found; state and control are places, -1: none.", "int32_t status, state, control; double time_s")
tr_mass = _structure("tr_mass", "At the present mast angle; inertia xx yy zz xz about the centre of gravity.", "tr_real mass_kg, cg_m[3], inertia_kgm2[4]")
tr_motion = _structure("tr_motion", "Of a point of the airframe: what an inertial unit there has; quaternion scalar first, earth to body.",
    "tr_real position_m[3], velocity_ned_mps[3], velocity_air_mps[3], specific_force_mps2[3], rates_radps[3], acceleration_radps2[3], quaternion[4]")
tr_air_data = _structure("tr_air_data", "What an air data probe without errors reads.", "tr_real static_pa, impact_pa, tas_mps, cas_mps, mach, alpha_rad, beta_rad")
tr_systems = _structure("tr_systems", "Systems around the airframe: switches 0 or 1, governor 0..2 (tr_governor), wind_shear 0..2 (tr_wind_shear); mast_command_deg 0..90, flap_command_deg 0..75, rotor_command_radps 20..80, throttle 0..1.2, turbulence_w20_mps 0..50, brake 0..1.",
    "int32_t governor, conversion, engines, actuators, scas, gear, ground_effect, turbulence, interconnect, wind_shear; "
    "tr_real mast_command_deg, flap_command_deg, rotor_command_radps, throttle[2]; int32_t gear_down, engine_failed[2]; uint64_t turbulence_seed; tr_real turbulence_w20_mps, brake[2]")
tr_geodetic = _structure("tr_geodetic", "On the ellipsoid WGS-84.", "double latitude_rad, longitude_rad, height_m")
tr_lag = _structure("tr_lag", "A first-order lag: reading' = (input - reading) / time constant.", "tr_real time_constant_s, reading, input; int32_t begun")
tr_imu = _structure("tr_imu", "Inertial unit with lags, at a station aft, right, up.", "tr_real station_m[3]; tr_lag specific_force_mps2[3], rates_radps[3]")
tr_air_probe = _structure("tr_air_probe", "Air data probe with lags, at a station aft, right, up.", "tr_real station_m[3]; tr_lag static_pa, impact_pa, alpha_rad, beta_rad")

# ---- functions, as the headers declare them ----
_DECLARATIONS = """
tr_status tr_default_setup(tr_setup* setup, uint32_t version, int32_t aircraft, tr_real mast_deg);
tr_status tr_check_setup(const tr_setup* setup, uint32_t version, char* text, size_t length);
int32_t tr_aircraft_at(int32_t place);
const char* tr_aircraft_name(int32_t aircraft);
const char* tr_aircraft_description(int32_t aircraft);
tr_status tr_init(tr_sim* sim, uint32_t version, const tr_setup* setup);
size_t tr_sim_size(void);
size_t tr_work_size(void);
tr_status tr_set_controls(tr_sim* sim, const tr_real* controls, size_t length);
tr_status tr_step(tr_sim* sim, tr_work* work, tr_real dt);
tr_status tr_get_state(const tr_sim* sim, tr_state* state);
tr_status tr_set_state(tr_sim* sim, const tr_state* state);
tr_status tr_save(const tr_sim* sim, void* bytes, size_t length, size_t* used);
tr_status tr_load_saved(tr_sim* sim, uint32_t version, const void* bytes, size_t length);
tr_status tr_derivative(const tr_sim* sim, tr_real* rates, size_t length);
tr_status tr_get_outputs(const tr_sim* sim, tr_outputs* outputs);
tr_status tr_trim(tr_sim* sim, tr_work* work, const tr_flight* flight, tr_trim_result* result);
tr_status tr_linearize(const tr_sim* sim, tr_work* work, int32_t columns, tr_linear_shape* shape, tr_real* a, size_t a_length, tr_real* b, size_t b_length);
tr_status tr_linearize_and_step(tr_sim* sim, tr_work* work, tr_real dt, int32_t columns, tr_linear_shape* shape, tr_real* a, size_t a_length, tr_real* b, size_t b_length);
tr_status tr_eigenvalues(tr_work* work, const tr_real* a, size_t n, tr_real* real, tr_real* imag, size_t length);
tr_status tr_modes(tr_work* work, const tr_linear_shape* shape, const tr_real* a, size_t a_length, tr_mode* modes, size_t capacity, size_t* count);
const char* tr_status_word(int32_t status);
const char* tr_status_text(int32_t status);
const char* tr_state_name(int32_t index);
const char* tr_state_unit(int32_t index);
const char* tr_control_name(int32_t index);
const char* tr_control_unit(int32_t index);
const char* tr_version(void);
tr_status tr_hash(const tr_real* numbers, size_t length, uint64_t* hash);
tr_status tr_get_configuration(const tr_sim* sim, tr_configuration* configuration);
tr_status tr_set_configuration(tr_sim* sim, const tr_configuration* configuration);
tr_status tr_default_environment(tr_environment* environment);
tr_status tr_set_environment(tr_sim* sim, const tr_environment* environment);
tr_status tr_set_loads(tr_sim* sim, const tr_load* loads, size_t count);
tr_status tr_step_with_outputs(tr_sim* sim, tr_work* work, tr_real dt, tr_outputs* outputs);
tr_status tr_saturate_controls(tr_sim* sim, const tr_real* controls, size_t length, uint32_t* clipped);
tr_status tr_last_fault(const tr_sim* sim, tr_fault* fault);
tr_status tr_get_flags(const tr_sim* sim, uint32_t* flags);
tr_status tr_get_mass(const tr_sim* sim, tr_mass* mass);
tr_status tr_motion_at(const tr_sim* sim, const tr_real station_m[3], tr_motion* motion);
tr_status tr_air_data_at(const tr_sim* sim, const tr_real station_m[3], tr_air_data* air);
tr_status tr_directional(const tr_sim* sim, tr_work* work, const tr_real* dx, const tr_real* du, tr_real* dxdot, tr_outputs* doutputs);
tr_status tr_linearize_outputs(const tr_sim* sim, tr_work* work, int32_t columns, tr_real* c, size_t c_length, tr_real* d, size_t d_length);
tr_status tr_rigid_model(tr_work* work, const tr_linear_shape* shape, const tr_real* a, size_t a_length, const tr_real* b, size_t b_length, tr_linear_shape* reduced_shape, tr_real* reduced_a, size_t reduced_a_length, tr_real* reduced_b, size_t reduced_b_length);
tr_status tr_linearize_and_step_exponential(tr_sim* sim, tr_work* work, tr_real dt, const tr_real* control_rates, int32_t columns, tr_linear_shape* shape, tr_real* a, size_t a_length, tr_real* b, size_t b_length);
tr_status tr_default_systems(tr_systems* systems);
tr_status tr_get_systems(const tr_sim* sim, tr_systems* systems);
tr_status tr_set_systems(tr_sim* sim, const tr_systems* systems);
tr_status tr_check_systems(const tr_systems* systems, uint32_t version, char* text, size_t length);
tr_status tr_check_environment(const tr_environment* environment, uint32_t version, char* text, size_t length);
tr_status tr_check_configuration(const tr_configuration* configuration, uint32_t version, char* text, size_t length);
tr_status tr_get_range(const char* name, tr_real* low, tr_real* high);
tr_status tr_directional_inputs(const tr_sim* sim, tr_work* work, const tr_real* dx, const tr_real* du, tr_real* dxdot, tr_outputs* doutputs);
tr_status tr_geodetic_at(const tr_geodetic* origin, const double position_m[3], tr_geodetic* place);
tr_status tr_radio_height_at(const tr_sim* sim, const tr_real station_m[3], tr_real* height_m);
tr_status tr_wheel_heights(const tr_sim* sim, const tr_real* dx, tr_real height_m[3], tr_real dheight_m[3]);
tr_status tr_step_lag(tr_lag* lag, tr_real input, tr_real dt_s);
tr_status tr_read_imu(const tr_sim* sim, tr_imu* imu, tr_real dt_s);
tr_status tr_read_air_probe(const tr_sim* sim, tr_air_probe* probe, tr_real dt_s, tr_air_data* indicated);
"""

def _functions():
    for result, name, inside in re.findall(r"^([\w *]+?) ?(tr_\w+)\(([^;]*)\);", _DECLARATIONS, re.M):
        function = getattr(_library, name + ("_single" if _single else ""))
        arguments = [] if inside == "void" else [" ".join(word.split()) for word in inside.split(",")]
        types = [re.sub(r"^(.*) \w+\[\d+\]$", r"\1*", word) for word in arguments]
        function.argtypes = [_type(re.sub(r" ?\w+$", "", word) if word[-1] != "*" else word) for word in types]
        function.restype = _type(result)
        function.__doc__ = f"{result} {name}({', '.join(arguments)})"
        globals()[name] = function

_functions()
# ---- the comfortable way ----
class Error(Exception):
    """What the library says of a failed call; `status` is its tr_status, `word` that in a word."""

    def __init__(self, status, what, detail=""):
        self.status, self.word = status, tr_status_word(status).decode()
        super().__init__(f"{what}: {detail or tr_status_text(status).decode()}")

def check(status, what="tiltrotor", detail=""):
    """Raises Error unless the status is TR_OK."""
    if status != TR_OK:
        raise Error(status, what, detail)

# Of trim(): TR_OK or the limit that is exceeded. Of modes(): eigenvalue in 1/s, imag >= 0. Of linearize(): xdot = A (x - x0)
# + B (u - u0), y = y0 + C (x - x0) + D (u - u0), y the numbers of tr_outputs after time_s.
Trim = collections.namedtuple("Trim", "status word text iterations residual")
Mode = collections.namedtuple("Mode", "name eigenvalue frequency_radps damping_ratio time_to_half_s")
Linear = collections.namedtuple("Linear", "A B states controls state_units control_units x0 u0 C D y0 shape flat_a")
_TRIMMED = (TR_OK, TR_WING_STALL, TR_CONTROL_LIMIT, TR_FLAP_LIMIT, TR_VORTEX_RING_STATE, TR_POWER_LIMIT, TR_TORQUE_LIMIT)

def _vector(values):
    return numpy.array(values, float) if numpy else list(values)

def _matrix(flat, rows):
    return _vector(flat).reshape(rows, -1) if numpy else [list(row) for row in zip(*[iter(flat)] * (len(flat) // rows))]

class Aircraft:
    """An aircraft in flight. Arguments are fields of tr_setup: Aircraft(mast_deg=30, mass_kg=5500, altitude_m=1000)."""

    def __init__(self, mast_deg=0.0, aircraft=TR_XV15, **setup):
        self.setup, self.sim, self.work, text = tr_setup(), tr_sim(), tr_work(), ctypes.create_string_buffer(160)
        wanted = tr_setup().set(aircraft=aircraft, mast_deg=mast_deg)
        check(tr_default_setup(self.setup, TR_API_VERSION, wanted.aircraft, 0), f"aircraft={aircraft}", f"there is {tr_aircraft_at(0)} alone")
        tr_default_setup(self.setup, TR_API_VERSION, wanted.aircraft, wanted.mast_deg)  # of a mast angle out of range tr_check_setup tells
        status = tr_check_setup(self.setup.set(mast_deg=mast_deg, **setup), TR_API_VERSION, text, len(text))
        check(status, "setup", text.value.decode() or tr_setup.__doc__.split("\n")[0])
        check(tr_init(self.sim, TR_API_VERSION, self.setup))

    def call(self, function, *arguments):
        """function(sim, ...), any of those that take the aircraft first; Error says which state or control is to blame."""
        fault, text, called = tr_fault(), ctypes.create_string_buffer(160), function.__name__.replace("_single", "")
        try:
            status = function(self.sim, *arguments)
        except ctypes.ArgumentError as wrong:
            raise TypeError(f"{wrong}, of {function.__doc__}") from None
        records = status != TR_OK and re.match("tr_(step|linearize_and_step|saturate_controls|set_controls|set_state)", called)
        if records and tr_last_fault(self.sim, fault) == TR_OK and fault.status == status and max(fault.state, fault.control) >= 0:
            name = (tr_state_name(fault.state) if fault.state >= 0 else tr_control_name(fault.control)).decode()
            raise Error(status, f"{called}, {name}", called in ("tr_set_controls", "tr_set_state") and self._refused(name, fault, arguments[0]))
        if status != TR_OK and called in ("tr_set_systems", "tr_set_environment", "tr_set_configuration"):  # which field, and its range
            globals()[called.replace("set", "check", 1)](arguments[0], TR_API_VERSION, text, len(text))
        check(status, called, text.value.decode())

    def _refused(self, name, fault, given):
        """The number that was refused, and its range."""
        value = given.x[fault.state] if fault.state >= 0 else getattr(given, "u", given)[fault.control]
        tr_get_range(f"{'x' if fault.state >= 0 else 'u'}.{name}".encode(), ctypes.byref(low := tr_real()), ctypes.byref(high := tr_real()))
        return f"{value:g}: {tr_status_text(fault.status).decode()} {low.value:.4g}..{high.value:.4g}"

    def get(self, function, structure):
        """What a function writes into a structure: get(tr_get_outputs, tr_outputs)."""
        found = structure()
        self.call(function, found)
        return found

    def trim(self, speed_mps=0.0, climb_rad=0.0, turn_rate_radps=0.0, sideslip_rad=0.0):
        """Steady flight; a limit may be exceeded, which the Trim says. Error with the reason where there is none."""
        flight, r = tr_flight(), tr_trim_result()
        flight.set(speed_mps=speed_mps, climb_rad=climb_rad, turn_rate_radps=turn_rate_radps, sideslip_rad=sideslip_rad)
        status = tr_trim(self.sim, self.work, flight, r)
        check(TR_OK if status in _TRIMMED else status, f"trim at {speed_mps} m/s", r.text.decode())
        return Trim(status, tr_status_word(status).decode(), r.text.decode(), r.iterations, r.residual)

    def step(self, dt=0.005, count=1):
        """So many steps of dt, 0..0.02 s, controls held."""
        check(TR_OK if isinstance(dt, numbers.Real) and 0 < dt <= 0.02 else TR_OUT_OF_RANGE, "step", f"dt = {dt} s lies outside 0..0.02 s")
        check(TR_OK if hasattr(count, "__index__") and operator.index(count) >= 0 else TR_BAD_ARGUMENT, "step", f"count = {count} is no whole number of 0 or more")
        for _ in range(operator.index(count)):
            self.call(tr_step, self.work, dt)

    def linearize(self, columns=TR_INCEPTORS, outputs=False):
        """Exact A and B here; with `outputs` also C and D. Columns: a tr_columns."""
        check(TR_OK if hasattr(columns, "__index__") and columns in (1, 2, 3, 4) else TR_BAD_ARGUMENT, "linearize", f"columns={columns!r} is none of 1..4 (tr_columns)")
        shape, state, y, c, d = tr_linear_shape(), self.state, None, None, None
        tr_linearize(self.sim, self.work, columns, shape, None, 0, None, 0)
        n, m = shape.states, shape.controls
        a, b = (tr_real * (n * n))(), (tr_real * (n * m))()
        self.call(tr_linearize, self.work, columns, shape, a, len(a), b, len(b))
        if outputs:
            c, d = (tr_real * (TR_OUTPUTS * n))(), (tr_real * (TR_OUTPUTS * m))()
            self.call(tr_linearize_outputs, self.work, columns, c, len(c), d, len(d))
            y = _vector((tr_real * TR_OUTPUTS).from_buffer(self.outputs, tr_outputs.airspeed_mps.offset))
            c, d = _matrix(c, TR_OUTPUTS), _matrix(d, TR_OUTPUTS)
        rows, inputs, s = shape.state[:n], shape.control[:m], self.systems
        commands = [math.radians(s.mast_command_deg), math.radians(s.flap_command_deg), s.rotor_command_radps, *s.throttle]
        words = [[of(k).decode() for k in places] for of, places in (
            (tr_state_name, rows), (tr_control_name, inputs), (tr_state_unit, rows), (tr_control_unit, inputs))]
        return Linear(_matrix(a, n), _matrix(b, n), *words, _vector([state.x[k] for k in rows]),
                      _vector([(list(state.u) + commands)[k] for k in inputs]), c, d, y, shape, a)

    def modes(self, model=None):
        """Modes of a model of linearize(), of the present one by default; longitudinal ones first."""
        check(TR_OK if isinstance(model, (Linear, type(None))) else TR_BAD_ARGUMENT, "modes", f"{model!r} is no model of linearize()")
        model, count, found = model or self.linearize(), ctypes.c_size_t(), (tr_mode * TR_MAX_LINEAR_STATES)()
        check(tr_modes(self.work, model.shape, model.flat_a, len(model.flat_a), found, len(found), count), "modes")
        return [Mode(m.name.decode(), complex(m.real, m.imag), m.frequency_radps, m.damping_ratio, m.time_to_half_s)
                for m in found[:count.value]]

    def set(self, **controls):
        """Controls by name, which tr_control_name lists: set(long_stick=0.2). The others keep their value."""
        names = [tr_control_name(k).decode() for k in range(TR_CONTROLS)]
        _known(controls, names, "no control")
        u = dict(zip(names, self.state.u), **controls)
        wrong = [f"{name}={value!r}" for name, value in controls.items() if not isinstance(value, numbers.Real)]
        check(TR_BAD_ARGUMENT if wrong else TR_OK, "set", ", ".join(wrong) + ": each takes a number")
        self.call(tr_set_controls, (tr_real * TR_CONTROLS)(*u.values()), TR_CONTROLS)

    def change(self, **fields):
        """Fields of tr_configuration or tr_systems by name, in force from now on: change(scas=1, flap_deg=20). All or none."""
        parts, before = ((tr_set_systems, self.systems), (tr_set_configuration, self.configuration)), tr_sim.from_buffer_copy(self.sim)
        part_of = {name: part for part in parts for name, *_ in part[1]._fields_}
        _known(fields, part_of, "neither tr_systems nor tr_configuration has")
        for name, value in fields.items():
            part_of[name][1].set(**{name: value})
        try:
            for part in (part for part in parts if part in map(part_of.get, fields)):
                self.call(*part)
        except Error as error:
            self.sim = before
            raise Error(error.status, f"change({', '.join(f'{name}={value}' for name, value in fields.items())})", error) from None

    def save(self):
        """The whole aircraft as bytes, for files and other machines."""
        saved, used = ctypes.create_string_buffer(TR_SAVED_SIZE), ctypes.c_size_t()
        self.call(tr_save, saved, len(saved), used)
        return saved.raw[:used.value]

    def load(self, saved):
        """Becomes the aircraft that was saved, and flies on bit for bit."""
        check(tr_load_saved(self.sim, TR_API_VERSION, bytes(memoryview(saved)), len(saved)), f"load of {len(saved)} bytes")
        return self

    state = property(lambda self: self.get(tr_get_state, tr_state), lambda self, value: self.call(tr_set_state, value), doc="Snapshot and restore: tr_state.")
    outputs = property(lambda self: self.get(tr_get_outputs, tr_outputs), doc="What instruments read now: tr_outputs.")
    systems = property(lambda self: self.get(tr_get_systems, tr_systems), doc="Switches and commands: tr_systems.")
    configuration = property(lambda self: self.get(tr_get_configuration, tr_configuration), doc="tr_configuration, as now.")
