"""Power required against speed in helicopter mode; a figure trim_curve.svg where matplotlib is installed."""
import tiltrotor

aircraft = tiltrotor.Aircraft(mast_deg=0)
speeds, powers = [0, 10, 20, 30, 40, 50], []
print("speed_mps,power_kw,trim")
for speed in speeds:
    trim = aircraft.trim(speed_mps=speed)
    powers.append(sum(aircraft.outputs.power_w) / 1000)
    print(f"{speed},{powers[-1]:.1f},{trim.word}")
try:
    import matplotlib
except ImportError:
    print("matplotlib is not installed: no figure")
else:
    matplotlib.use("svg")
    from matplotlib import pyplot
    pyplot.plot(speeds, powers)
    pyplot.xlabel("Speed, m/s")
    pyplot.ylabel("Power required, kW")
    pyplot.savefig("trim_curve.svg")
