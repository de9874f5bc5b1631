/// What the golden hash is taken over: models, and for each of them contacts with steps or calls of their
/// own.
///
/// Inputs are made with integers, +, -, * and / only, so that they are the same bits everywhere.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "golden/hash.hpp"
#include "structs.hpp"
#include "test_config.hpp"

/// Rows or elements of an undeformed gap, and the struct that shows them to the library.
struct HostGap {
  std::vector<double> y, height, centre, curvature, x, h;
  wrc_planar_gap view() const;
};

/// Input of one step.
struct Step {
  wrc_planar_pose pose = sized<wrc_planar_pose>();
  const HostGap* gap = nullptr;  ///< in place of the pose
  wrc_planar_load load = wrc_planar_load_default();
  wrc_creepage creepage = wrc_creepage_default();
  wrc_friction friction = wrc_friction_default();
};

/// One contact's life. Jobs are independent of each other: they may run in any thread, in any order.
struct Job {
  std::string group;
  std::size_t model = 0;                           ///< index into Plan::models
  std::vector<Step> steps;                         ///< none of which may fail
  std::function<void(wrc_contact*, Hash&)> calls;  ///< instead of steps
  std::function<void(wrc_contact* right, wrc_contact* left, Hash&)> calls_of_both = {};  ///< instead of these
  int32_t side = WRC_SIDE_RIGHT;
};

/// Deques: configurations point to profiles, profiles to points, jobs to gaps.
struct Plan {
  std::deque<std::vector<double>> points;
  std::deque<wrc_profile> profiles;
  std::deque<wrc_config> models;
  std::deque<HostGap> gaps;
  std::vector<Job> jobs;
};

/// Uniform numbers from a seed (SplitMix64), exact in every step.
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : state_(seed) {}
  double between(double low, double high) {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    z ^= z >> 31;
    return low + (high - low) * (static_cast<double>(z >> 11) * 0x1p-53);
  }

 private:
  std::uint64_t state_;
};

Plan golden_plan();

void add_poses(Plan& plan);        ///< steps from a pose: methods, creepages, grids, profiles
void add_host_data(Plan& plan);    ///< gaps, strips and patches of the host
void add_laws(Plan& plan);         ///< friction over place and speed, sensitivities of the forces
void add_plain_calls(Plan& plan);  ///< wear, motion, coefficients, profiles, refused input
void add_exact(Plan& plan);        ///< the exact solver of wrc_offline.h

/// A wheel on a rail, even numbers on the right side: tread, two regions, flange, apart; at a given height or
/// under a given load.
wrc_wheel_input wheel_on_rail(int i, Numbers& numbers);

/// How far the stages of a contact have come.
enum class Reached { gap, tangential, damage };

// What the parts of the plan share. `tractions`: does the method give them?
void hash_step(wrc_contact* contact, int32_t status, const wrc_planar_output& output, bool tractions,
               Hash& hash);
void hash_point(const wrc_planar_point& point, Hash& hash);
void hash_normal(const wrc_planar_normal_solution& of, Hash& hash);
void hash_forces(const wrc_planar_forces& forces, Hash& hash);
void hash_damage(const wrc_damage& damage, Hash& hash);
void hash_fields(wrc_contact* contact, Hash& hash, bool tractions = true, Reached reached = Reached::damage);
