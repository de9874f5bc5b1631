/// Written by tools/interface/describe.py from the headers in include_c/wrc: do not edit.
/// wrc.hpp, which includes this file, says what it is.
#pragma once

// clang-format off
namespace wrc {

template <>
inline wrc_material defaults() noexcept { return wrc_material_default(); }
template <>
inline wrc_config defaults() noexcept { return wrc_config_default(); }
template <>
inline wrc_bulk_temperatures defaults() noexcept { return wrc_bulk_temperatures_default(); }
template <>
inline wrc_friction defaults() noexcept { return wrc_friction_default(); }
template <>
inline wrc_wheel_input defaults() noexcept { return wrc_wheel_input_default(); }
template <>
inline wrc_creepage defaults() noexcept { return wrc_creepage_default(); }
template <>
inline wrc_planar_load defaults() noexcept { return wrc_planar_load_default(); }
template <>
inline wrc_planar_input defaults() noexcept { return wrc_planar_input_default(); }
template <>
inline wrc_wear_laws defaults() noexcept { return wrc_wear_laws_default(); }
template <>
inline wrc_damage_bins defaults() noexcept { return wrc_damage_bins_default(); }
template <>
inline wrc_fatigue_laws defaults() noexcept { return wrc_fatigue_laws_default(); }
template <>
inline wrc_exact_normal_problem defaults() noexcept { return wrc_exact_normal_problem_default(); }
template <>
inline wrc_exact_rolling_problem defaults() noexcept { return wrc_exact_rolling_problem_default(); }
template <>
inline wrc_exact_loads defaults() noexcept { return wrc_exact_loads_default(); }
template <>
inline wrc_exact_wrench_options defaults() noexcept { return wrc_exact_wrench_options_default(); }
template <>
inline wrc_exact_check_options defaults() noexcept { return wrc_exact_check_options_default(); }
template <>
inline wrc_creep_curve defaults() noexcept { return wrc_creep_curve_default(); }
template <>
inline wrc_conicity_problem defaults() noexcept { return wrc_conicity_problem_default(); }
template <>
inline wrc_profile_wear defaults() noexcept { return wrc_profile_wear_default(); }
template <>
inline wrc_rail_faces_problem defaults() noexcept { return wrc_rail_faces_problem_default(); }
template <>
inline wrc_surface defaults() noexcept { return wrc_surface_default(); }
template <>
inline wrc_surface_laws defaults() noexcept { return wrc_surface_laws_default(); }

/** wrc_config_use() */
inline status config_use(wrc_config& config, const char* name, span<char> text) noexcept { return wrc_config_use(&config, name, text.data(), text.size()); }
/** wrc_friction_use() */
inline status friction_use(wrc_friction& friction, const char* name, span<char> text) noexcept { return wrc_friction_use(&friction, name, text.data(), text.size()); }
/** wrc_config_check() */
inline status config_check(const wrc_config& config, span<char> text) noexcept { return wrc_config_check(&config, text.data(), text.size()); }
/** wrc_model_size() */
inline status model_size(const wrc_config& config, std::uint64_t& bytes, std::uint64_t& alignment) noexcept { return wrc_model_size(&config, &bytes, &alignment); }
/** wrc_contact_wrench_batch() */
inline status contact_wrench_batch(span<wrc_contact* const> contacts, span<const wrc_wheel_input> inputs, span<wrc_wrench> wrenches, span<std::int32_t> statuses) noexcept { if (!detail::fits(inputs, contacts.size(), true)) return WRC_ERROR_BUFFER; if (!detail::fits(wrenches, contacts.size(), false)) return WRC_ERROR_BUFFER; if (statuses.size() != 0 && statuses.size() < contacts.size()) return WRC_ERROR_BUFFER; return wrc_contact_wrench_batch(contacts.data(), static_cast<std::uint32_t>(contacts.size()), inputs.data(), detail::stride(inputs), wrenches.data(), detail::stride(wrenches), statuses.data()); }
/** wrc_flash_temperature(); may change in a minor version */
inline status flash_temperature(std::uint32_t count, double cell, const double* power_density, double speed, const wrc_heat_properties* wheel, const wrc_heat_properties* rail, double* rise) noexcept { return wrc_flash_temperature(count, cell, power_density, speed, wheel, rail, rise); }
/** wrc_damage_merge(); may change in a minor version */
inline status damage_merge(wrc_damage_bins& into, const wrc_damage_bins& from) noexcept { return wrc_damage_merge(&into, &from); }
/** wrc_damage_values(); may change in a minor version */
inline status damage_values(const wrc_damage_bins& bins, std::int32_t quantity, double* values) noexcept { return wrc_damage_values(&bins, quantity, values); }
/** wrc_whole_life_damage(); may change in a minor version */
inline status whole_life_damage(const wrc_fatigue_laws* laws, double t_gamma, double& damage) noexcept { return wrc_whole_life_damage(laws, t_gamma, &damage); }
inline expected<double> try_whole_life_damage(const wrc_fatigue_laws* laws, double t_gamma) noexcept { return detail::attempt<double>(double(), [&](double& found_) { return whole_life_damage(laws, t_gamma, found_); }); }
#ifdef WRC_EXCEPTIONS
inline double whole_life_damage(const wrc_fatigue_laws* laws, double t_gamma) { return detail::value_or_throw(try_whole_life_damage(laws, t_gamma)); }
#endif
/** wrc_linear_coefficients(); may change in a minor version */
inline status linear_coefficients(double a_over_b, double psi, double poisson, wrc_coefficients& coefficients) noexcept { return wrc_linear_coefficients(a_over_b, psi, poisson, &coefficients); }
inline expected<answer<wrc_coefficients>> try_linear_coefficients(double a_over_b, double psi, double poisson) noexcept { return detail::attempt_struct<wrc_coefficients>([&](wrc_coefficients& found_) { return linear_coefficients(a_over_b, psi, poisson, found_); }); }
#ifdef WRC_EXCEPTIONS
inline answer<wrc_coefficients> linear_coefficients(double a_over_b, double psi, double poisson) { return detail::value_or_throw(try_linear_coefficients(a_over_b, psi, poisson)); }
#endif
/** wrc_shakedown_limit(); may change in a minor version */
inline status shakedown_limit(double utilisation, double& load_factor) noexcept { return wrc_shakedown_limit(utilisation, &load_factor); }
inline expected<double> try_shakedown_limit(double utilisation) noexcept { return detail::attempt<double>(double(), [&](double& found_) { return shakedown_limit(utilisation, found_); }); }
#ifdef WRC_EXCEPTIONS
inline double shakedown_limit(double utilisation) { return detail::value_or_throw(try_shakedown_limit(utilisation)); }
#endif
/** wrc_shakedown_limit_point(); may change in a minor version */
inline status shakedown_limit_point(double utilisation, double& load_factor) noexcept { return wrc_shakedown_limit_point(utilisation, &load_factor); }
inline expected<double> try_shakedown_limit_point(double utilisation) noexcept { return detail::attempt<double>(double(), [&](double& found_) { return shakedown_limit_point(utilisation, found_); }); }
#ifdef WRC_EXCEPTIONS
inline double shakedown_limit_point(double utilisation) { return detail::value_or_throw(try_shakedown_limit_point(utilisation)); }
#endif
/** wrc_exact_normal(); may change in a minor version */
inline status exact_normal(const wrc_exact_normal_problem& problem, wrc_exact_normal_solution& solution, span<char> text) noexcept { return wrc_exact_normal(&problem, &solution, text.data(), text.size()); }
/** wrc_exact_rolling(); may change in a minor version */
inline status exact_rolling(const wrc_exact_rolling_problem& problem, wrc_exact_rolling_solution& solution, span<char> text) noexcept { return wrc_exact_rolling(&problem, &solution, text.data(), text.size()); }
/** wrc_exact_stress(); may change in a minor version */
inline status exact_stress(const wrc_exact_loads& loads, const double* points, std::uint32_t count, double* stresses, span<char> text) noexcept { return wrc_exact_stress(&loads, points, count, stresses, text.data(), text.size()); }
/** wrc_exact_largest_stresses(); may change in a minor version */
inline status exact_largest_stresses(const wrc_exact_loads& loads, const double* depths, std::uint32_t count, wrc_stress_peaks* levels, wrc_stresses* stresses, wrc_progress progress, void* user, span<char> text) noexcept { return wrc_exact_largest_stresses(&loads, depths, count, levels, stresses, progress, user, text.data(), text.size()); }
/** wrc_exact_transient_create(); may change in a minor version */
inline status exact_transient_create(const wrc_grid& grid, const wrc_material* wheel, const wrc_material* rail, wrc_exact_transient** transient, span<char> text) noexcept { return wrc_exact_transient_create(&grid, wheel, rail, transient, text.data(), text.size()); }
/** wrc_exact_transient_step(); may change in a minor version */
inline status exact_transient_step(wrc_exact_transient& transient, const wrc_exact_rolling_problem& problem, wrc_exact_rolling_solution& solution, span<char> text) noexcept { return wrc_exact_transient_step(&transient, &problem, &solution, text.data(), text.size()); }
/** wrc_equivalent_conicity(); may change in a minor version */
inline status equivalent_conicity(const wrc_conicity_problem& problem, wrc_conicity& conicity, span<char> text) noexcept { return wrc_equivalent_conicity(&problem, &conicity, text.data(), text.size()); }
/** wrc_profile_remove_wear(); may change in a minor version */
inline status profile_remove_wear(const wrc_profile_wear& wear, wrc_worn_profile& worn, span<char> text) noexcept { return wrc_profile_remove_wear(&wear, &worn, text.data(), text.size()); }
/** wrc_flange_dimensions(); may change in a minor version */
inline status flange_dimensions(std::uint32_t count, const double* y, const double* z, double flange_back_to_origin, wrc_flange& flange, span<char> text) noexcept { return wrc_flange_dimensions(count, y, z, flange_back_to_origin, &flange, text.data(), text.size()); }
/** wrc_rail_faces_create(); may change in a minor version */
inline status rail_faces_create(const wrc_rail_faces_problem& problem, wrc_rail_faces** faces, span<char> text) noexcept { return wrc_rail_faces_create(&problem, faces, text.data(), text.size()); }
/** wrc_rail_faces_found(); may change in a minor version */
inline status rail_faces_found(const wrc_rail_faces& faces, wrc_found_faces& found) noexcept { return wrc_rail_faces_found(&faces, &found); }
inline expected<answer<wrc_found_faces>> try_rail_faces_found(const wrc_rail_faces& faces) noexcept { return detail::attempt_struct<wrc_found_faces>([&](wrc_found_faces& found_) { return rail_faces_found(faces, found_); }); }
#ifdef WRC_EXCEPTIONS
inline answer<wrc_found_faces> rail_faces_found(const wrc_rail_faces& faces) { return detail::value_or_throw(try_rail_faces_found(faces)); }
#endif
/** wrc_rail_faces_outline(); may change in a minor version */
inline status rail_faces_outline(const wrc_rail_faces& faces, std::uint32_t index, wrc_face_outline& outline) noexcept { return wrc_rail_faces_outline(&faces, index, &outline); }
inline expected<answer<wrc_face_outline>> try_rail_faces_outline(const wrc_rail_faces& faces, std::uint32_t index) noexcept { return detail::attempt_struct<wrc_face_outline>([&](wrc_face_outline& found_) { return rail_faces_outline(faces, index, found_); }); }
#ifdef WRC_EXCEPTIONS
inline answer<wrc_face_outline> rail_faces_outline(const wrc_rail_faces& faces, std::uint32_t index) { return detail::value_or_throw(try_rail_faces_outline(faces, index)); }
#endif
/** wrc_section_file_read(); may change in a minor version */
inline status section_file_read(const char* path, double unit, std::int32_t mirror_y, std::int32_t mirror_z, wrc_section_file** file, span<char> text) noexcept { return wrc_section_file_read(path, unit, mirror_y, mirror_z, file, text.data(), text.size()); }
/** wrc_section_file_line(); may change in a minor version */
inline status section_file_line(const wrc_section_file& file, std::uint32_t index, wrc_section_line& line) noexcept { return wrc_section_file_line(&file, index, &line); }
inline expected<answer<wrc_section_line>> try_section_file_line(const wrc_section_file& file, std::uint32_t index) noexcept { return detail::attempt_struct<wrc_section_line>([&](wrc_section_line& found_) { return section_file_line(file, index, found_); }); }
#ifdef WRC_EXCEPTIONS
inline answer<wrc_section_line> section_file_line(const wrc_section_file& file, std::uint32_t index) { return detail::value_or_throw(try_section_file_line(file, index)); }
#endif
/** wrc_section_file_write(); may change in a minor version */
inline status section_file_write(const char* path, const wrc_section_line& lines, std::uint32_t count, span<char> text) noexcept { return wrc_section_file_write(path, &lines, count, text.data(), text.size()); }
/** wrc_surface_laws_use(); may change in a minor version */
inline status surface_laws_use(wrc_surface_laws& laws, const char* name, span<char> text) noexcept { return wrc_surface_laws_use(&laws, name, text.data(), text.size()); }
/** wrc_surface_add(); may change in a minor version */
inline status surface_add(wrc_surface& surface, std::int32_t quantity, double amount, double from, double to, span<char> text) noexcept { return wrc_surface_add(&surface, quantity, amount, from, to, text.data(), text.size()); }
/** wrc_surface_friction(); may change in a minor version */
inline status surface_friction(const wrc_surface& rail, const wrc_surface* wheel, const wrc_surface_laws& laws, const wrc_surface_passage& passage, const wrc_friction* base, wrc_friction& friction, span<char> text) noexcept { return wrc_surface_friction(&rail, wheel, &laws, &passage, base, &friction, text.data(), text.size()); }
/** wrc_surface_pass(); may change in a minor version */
inline status surface_pass(wrc_surface& rail, wrc_surface* wheel, const wrc_surface_laws& laws, const wrc_surface_passage& passage, wrc_surface_exchange* exchange, span<char> text) noexcept { return wrc_surface_pass(&rail, wheel, &laws, &passage, exchange, text.data(), text.size()); }
/** wrc_surface_rest(); may change in a minor version */
inline status surface_rest(wrc_surface& surface, const wrc_surface_laws& laws, double duration, span<char> text) noexcept { return wrc_surface_rest(&surface, &laws, duration, text.data(), text.size()); }
/** wrc_surface_merge(); may change in a minor version */
inline status surface_merge(wrc_surface& into, const wrc_surface& from, span<char> text) noexcept { return wrc_surface_merge(&into, &from, text.data(), text.size()); }
/** wrc_surface_values(); may change in a minor version */
inline status surface_values(const wrc_surface& surface, std::int32_t quantity, std::int32_t book, double* values, double& total, span<char> text) noexcept { return wrc_surface_values(&surface, quantity, book, values, &total, text.data(), text.size()); }

namespace detail {

/** Functions of a model. */
class model_calls {
 public:
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
  /** wrc_model_arc_places(); may change in a minor version */
  status arc_places(std::int32_t body, std::uint32_t count, const double* arc, double* y, double* z) const noexcept { return wrc_model_arc_places(handle_, body, count, arc, y, z); }
  /** wrc_profile_wheelset_geometry(); may change in a minor version */
  status profile_wheelset_geometry(const wrc_wheelset_geometry_problem& problem, wrc_wheelset_geometry& functions, span<char> text) const noexcept { return wrc_profile_wheelset_geometry(handle_, &problem, &functions, text.data(), text.size()); }

 protected:
  const wrc_model* handle_ = nullptr;
};

/** Functions of a contact. */
class contact_calls {
 public:
  /** wrc_contact_save() */
  status save(span<std::byte> buffer) noexcept { return wrc_contact_save(handle_, buffer.data(), buffer.size()); }
  /** wrc_contact_restore() */
  status restore(span<const std::byte> buffer) noexcept { return wrc_contact_restore(handle_, buffer.data(), buffer.size()); }
  /** wrc_contact_save_portable() */
  status save_portable(span<std::byte> buffer) noexcept { return wrc_contact_save_portable(handle_, buffer.data(), buffer.size()); }
  /** wrc_contact_restore_portable() */
  status restore_portable(span<const std::byte> buffer) noexcept { return wrc_contact_restore_portable(handle_, buffer.data(), buffer.size()); }
  /** wrc_contact_last_error() */
  status last_error(span<char> buffer) const noexcept { return wrc_contact_last_error(handle_, buffer.data(), buffer.size()); }
  /** wrc_contact_wrench() */
  status wrench(const wrc_wheel_input& input, wrc_wrench& wrench) noexcept { return wrc_contact_wrench(handle_, &input, &wrench); }
  expected<answer<wrc_wrench>> try_wrench(const wrc_wheel_input& input) noexcept { return detail::attempt_struct<wrc_wrench>([&](wrc_wrench& found_) { return this->wrench(input, found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_wrench> wrench(const wrc_wheel_input& input) { return detail::value_or_throw(try_wrench(input), handle_); }
#endif
  /** wrc_contact_mark() */
  status mark() noexcept { return wrc_contact_mark(handle_); }
  /** wrc_contact_commit() */
  status commit() noexcept { return wrc_contact_commit(handle_); }
  /** wrc_contact_wrench_derivatives() */
  status wrench_derivatives(const wrc_wheel_input& input, wrc_wrench* wrench, wrc_wrench_derivatives* derivatives) noexcept { return wrc_contact_wrench_derivatives(handle_, &input, wrench, derivatives); }
  /** wrc_contact_region() */
  status region(std::int32_t index, wrc_region& region) noexcept { return wrc_contact_region(handle_, index, &region); }
  expected<answer<wrc_region>> try_region(std::int32_t index) noexcept { return detail::attempt_struct<wrc_region>([&](wrc_region& found_) { return this->region(index, found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_region> region(std::int32_t index) { return detail::value_or_throw(try_region(index), handle_); }
#endif
  /** wrc_contact_damage() */
  status damage(std::int32_t index, wrc_damage& damage) noexcept { return wrc_contact_damage(handle_, index, &damage); }
  expected<answer<wrc_damage>> try_damage(std::int32_t index) noexcept { return detail::attempt_struct<wrc_damage>([&](wrc_damage& found_) { return this->damage(index, found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_damage> damage(std::int32_t index) { return detail::value_or_throw(try_damage(index), handle_); }
#endif
  /** wrc_planar_step() */
  status planar_step(const wrc_planar_input& input, wrc_planar_output& output) noexcept { return wrc_planar_step(handle_, &input, &output); }
  expected<answer<wrc_planar_output>> try_planar_step(const wrc_planar_input& input) noexcept { return detail::attempt_struct<wrc_planar_output>([&](wrc_planar_output& found_) { return this->planar_step(input, found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_planar_output> planar_step(const wrc_planar_input& input) { return detail::value_or_throw(try_planar_step(input), handle_); }
#endif
  /** wrc_planar_geometry() */
  status planar_geometry(const wrc_planar_pose& pose, wrc_planar_point& point) noexcept { return wrc_planar_geometry(handle_, &pose, &point); }
  expected<answer<wrc_planar_point>> try_planar_geometry(const wrc_planar_pose& pose) noexcept { return detail::attempt_struct<wrc_planar_point>([&](wrc_planar_point& found_) { return this->planar_geometry(pose, found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_planar_point> planar_geometry(const wrc_planar_pose& pose) { return detail::value_or_throw(try_planar_geometry(pose), handle_); }
#endif
  /** wrc_planar_creepages() */
  status planar_creepages(const wrc_planar_motion& motion, wrc_creepage& creepage) noexcept { return wrc_planar_creepages(handle_, &motion, &creepage); }
  expected<answer<wrc_creepage>> try_planar_creepages(const wrc_planar_motion& motion) noexcept { return detail::attempt_struct<wrc_creepage>([&](wrc_creepage& found_) { return this->planar_creepages(motion, found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_creepage> planar_creepages(const wrc_planar_motion& motion) { return detail::value_or_throw(try_planar_creepages(motion), handle_); }
#endif
  /** wrc_planar_normal() */
  status planar_normal(const wrc_planar_gap* gap, const wrc_planar_load& load, wrc_planar_normal_solution& normal) noexcept { return wrc_planar_normal(handle_, gap, &load, &normal); }
  expected<answer<wrc_planar_normal_solution>> try_planar_normal(const wrc_planar_gap* gap, const wrc_planar_load& load) noexcept { return detail::attempt_struct<wrc_planar_normal_solution>([&](wrc_planar_normal_solution& found_) { return this->planar_normal(gap, load, found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_planar_normal_solution> planar_normal(const wrc_planar_gap* gap, const wrc_planar_load& load) { return detail::value_or_throw(try_planar_normal(gap, load), handle_); }
#endif
  /** wrc_planar_regularise() */
  status planar_regularise(const wrc_planar_strips* strips, wrc_planar_normal_solution& normal) noexcept { return wrc_planar_regularise(handle_, strips, &normal); }
  expected<answer<wrc_planar_normal_solution>> try_planar_regularise(const wrc_planar_strips* strips = nullptr) noexcept { return detail::attempt_struct<wrc_planar_normal_solution>([&](wrc_planar_normal_solution& found_) { return this->planar_regularise(strips, found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_planar_normal_solution> planar_regularise(const wrc_planar_strips* strips = nullptr) { return detail::value_or_throw(try_planar_regularise(strips), handle_); }
#endif
  /** wrc_planar_roll() */
  status planar_roll(double distance) noexcept { return wrc_planar_roll(handle_, distance); }
  /** wrc_planar_tangential() */
  status planar_tangential(const wrc_ellipse* ellipse, const wrc_creepage& creepage, const wrc_friction& friction, wrc_planar_forces& forces) noexcept { return wrc_planar_tangential(handle_, ellipse, &creepage, &friction, &forces); }
  expected<answer<wrc_planar_forces>> try_planar_tangential(const wrc_ellipse* ellipse, const wrc_creepage& creepage, const wrc_friction& friction) noexcept { return detail::attempt_struct<wrc_planar_forces>([&](wrc_planar_forces& found_) { return this->planar_tangential(ellipse, creepage, friction, found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_planar_forces> planar_tangential(const wrc_ellipse* ellipse, const wrc_creepage& creepage, const wrc_friction& friction) { return detail::value_or_throw(try_planar_tangential(ellipse, creepage, friction), handle_); }
#endif
  /** wrc_planar_tangential_derivatives() */
  status planar_tangential_derivatives(wrc_planar_derivatives& derivatives) noexcept { return wrc_planar_tangential_derivatives(handle_, &derivatives); }
  expected<answer<wrc_planar_derivatives>> try_planar_tangential_derivatives() noexcept { return detail::attempt_struct<wrc_planar_derivatives>([&](wrc_planar_derivatives& found_) { return this->planar_tangential_derivatives(found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_planar_derivatives> planar_tangential_derivatives() { return detail::value_or_throw(try_planar_tangential_derivatives(), handle_); }
#endif
  /** wrc_contact_wear(); may change in a minor version */
  status wear(std::int32_t index, const wrc_wear_laws* laws, wrc_wear& wear) noexcept { return wrc_contact_wear(handle_, index, laws, &wear); }
  expected<answer<wrc_wear>> try_wear(std::int32_t index, const wrc_wear_laws* laws = nullptr) noexcept { return detail::attempt_struct<wrc_wear>([&](wrc_wear& found_) { return this->wear(index, laws, found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_wear> wear(std::int32_t index, const wrc_wear_laws* laws = nullptr) { return detail::value_or_throw(try_wear(index, laws), handle_); }
#endif
  /** wrc_contact_temperature(); may change in a minor version */
  status temperature(std::int32_t index, const wrc_bulk_temperatures* bulk, wrc_temperature& temperature) noexcept { return wrc_contact_temperature(handle_, index, bulk, &temperature); }
  expected<answer<wrc_temperature>> try_temperature(std::int32_t index, const wrc_bulk_temperatures* bulk = nullptr) noexcept { return detail::attempt_struct<wrc_temperature>([&](wrc_temperature& found_) { return this->temperature(index, bulk, found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_temperature> temperature(std::int32_t index, const wrc_bulk_temperatures* bulk = nullptr) { return detail::value_or_throw(try_temperature(index, bulk), handle_); }
#endif
  /** wrc_contact_stresses(); may change in a minor version */
  status stresses(std::int32_t index, std::int32_t body, const double* depths, std::uint32_t count, wrc_stress_peaks* levels, wrc_stresses* stresses) noexcept { return wrc_contact_stresses(handle_, index, body, depths, count, levels, stresses); }
  /** wrc_contact_accumulate(); may change in a minor version */
  status accumulate(const wrc_accumulation& accumulation, wrc_damage_bins* wheel, wrc_damage_bins* rail, wrc_damage_totals* totals) noexcept { return wrc_contact_accumulate(handle_, &accumulation, wheel, rail, totals); }
  /** wrc_exact_gap(); may change in a minor version */
  status exact_gap(const wrc_grid& grid, double* gap) noexcept { return wrc_exact_gap(handle_, &grid, gap); }
  /** wrc_exact_check(); may change in a minor version */
  status exact_check(const wrc_exact_check_options* options, wrc_exact_check_result& result) noexcept { return wrc_exact_check(handle_, options, &result); }
  expected<answer<wrc_exact_check_result>> try_exact_check(const wrc_exact_check_options* options = nullptr) noexcept { return detail::attempt_struct<wrc_exact_check_result>([&](wrc_exact_check_result& found_) { return this->exact_check(options, found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_exact_check_result> exact_check(const wrc_exact_check_options* options = nullptr) { return detail::value_or_throw(try_exact_check(options), handle_); }
#endif
  /** wrc_exact_wrench(); may change in a minor version */
  status exact_wrench(const wrc_wheel_input& input, const wrc_exact_wrench_options* options, wrc_wrench& wrench) noexcept { return wrc_exact_wrench(handle_, &input, options, &wrench); }
  expected<answer<wrc_wrench>> try_exact_wrench(const wrc_wheel_input& input, const wrc_exact_wrench_options* options = nullptr) noexcept { return detail::attempt_struct<wrc_wrench>([&](wrc_wrench& found_) { return this->exact_wrench(input, options, found_); }); }
#ifdef WRC_EXCEPTIONS
  answer<wrc_wrench> exact_wrench(const wrc_wheel_input& input, const wrc_exact_wrench_options* options = nullptr) { return detail::value_or_throw(try_exact_wrench(input, options), handle_); }
#endif
  /** wrc_fit_creep_curve(); may change in a minor version */
  status fit_creep_curve(const wrc_creep_curve& curve, wrc_creep_fit& fit, double* adhesion) noexcept { return wrc_fit_creep_curve(handle_, &curve, &fit, adhesion); }

 protected:
  wrc_contact* handle_ = nullptr;
};

}  // namespace detail

}  // namespace wrc
