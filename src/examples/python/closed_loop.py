"""The nonlinear aircraft with stability augmentation of your own: pitch and roll are held after a push on the stick."""
import tiltrotor

aircraft = tiltrotor.Aircraft(mast_deg=30)
aircraft.trim(speed_mps=50)
trim = aircraft.state
print("time_s,pitch_rad,roll_rad,speed_mps")
for frame in range(2000):
    x = aircraft.state.x
    push = 0.3 if 100 <= frame < 200 else 0.0  # in
    pitch = 8 * (x[tiltrotor.TR_PITCH] - trim.x[tiltrotor.TR_PITCH]) + 6 * x[tiltrotor.TR_Q]
    roll = -4 * (x[tiltrotor.TR_ROLL] - trim.x[tiltrotor.TR_ROLL]) - 2 * x[tiltrotor.TR_P]
    aircraft.set(long_stick=trim.u[tiltrotor.TR_LONG_STICK] + push + pitch,
                 lat_stick=trim.u[tiltrotor.TR_LAT_STICK] + roll)
    if frame % 200 == 0:
        print(f"{frame * 0.005:g},{x[tiltrotor.TR_PITCH]:.4f},{x[tiltrotor.TR_ROLL]:.4f},{x[tiltrotor.TR_U]:.2f}")
    aircraft.step(0.005)
