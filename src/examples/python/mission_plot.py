"""A flight of the program as a table, and as a figure mission_plot.svg where matplotlib is installed:

    tiltrotor fly --script mission.txt --every 1 --format csv --output mission.csv
    python3 mission_plot.py mission.csv"""
import csv
import sys

if len(sys.argv) != 2:
    sys.exit(__doc__)
try:
    with open(sys.argv[1], newline="") as file:
        lines = [line for line in file if not line.startswith("#")]  # as --stamp writes them
except OSError as fault:
    sys.exit(f"{sys.argv[1]}: {fault.strerror}")
rows = [{name: float(text) for name, text in row.items() if text} for row in csv.DictReader(lines)]
missing = {"time_s", "height_m", "airspeed_mps", "mast_deg", "power_1_kw", "power_2_kw"} - (rows or [{}])[0].keys()
if missing:
    sys.exit(f"{sys.argv[1]}: no column {', '.join(sorted(missing))}")

time = [row["time_s"] for row in rows]
curves = [("Height, m", [row["height_m"] for row in rows]),
          ("Airspeed, m/s", [row["airspeed_mps"] for row in rows]),
          ("Mast angle, deg", [row["mast_deg"] for row in rows]),
          ("Engine power, kW", [row["power_1_kw"] + row["power_2_kw"] for row in rows])]
print("Time, s", *(name for name, _ in curves), sep="; ")
for k in range(0, len(rows), max(1, len(rows) // 20)):
    print(f"{time[k]:g}", *(f"{values[k]:.1f}" for _, values in curves), sep="; ")
try:
    import matplotlib
except ImportError:
    print("matplotlib is not installed: no figure")
else:
    matplotlib.use("svg")
    from matplotlib import pyplot
    figure, panels = pyplot.subplots(len(curves), sharex=True, figsize=(9, 9))
    for panel, (name, values) in zip(panels, curves):
        panel.plot(time, values)
        panel.set_ylabel(name)
        panel.grid(True)
    panels[-1].set_xlabel("Time, s")
    figure.savefig("mission_plot.svg", bbox_inches="tight")
