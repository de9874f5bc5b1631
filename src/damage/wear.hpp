/// Wear laws: material removed by frictional work, in four forms in use on railways.
///
/// The published constants are the defaults of wrc_wear_laws; all depend on the pair of steels.
#pragma once

namespace wrc::damage {

/// Wear rate of the wheel from T-gamma alone (Pearce, Sherratt, Wear 144 (1991) 343; values unconfirmed):
/// area lost from the cross-section per distance rolled.
///   T-gamma < t1: slope_mild T / D;  t1..t2: plateau / D;  above t2: (slope_severe T - offset_severe) / D,
/// in mm^2 per km with T in N and the wheel diameter D in mm.
struct TGammaWearLaw {
  double t1 = 0.0, t2 = 0.0;                       ///< [N]
  double slope_mild = 0.0;                         ///< [mm^3/(km N)]
  double plateau = 0.0;                            ///< [mm^3/km]
  double slope_severe = 0.0, offset_severe = 0.0;  ///< [mm^3/(km N)], [mm^3/km]
};

/// Area lost per distance rolled [m^2/m]; t_gamma [N], wheel_diameter [m]. The published law jumps from
/// 25 / D to 84 / D at t2: that is how it is printed.
double worn_area_rate(const TGammaWearLaw& law, double t_gamma, double wheel_diameter);

/// Wear rate per contact area from T-gamma / A (University of Sheffield; R8T wheel on UIC60 900A rail,
/// Braghin et al. 2006, Lewis, Dwyer-Joyce 2004; values unconfirmed): K [microgram per metre rolled per mm^2]
/// over x = T-gamma / A [N/mm^2]. Mild K = slope_mild x, severe a plateau, catastrophic slope_catastrophic
/// beyond.
struct SheffieldWearLaw {
  double x1 = 0.0, x2 = 0.0;        ///< [N/mm^2]
  double slope_mild = 0.0;          ///< [microgram/(m N)]
  double slope_catastrophic = 0.0;  ///< [microgram/(m N)]
  double density = 0.0;             ///< [kg/m^3]
};

/// Depth lost per distance rolled [m/m]; t_gamma_density = frictional power density / rolling speed [N/m^2].
/// Continuous: the plateau is slope_mild x1 and the last branch rises from it. (A printed form
/// 61.9 x - 4778.7 is zero at x2, where the plateau is 55: a misprint this does not follow.)
double wear_depth_rate(const SheffieldWearLaw& law, double t_gamma_density);

/// Archard's law with the wear map of Jendel (Wear 253 (2002) 89; values unconfirmed): volume = k N s / H,
/// the coefficient by sliding velocity and pressure.
struct ArchardWearLaw {
  double hardness = 0.0;          ///< H [Pa]
  double mild_low_speed = 0.0;    ///< k below v1 (map: 1e-4 to 10e-4) [-]
  double severe = 0.0;            ///< k from v1 to v2 (30e-4 to 40e-4) [-]
  double mild_high_speed = 0.0;   ///< k above v2 (1e-4 to 10e-4) [-]
  double seizure = 0.0;           ///< k where pressure exceeds seizure_pressure H (300e-4 to 400e-4) [-]
  double v1 = 0.0, v2 = 0.0;      ///< [m/s]
  double seizure_pressure = 0.0;  ///< pressure of seizure over the hardness [-]
};

/// The map's k [-] at a pressure [Pa] and a sliding velocity [m/s].
double wear_coefficient(const ArchardWearLaw& law, double pressure, double sliding_velocity);

/// Depth lost by a point of the surface per second in contact [m/s]: k p v / H; pressure [Pa],
/// sliding_velocity [m/s].
double wear_depth_velocity(const ArchardWearLaw& law, double pressure, double sliding_velocity);

/// A power law of frictional power density q: depth per second k / density q (q / reference)^(exponent - 1);
/// with exponent 1 mass in proportion to energy, the mild regime of Zobory (VSD 28 (1997) 221; value
/// unconfirmed).
struct PowerWearLaw {
  double coefficient = 0.0;  ///< k [kg/J]
  double exponent = 1.0;     ///< [-]
  double reference = 1.0;    ///< [W/m^2]
  double density = 1.0;      ///< density of the worn material [kg/m^3]
};

/// Depth lost by a point of the surface per second in contact [m/s]; power_density [W/m^2].
double wear_depth_velocity(const PowerWearLaw& law, double power_density);

/// All of them, each with its own parameters.
struct WearLaws {
  TGammaWearLaw t_gamma;
  SheffieldWearLaw sheffield;
  ArchardWearLaw archard;
  PowerWearLaw power;
};

}  // namespace wrc::damage
