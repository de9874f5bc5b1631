/// The wrench of a wheel at a height: overlaps, pressures, slips, tractions, sums.
#pragma once

#include "surface/wrench/wheel_work.hpp"
#include "tangential/friction/heated_friction.hpp"

namespace wrc {

/// The wheel at this height as the rail sees it.
RelativeMotion see(const SurfaceModel& model, const WheelOnRail& in, double height);

/// The rail's strips but those of faces behind the flange that look away from the wheel.
RailStrips strips_before(const SurfaceModel& model, const RelativeMotion& seen, const RailStrips& strips);

/// Finds all strips with depth > -margin.
void find(const SurfaceModel& model, const WheelOnRail& in, const RelativeMotion& seen, double margin,
          WheelWork& w);

/// Strips nearer than this to the wheel are candidates [m].
double margin_of(const SurfaceModel& model);

/// The law's coefficient of a strip at rest, a mean over its width on the profile that zones lie on, and what
/// that changes by as the strip's place on the wheel's profile does [1/m]. After find().
struct FrictionAtRest {
  double value, by_wheel_y;
};
FrictionAtRest friction_at_rest(const SurfaceModel& model, const WheelOnRail& in, const WheelWork& w,
                                std::int32_t strip);

/// The law's factor of the sliding speed of a strip in contact: the root mean square of its rigid slip times
/// `speed`, what slips are over [m/s] (tangential/friction/friction.hpp).
double strip_speed_factor(const FrictionLaw& law, const WheelWork& w, std::int32_t k, double speed);

/// Does the whole of a patch roll at a time?
bool rolls_by_region(const SurfaceModel& model, const WheelOnRail& in);

/// Tractions of the strips in contact. Backwards is forwards seen in a mirror across the axle: x, and with it
/// slip along x and spin, change sign, and so do their forces. `heat`: friction over temperature of methods
/// that roll by region, to which the strips' friction is cold, and hot afterwards.
Fault roll(const SurfaceModel& model, const WheelOnRail& in, std::int32_t count, bool backwards, WheelWork& w,
           const TangentialFields& fields, SurfaceRollingForces forces, HeatedFriction* heat = nullptr);

/// The same under friction over temperature, `speed` that of rolling [m/s], from the strips' cold_friction;
/// leaves the hot coefficients. `again`: so many solutions from heat_share.
Fault roll_heated(const SurfaceModel& model, const WheelOnRail& in, std::int32_t count, bool backwards,
                  double speed, WheelWork& w, const SurfaceRollingForces& forces, int again = 0);

/// Solves at a height; the wrench is complete but for the sweeps of earlier calls, which stay in it. `found`:
/// the overlaps at this height stand in w.overlaps already.
Fault solve_at(const SurfaceModel& model, const WheelOnRail& in, double height, bool found, WheelWork& w,
               PressureStart& start, const PressureOptions& options, Wrench& out);

/// The greatest height, no greater than `height`, at which no overlap is deeper than `deepest_overlap` [m].
/// Leaves the overlaps at that height where it is the one.
double height_at_border(const SurfaceModel& model, const WheelOnRail& in, double height, WheelWork& w);

/// The wrench at the height given. Beyond the deepest overlap that is solved the load goes on with the
/// stiffness it had, in the directions it had.
Fault solve_given_height(const SurfaceModel& model, const WheelOnRail& in, WheelWork& w, PressureStart& start,
                         Wrench& out);

/// The height [m] at which the wheel first touches: lowered from the one given, or from above the rail where
/// a face is overlapped there already, until it does.
double first_touch(const SurfaceModel& model, const WheelOnRail& in, WheelWork& w);

/// Does a solve say that the bodies are apart, and not that the wheel is inside the rail?
bool is_apart(const Fault& fault);

/// By how much a wheel that is apart must be lowered until the first strip of the rail overlaps it [m], 0 to
/// farthest_touch, which stands for anything beyond: Newton's method on the nearest strip. Overlaps in `w`
/// are others afterwards.
double clearance(const SurfaceModel& model, const WheelOnRail& in, WheelWork& w);

}  // namespace wrc
