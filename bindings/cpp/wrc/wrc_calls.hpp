/// Written by tools/interface/describe.py from the headers in include_c/wrc: do not edit.
/// wrc.hpp, which includes this file, says what it is.
#pragma once

// clang-format off
namespace wrc {

/** wrc_config_use() */
inline status config_use(wrc_config& config, const char* name, span<char> text) noexcept { return wrc_config_use(&config, name, text.data(), text.size()); }
/** wrc_config_check() */
inline status config_check(const wrc_config& config, span<char> text) noexcept { return wrc_config_check(&config, text.data(), text.size()); }
/** wrc_model_size() */
inline status model_size(const wrc_config& config, std::uint64_t& bytes, std::uint64_t& alignment) noexcept { return wrc_model_size(&config, &bytes, &alignment); }
/** wrc_contact_step_batch() */
inline status contact_step_batch(span<wrc_contact* const> contacts, span<const wrc_planar_input> inputs, span<wrc_planar_output> outputs, span<std::int32_t> statuses) noexcept { if (!detail::fits(inputs, contacts.size(), true)) return WRC_ERROR_BUFFER; if (!detail::fits(outputs, contacts.size(), false)) return WRC_ERROR_BUFFER; if (statuses.size() != 0 && statuses.size() < contacts.size()) return WRC_ERROR_BUFFER; return wrc_contact_step_batch(contacts.data(), static_cast<std::uint32_t>(contacts.size()), inputs.data(), detail::stride(inputs), outputs.data(), detail::stride(outputs), statuses.data()); }
/** wrc_linear_coefficients() */
inline status linear_coefficients(double a_over_b, double psi, double poisson, wrc_coefficients& coefficients) noexcept { return wrc_linear_coefficients(a_over_b, psi, poisson, &coefficients); }
inline expected<answer<wrc_coefficients>> try_linear_coefficients(double a_over_b, double psi, double poisson) noexcept { return detail::attempt_struct<wrc_coefficients>(wrc_coefficients(), [&](wrc_coefficients& found_) { return linear_coefficients(a_over_b, psi, poisson, found_); }); }
#ifdef WRC_EXCEPTIONS
inline answer<wrc_coefficients> linear_coefficients(double a_over_b, double psi, double poisson) { return detail::value_or_throw(try_linear_coefficients(a_over_b, psi, poisson)); }
#endif
/** wrc_shakedown_limit() */
inline status shakedown_limit(double utilisation, double& load_factor) noexcept { return wrc_shakedown_limit(utilisation, &load_factor); }
inline expected<double> try_shakedown_limit(double utilisation) noexcept { return detail::attempt<double>(double(), [&](double& found_) { return shakedown_limit(utilisation, found_); }); }
#ifdef WRC_EXCEPTIONS
inline double shakedown_limit(double utilisation) { return detail::value_or_throw(try_shakedown_limit(utilisation)); }
#endif
/** wrc_shakedown_limit_point() */
inline status shakedown_limit_point(double utilisation, double& load_factor) noexcept { return wrc_shakedown_limit_point(utilisation, &load_factor); }
inline expected<double> try_shakedown_limit_point(double utilisation) noexcept { return detail::attempt<double>(double(), [&](double& found_) { return shakedown_limit_point(utilisation, found_); }); }
#ifdef WRC_EXCEPTIONS
inline double shakedown_limit_point(double utilisation) { return detail::value_or_throw(try_shakedown_limit_point(utilisation)); }
#endif
/** wrc_contact_wrench_batch() */
inline status contact_wrench_batch(span<wrc_contact* const> contacts, span<const wrc_wheel_input> inputs, span<wrc_wrench> wrenches, span<std::int32_t> statuses) noexcept { if (!detail::fits(inputs, contacts.size(), true)) return WRC_ERROR_BUFFER; if (!detail::fits(wrenches, contacts.size(), false)) return WRC_ERROR_BUFFER; if (statuses.size() != 0 && statuses.size() < contacts.size()) return WRC_ERROR_BUFFER; return wrc_contact_wrench_batch(contacts.data(), static_cast<std::uint32_t>(contacts.size()), inputs.data(), detail::stride(inputs), wrenches.data(), detail::stride(wrenches), statuses.data()); }
/** wrc_flash_temperature() */
inline status flash_temperature(std::uint32_t count, double cell, const double* power_density, double speed, const wrc_heat_properties* wheel, const wrc_heat_properties& rail, double* rise) noexcept { return wrc_flash_temperature(count, cell, power_density, speed, wheel, &rail, rise); }
/** wrc_damage_merge() */
inline status damage_merge(wrc_damage_bins& into, const wrc_damage_bins& from) noexcept { return wrc_damage_merge(&into, &from); }
/** wrc_damage_values() */
inline status damage_values(const wrc_damage_bins& bins, std::int32_t quantity, double* values) noexcept { return wrc_damage_values(&bins, quantity, values); }
/** wrc_whole_life_damage() */
inline status whole_life_damage(const wrc_fatigue_laws* laws, double t_gamma, double& damage) noexcept { return wrc_whole_life_damage(laws, t_gamma, &damage); }
inline expected<double> try_whole_life_damage(const wrc_fatigue_laws* laws, double t_gamma) noexcept { return detail::attempt<double>(double(), [&](double& found_) { return whole_life_damage(laws, t_gamma, found_); }); }
#ifdef WRC_EXCEPTIONS
inline double whole_life_damage(const wrc_fatigue_laws* laws, double t_gamma) { return detail::value_or_throw(try_whole_life_damage(laws, t_gamma)); }
#endif
/** wrc_exact_normal() */
inline status exact_normal(const wrc_exact_normal_problem& problem, wrc_exact_normal_solution& solution, span<char> text) noexcept { return wrc_exact_normal(&problem, &solution, text.data(), text.size()); }
/** wrc_exact_rolling() */
inline status exact_rolling(const wrc_exact_rolling_problem& problem, wrc_exact_rolling_solution& solution, span<char> text) noexcept { return wrc_exact_rolling(&problem, &solution, text.data(), text.size()); }
/** wrc_exact_stress() */
inline status exact_stress(const wrc_exact_loads& loads, const double* points, std::uint32_t count, double* stresses, span<char> text) noexcept { return wrc_exact_stress(&loads, points, count, stresses, text.data(), text.size()); }
/** wrc_exact_largest_stresses() */
inline status exact_largest_stresses(const wrc_exact_loads& loads, const double* depths, std::uint32_t count, wrc_stress_peaks* levels, wrc_stresses* stresses, wrc_progress progress, void* user, span<char> text) noexcept { return wrc_exact_largest_stresses(&loads, depths, count, levels, stresses, progress, user, text.data(), text.size()); }
/** wrc_exact_transient_create() */
inline status exact_transient_create(const wrc_grid& grid, const wrc_materials& materials, wrc_exact_transient** transient, span<char> text) noexcept { return wrc_exact_transient_create(&grid, &materials, transient, text.data(), text.size()); }
/** wrc_exact_transient_step() */
inline status exact_transient_step(wrc_exact_transient& transient, const wrc_exact_rolling_problem& problem, wrc_exact_rolling_solution& solution, span<char> text) noexcept { return wrc_exact_transient_step(&transient, &problem, &solution, text.data(), text.size()); }
/** wrc_equivalent_conicity() */
inline status equivalent_conicity(const wrc_conicity_problem& problem, wrc_conicity& conicity, span<char> text) noexcept { return wrc_equivalent_conicity(&problem, &conicity, text.data(), text.size()); }
/** wrc_profile_remove_wear() */
inline status profile_take_off(const wrc_profile_wear& wear, wrc_worn_profile& worn, span<char> text) noexcept { return wrc_profile_remove_wear(&wear, &worn, text.data(), text.size()); }
/** wrc_flange_dimensions() */
inline status flange_dimensions(std::uint32_t count, const double* y, const double* z, double flange_back_to_origin, wrc_flange& flange, span<char> text) noexcept { return wrc_flange_dimensions(count, y, z, flange_back_to_origin, &flange, text.data(), text.size()); }

namespace detail {

/** Functions of a model. */
class model_calls {
 public:
  /** wrc_model_profile() */
  status profile(std::int32_t side, std::int32_t body, wrc_view* y, wrc_view* z, double* deviation) const noexcept { return wrc_model_profile(handle_, side, body, y, z, deviation); }
  /** wrc_contact_size() */
  status contact_size(std::uint64_t& bytes, std::uint64_t& alignment) const noexcept { return wrc_contact_size(handle_, &bytes, &alignment); }
  /** wrc_contact_state_size() */
  status contact_state_size(std::uint64_t& bytes) const noexcept { return wrc_contact_state_size(handle_, &bytes); }
  expected<std::uint64_t> try_contact_state_size() const noexcept { return detail::attempt<std::uint64_t>(std::uint64_t(), [&](std::uint64_t& found_) { return this->contact_state_size(found_); }); }
#ifdef WRC_EXCEPTIONS
  std::uint64_t contact_state_size() const { return detail::value_or_throw(try_contact_state_size()); }
#endif
  /** wrc_contact_portable_size() */
  status contact_portable_size(std::uint64_t& bytes) const noexcept { return wrc_contact_portable_size(handle_, &bytes); }
  expected<std::uint64_t> try_contact_portable_size() const noexcept { return detail::attempt<std::uint64_t>(std::uint64_t(), [&](std::uint64_t& found_) { return this->contact_portable_size(found_); }); }
#ifdef WRC_EXCEPTIONS
  std::uint64_t contact_portable_size() const { return detail::value_or_throw(try_contact_portable_size()); }
#endif
  /** wrc_model_arc_places() */
  status arc_places(std::int32_t body, std::uint32_t count, const double* arc, double* y, double* z) const noexcept { return wrc_model_arc_places(handle_, body, count, arc, y, z); }
  /** wrc_profile_wheelset_geometry() */
  status profile_contact_functions(const wrc_wheelset_geometry_problem& problem, wrc_wheelset_geometry& functions, span<char> text) const noexcept { return wrc_profile_wheelset_geometry(handle_, &problem, &functions, text.data(), text.size()); }

 protected:
  const wrc_model* handle_ = nullptr;
};

/** Functions of a contact. */
class contact_calls {
 public:
  /** wrc_contact_save() */
  status save(span<std::byte> buffer) const noexcept { return wrc_contact_save(handle_, buffer.data(), buffer.size()); }
  /** wrc_contact_restore() */
  status restore(span<const std::byte> buffer) noexcept { return wrc_contact_restore(handle_, buffer.data(), buffer.size()); }
  /** wrc_contact_save_portable() */
  status save_portable(span<std::byte> buffer) const noexcept { return wrc_contact_save_portable(handle_, buffer.data(), buffer.size()); }
  /** wrc_contact_restore_portable() */
  status restore_portable(span<const std::byte> buffer) noexcept { return wrc_contact_restore_portable(handle_, buffer.data(), buffer.size()); }
  /** wrc_contact_last_error() */
  status last_error(span<char> buffer) const noexcept { return wrc_contact_last_error(handle_, buffer.data(), buffer.size()); }
  /** wrc_planar_geometry() */
  status geometry(const wrc_planar_pose& pose, wrc_planar_point& point) noexcept { return wrc_planar_geometry(handle_, &pose, &point); }
  expected<answer<wrc_planar_point>> try_geometry(const wrc_planar_pose& pose) noexcept { return detail::attempt_struct<wrc_planar_point>(wrc_planar_point(), [&](wrc_planar_point& found_) { return this->geometry(pose, found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_planar_point> geometry(const wrc_planar_pose& pose) { return detail::value_or_throw(try_geometry(pose), handle_); }
#endif
  /** wrc_planar_creepages() */
  status creepages(const wrc_planar_motion& motion, wrc_creepage& creepage) noexcept { return wrc_planar_creepages(handle_, &motion, &creepage); }
  expected<answer<wrc_creepage>> try_creepages(const wrc_planar_motion& motion) noexcept { return detail::attempt_struct<wrc_creepage>(wrc_creepage_default(), [&](wrc_creepage& found_) { return this->creepages(motion, found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_creepage> creepages(const wrc_planar_motion& motion) { return detail::value_or_throw(try_creepages(motion), handle_); }
#endif
  /** wrc_planar_normal() */
  status normal(const wrc_planar_gap* gap, const wrc_planar_load& load, wrc_planar_normal_solution& normal) noexcept { return wrc_planar_normal(handle_, gap, &load, &normal); }
  expected<answer<wrc_planar_normal_solution>> try_normal(const wrc_planar_gap* gap, const wrc_planar_load& load) noexcept { return detail::attempt_struct<wrc_planar_normal_solution>(wrc_planar_normal_solution(), [&](wrc_planar_normal_solution& found_) { return this->normal(gap, load, found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_planar_normal_solution> normal(const wrc_planar_gap* gap, const wrc_planar_load& load) { return detail::value_or_throw(try_normal(gap, load), handle_); }
#endif
  /** wrc_planar_regularise() */
  status regularise(const wrc_planar_strips* strips, wrc_planar_normal_solution& normal) noexcept { return wrc_planar_regularise(handle_, strips, &normal); }
  expected<answer<wrc_planar_normal_solution>> try_regularise(const wrc_planar_strips* strips) noexcept { return detail::attempt_struct<wrc_planar_normal_solution>(wrc_planar_normal_solution(), [&](wrc_planar_normal_solution& found_) { return this->regularise(strips, found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_planar_normal_solution> regularise(const wrc_planar_strips* strips) { return detail::value_or_throw(try_regularise(strips), handle_); }
#endif
  /** wrc_planar_roll() */
  status roll(double distance) noexcept { return wrc_planar_roll(handle_, distance); }
  /** wrc_planar_tangential() */
  status tangential(const wrc_ellipse* ellipse, const wrc_creepage& creepage, const wrc_friction& friction, wrc_planar_forces& forces) noexcept { return wrc_planar_tangential(handle_, ellipse, &creepage, &friction, &forces); }
  expected<answer<wrc_planar_forces>> try_tangential(const wrc_ellipse* ellipse, const wrc_creepage& creepage, const wrc_friction& friction) noexcept { return detail::attempt_struct<wrc_planar_forces>(wrc_planar_forces(), [&](wrc_planar_forces& found_) { return this->tangential(ellipse, creepage, friction, found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_planar_forces> tangential(const wrc_ellipse* ellipse, const wrc_creepage& creepage, const wrc_friction& friction) { return detail::value_or_throw(try_tangential(ellipse, creepage, friction), handle_); }
#endif
  /** wrc_contact_damage() */
  status damage(wrc_damage& damage) noexcept { return wrc_contact_damage(handle_, &damage); }
  expected<answer<wrc_damage>> try_damage() noexcept { return detail::attempt_struct<wrc_damage>(wrc_damage(), [&](wrc_damage& found_) { return this->damage(found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_damage> damage() { return detail::value_or_throw(try_damage(), handle_); }
#endif
  /** wrc_contact_wear() */
  status wear(const wrc_wear_laws* laws, wrc_wear& wear) noexcept { return wrc_contact_wear(handle_, laws, &wear); }
  expected<answer<wrc_wear>> try_wear(const wrc_wear_laws* laws) noexcept { return detail::attempt_struct<wrc_wear>(wrc_wear(), [&](wrc_wear& found_) { return this->wear(laws, found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_wear> wear(const wrc_wear_laws* laws) { return detail::value_or_throw(try_wear(laws), handle_); }
#endif
  /** wrc_planar_tangential_derivatives() */
  status sensitivities(wrc_planar_derivatives& sensitivity) noexcept { return wrc_planar_tangential_derivatives(handle_, &sensitivity); }
  expected<answer<wrc_planar_derivatives>> try_sensitivities() noexcept { return detail::attempt_struct<wrc_planar_derivatives>(wrc_planar_derivatives(), [&](wrc_planar_derivatives& found_) { return this->sensitivities(found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_planar_derivatives> sensitivities() { return detail::value_or_throw(try_sensitivities(), handle_); }
#endif
  /** wrc_contact_step_sensitivities() */
  status step_sensitivities(wrc_step_sensitivity& sensitivity) noexcept { return wrc_contact_step_sensitivities(handle_, &sensitivity); }
  expected<answer<wrc_step_sensitivity>> try_step_sensitivities() noexcept { return detail::attempt_struct<wrc_step_sensitivity>(wrc_step_sensitivity(), [&](wrc_step_sensitivity& found_) { return this->step_sensitivities(found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_step_sensitivity> step_sensitivities() { return detail::value_or_throw(try_step_sensitivities(), handle_); }
#endif
  /** wrc_planar_step() */
  status step(const wrc_planar_input& input, wrc_planar_output& output) noexcept { return wrc_planar_step(handle_, &input, &output); }
  expected<answer<wrc_planar_output>> try_step(const wrc_planar_input& input) noexcept { return detail::attempt_struct<wrc_planar_output>(wrc_planar_output_default(), [&](wrc_planar_output& found_) { return this->step(input, found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_planar_output> step(const wrc_planar_input& input) { return detail::value_or_throw(try_step(input), handle_); }
#endif
  /** wrc_contact_patch() */
  status patch(std::int32_t index, wrc_patch& patch) const noexcept { return wrc_contact_patch(handle_, index, &patch); }
  expected<answer<wrc_patch>> try_patch(std::int32_t index) const noexcept { return detail::attempt_struct<wrc_patch>(wrc_patch_default(), [&](wrc_patch& found_) { return this->patch(index, found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_patch> patch(std::int32_t index) const { return detail::value_or_throw(try_patch(index), handle_); }
#endif
  /** wrc_contact_field() */
  status field(std::int32_t patch, std::int32_t field, wrc_view& view) const noexcept { return wrc_contact_field(handle_, patch, field, &view); }
  expected<::wrc::field> try_field(std::int32_t patch, std::int32_t field) const noexcept { return detail::attempt<::wrc::field>(::wrc::field(), [&](wrc_view& found_) { return this->field(patch, field, found_); }); }
#ifdef WRC_EXCEPTIONS
  ::wrc::field field(std::int32_t patch, std::int32_t field) const { return detail::value_or_throw(try_field(patch, field), handle_); }
#endif
  /** wrc_contact_wrench() */
  status wrench(const wrc_wheel_input& input, wrc_wrench& wrench) noexcept { return wrc_contact_wrench(handle_, &input, &wrench); }
  expected<answer<wrc_wrench>> try_wrench(const wrc_wheel_input& input) noexcept { return detail::attempt_struct<wrc_wrench>(wrc_wrench_default(), [&](wrc_wrench& found_) { return this->wrench(input, found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_wrench> wrench(const wrc_wheel_input& input) { return detail::value_or_throw(try_wrench(input), handle_); }
#endif
  /** wrc_contact_wrench_derivatives() */
  status wrench_sensitivities(const wrc_wheel_input& input, wrc_wrench* wrench, wrc_wrench_derivatives* sensitivities) noexcept { return wrc_contact_wrench_derivatives(handle_, &input, wrench, sensitivities); }
  /** wrc_contact_region() */
  status region(std::int32_t index, wrc_region& region) const noexcept { return wrc_contact_region(handle_, index, &region); }
  expected<answer<wrc_region>> try_region(std::int32_t index) const noexcept { return detail::attempt_struct<wrc_region>(wrc_region_default(), [&](wrc_region& found_) { return this->region(index, found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_region> region(std::int32_t index) const { return detail::value_or_throw(try_region(index), handle_); }
#endif
  /** wrc_contact_region_ellipse() */
  status region_ellipse(std::int32_t index, wrc_ellipse& ellipse) const noexcept { return wrc_contact_region_ellipse(handle_, index, &ellipse); }
  expected<answer<wrc_ellipse>> try_region_ellipse(std::int32_t index) const noexcept { return detail::attempt_struct<wrc_ellipse>(wrc_ellipse_default(), [&](wrc_ellipse& found_) { return this->region_ellipse(index, found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_ellipse> region_ellipse(std::int32_t index) const { return detail::value_or_throw(try_region_ellipse(index), handle_); }
#endif
  /** wrc_contact_region_damage() */
  status region_damage(std::int32_t index, wrc_damage& damage) noexcept { return wrc_contact_region_damage(handle_, index, &damage); }
  expected<answer<wrc_damage>> try_region_damage(std::int32_t index) noexcept { return detail::attempt_struct<wrc_damage>(wrc_damage(), [&](wrc_damage& found_) { return this->region_damage(index, found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_damage> region_damage(std::int32_t index) { return detail::value_or_throw(try_region_damage(index), handle_); }
#endif
  /** wrc_contact_region_field() */
  status region_field(std::int32_t index, std::int32_t field, double* values, std::uint64_t count) noexcept { return wrc_contact_region_field(handle_, index, field, values, count); }
  /** wrc_contact_temperature() */
  status temperature(const wrc_bulk_temperatures* bulk, wrc_temperature& temperature) noexcept { return wrc_contact_temperature(handle_, bulk, &temperature); }
  expected<answer<wrc_temperature>> try_temperature(const wrc_bulk_temperatures* bulk) noexcept { return detail::attempt_struct<wrc_temperature>(wrc_temperature_default(), [&](wrc_temperature& found_) { return this->temperature(bulk, found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_temperature> temperature(const wrc_bulk_temperatures* bulk) { return detail::value_or_throw(try_temperature(bulk), handle_); }
#endif
  /** wrc_contact_region_temperature() */
  status region_temperature(std::int32_t index, const wrc_bulk_temperatures* bulk, wrc_temperature& temperature) noexcept { return wrc_contact_region_temperature(handle_, index, bulk, &temperature); }
  expected<answer<wrc_temperature>> try_region_temperature(std::int32_t index, const wrc_bulk_temperatures* bulk) noexcept { return detail::attempt_struct<wrc_temperature>(wrc_temperature_default(), [&](wrc_temperature& found_) { return this->region_temperature(index, bulk, found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_temperature> region_temperature(std::int32_t index, const wrc_bulk_temperatures* bulk) { return detail::value_or_throw(try_region_temperature(index, bulk), handle_); }
#endif
  /** wrc_contact_stresses() */
  status stresses(std::int32_t body, const double* depths, std::uint32_t count, wrc_stress_peaks* levels, wrc_stresses* stresses) noexcept { return wrc_contact_stresses(handle_, body, depths, count, levels, stresses); }
  /** wrc_contact_accumulate() */
  status accumulate(const wrc_accumulation& accumulation, wrc_damage_bins* wheel, wrc_damage_bins* rail, wrc_damage_totals* totals) noexcept { return wrc_contact_accumulate(handle_, &accumulation, wheel, rail, totals); }
  /** wrc_exact_gap() */
  status exact_gap(const wrc_grid& grid, double* gap) noexcept { return wrc_exact_gap(handle_, &grid, gap); }
  /** wrc_exact_check() */
  status exact_check(std::uint32_t nx, std::uint32_t ny, wrc_progress progress, void* user, wrc_exact_check_result& result) noexcept { return wrc_exact_check(handle_, nx, ny, progress, user, &result); }
  expected<answer<wrc_exact_check_result>> try_exact_check(std::uint32_t nx, std::uint32_t ny, wrc_progress progress, void* user) noexcept { return detail::attempt_struct<wrc_exact_check_result>(wrc_exact_check_result_default(), [&](wrc_exact_check_result& found_) { return this->exact_check(nx, ny, progress, user, found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_exact_check_result> exact_check(std::uint32_t nx, std::uint32_t ny, wrc_progress progress, void* user) { return detail::value_or_throw(try_exact_check(nx, ny, progress, user), handle_); }
#endif
  /** wrc_exact_wrench() */
  status exact_wrench(const wrc_wheel_input& input, const wrc_exact_wrench_options* options, wrc_wrench& wrench) noexcept { return wrc_exact_wrench(handle_, &input, options, &wrench); }
  expected<answer<wrc_wrench>> try_exact_wrench(const wrc_wheel_input& input, const wrc_exact_wrench_options* options) noexcept { return detail::attempt_struct<wrc_wrench>(wrc_wrench_default(), [&](wrc_wrench& found_) { return this->exact_wrench(input, options, found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_wrench> exact_wrench(const wrc_wheel_input& input, const wrc_exact_wrench_options* options) { return detail::value_or_throw(try_exact_wrench(input, options), handle_); }
#endif

 protected:
  wrc_contact* handle_ = nullptr;
};

}  // namespace detail

}  // namespace wrc
