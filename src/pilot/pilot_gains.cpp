#include "pilot/pilot_gains.hpp"

#include <cmath>
#include <memory>

namespace tiltrotor::pilot {

namespace {

// Places in the model of the body alone (kRigidOrder) and in kInceptors.
enum Place { u, w, q, theta, v, p, phi, r };
enum Lever { collective, long_stick, lat_stick, pedal };

// One half: outputs that are free, the attitude and its rate, the stick that holds it and the lever beside.
struct Half {
  Place free[2], rate, attitude;
  Lever stick, lever;
};
constexpr Half kLongitudinal{{u, w}, q, theta, long_stick, collective};
constexpr Half kLateral{{v, r}, p, phi, lat_stick, pedal};

bool has_inceptors(const LinearModel<double>& model) {
  if (model.controls != kInceptors.count || model.states < kRigidStates) return false;
  for (int j = collective + 1; j < kInceptors.count; ++j)
    if (model.control[j] != kInceptors.index[j]) return false;
  return true;
}

// stick = angle (wanted - attitude) - rate * (its rate): angular acceleration bandwidth^2 and 2 damping bandwidth.
// Damping that the aircraft has is not added again, nor taken away.
AttitudeGains attitude_gains(const LinearModel<double>& body, const Half& half, const PilotRule& rule) {
  const double effect = body.b(half.rate, half.stick);
  const double own = -body.a(half.rate, half.rate);
  const double angle = rule.attitude * rule.attitude / effect;
  return {angle, std::fmax(2 * rule.damping * rule.attitude - own, 0) / effect, rule.attitude_lag * angle};
}

// Response of two outputs and of the stick to attitude and lever at a real s, the stick holding the attitude:
//   s x = A_xx x + B_stick stick + (A_attitude + s A_rate) attitude + B_lever lever,   and of the rate: s^2 attitude.
// Rows 0 and 1: outputs, 2: stick; columns: attitude, lever.
using Response = Matrix<double, 3, 2>;

Status held_response(const LinearModel<double>& body, const Half& half, double s, Response& response) {
  Matrix<double, 3, 3> system{};
  Response drive{};
  const Place rows[3] = {half.free[0], half.free[1], half.rate};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 2; ++j) system(i, j) = (i == j ? s : 0) - body.a(rows[i], half.free[j]);
    system(i, 2) = -body.b(rows[i], half.stick);
    drive(i, 0) = body.a(rows[i], half.attitude) + s * body.a(rows[i], half.rate) - (i == 2 ? s * s : 0);
    drive(i, 1) = body.b(rows[i], half.lever);
  }
  LU<double, 3> lu{};
  const Status status = lu_factor(system, 3, lu);
  return status == Status::ok ? lu_solve(lu, drive, 2, response) : status;
}

// Forward speed and climb, in level flight, in place of the speeds along the axes.
void level(const PilotGains& gains, Response& response) {
  const double cosine = std::cos(gains.pitch), sine = std::sin(gains.pitch);
  for (int j = 0; j < 2; ++j) {
    const double along_x = response(0, j), along_z = response(1, j);
    response(0, j) = cosine * along_x + sine * along_z;
    response(1, j) = sine * along_x - cosine * along_z + (j == 0 ? gains.speed : 0);
  }
}

Status invert(const LinearModel<double>& body, const PilotGains& gains, const Half& half, double s,
              Inverse& inverse) {
  Response y{};
  const Status status = held_response(body, half, s, y);
  if (status != Status::ok) return status;
  if (half.attitude == theta) level(gains, y);
  const double determinant = y(0, 0) * y(1, 1) - y(0, 1) * y(1, 0);
  if (!(std::fabs(determinant) > 0)) return Status::singular;
  inverse = {
      {y(1, 1) / determinant, -y(0, 1) / determinant}, {}, {-y(1, 0) / determinant, y(0, 0) / determinant}};
  for (int i = 0; i < 2; ++i) inverse.stick[i] = y(2, 0) * inverse.attitude[i] + y(2, 1) * inverse.lever[i];
  return Status::ok;
}

Status find_needs(const LinearModel<double>& body, const PilotGains& gains, const Half& half, double s,
                  Needs& needs) {
  Inverse at_s{};
  Status status = invert(body, gains, half, 0, needs.steady);
  if (status == Status::ok) status = invert(body, gains, half, s, at_s);
  for (int i = 0; i < 2; ++i) {
    needs.changing.attitude[i] = (at_s.attitude[i] - needs.steady.attitude[i]) / s;
    needs.changing.stick[i] = (at_s.stick[i] - needs.steady.stick[i]) / s;
    needs.changing.lever[i] = (at_s.lever[i] - needs.steady.lever[i]) / s;
  }
  return status;
}

}  // namespace

Status pilot_gains(const LinearModel<double>& model, const RateFeedback& augmentation, const PilotRule& rule,
                   PilotGains& gains) {
  gains = {};
  if (!has_inceptors(model)) return Status::bad_argument;
  const auto work = std::make_unique<ResidualisationWorkspace<double>>();
  const auto body = std::make_unique<LinearModel<double>>();
  Status status = residualise(model, *work, *body);
  if (status != Status::ok) return status;
  const auto feed_back = [&body](Place rate, Lever lever, double gain) {
    for (int i = 0; i < kRigidStates; ++i) body->a(i, rate) += gain * body->b(i, lever);
  };
  feed_back(q, long_stick, augmentation.long_stick_per_q);
  feed_back(p, lat_stick, augmentation.lat_stick_per_p);
  feed_back(r, pedal, augmentation.pedal_per_r);
  if (body->b(q, long_stick) == 0 || body->b(p, lat_stick) == 0 || body->b(r, pedal) == 0)
    return Status::singular;

  gains.speed = body->x[u] * std::cos(body->x[theta]) + body->x[w] * std::sin(body->x[theta]);
  gains.pitch = body->x[theta];
  gains.collective = body->u[collective];
  gains.long_stick = body->u[long_stick];
  gains.pitch_by_stick = attitude_gains(*body, kLongitudinal, rule);
  gains.roll_by_stick = attitude_gains(*body, kLateral, rule);
  gains.yaw_damping = std::fmax(rule.yaw_rate + body->a(r, r), 0) / body->b(r, pedal);

  feed_back(q, long_stick, -gains.pitch_by_stick.rate);
  feed_back(p, lat_stick, -gains.roll_by_stick.rate);
  status = find_needs(*body, gains, kLongitudinal, rule.outer, gains.longitudinal);
  if (status == Status::ok) status = find_needs(*body, gains, kLateral, rule.outer, gains.lateral);
  return status;
}

PilotGains between(const PilotGains& a, const PilotGains& b, double part) {
  double number[48] = {};
  int count = 0;
  PilotGains::each(b, [&](const double& x) { number[count++] = x; });
  PilotGains mean = a;
  count = 0;
  PilotGains::each(mean, [&](double& x) { x += part * (number[count++] - x); });
  return mean;
}

}  // namespace tiltrotor::pilot
