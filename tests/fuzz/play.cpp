#include "play.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ctime>
#include <vector>

#include "field_values.hpp"
#include "inputs.hpp"
#include "test_config.hpp"
#include "versions.hpp"
#include "wrc/wrc_surface.h"

namespace hostile {
namespace {

/// The members of a struct that are doubles: all of them from `first` on.
template <typename Struct>
std::vector<double> doubles_from(const Struct& value, const double& first) {
  const auto* begin = &first;
  const auto offset =
      static_cast<std::size_t>(reinterpret_cast<const char*>(begin) - reinterpret_cast<const char*>(&value));
  std::vector<double> values((sizeof value - offset) / sizeof(double));
  std::memcpy(values.data(), reinterpret_cast<const char*>(&value) + offset, values.size() * sizeof(double));
  return values;
}

std::vector<double> all_doubles(const wrc_planar_output& results) {
  std::vector<double> all = doubles_from(results.point, results.point.x);
  for (const auto& each :
       {doubles_from(results.normal, results.normal.ellipse.a),
        doubles_from(results.forces, results.forces.fx), doubles_from(results.damage, results.damage.power)})
    all.insert(all.end(), each.begin(), each.end());
  return all;
}

/// The values of a field of one patch, or nothing when it has not been computed.
std::vector<double> field_of_patch(wrc_contact* contact, std::int32_t patch, std::int32_t id) {
  const FieldValues found = field_values(contact, patch, id);
  return found.status == WRC_OK ? found.values : std::vector<double>{};
}

/// The same over all patches.
std::vector<double> field(wrc_contact* contact, std::int32_t id) {
  const bool of_gap = id >= WRC_FIELD_GAP_Y && id <= WRC_FIELD_GAP_CURVATURE;
  const std::int32_t patches = of_gap ? 1 : 16;
  std::vector<double> values;
  for (std::int32_t patch = 0; patch < patches; ++patch) {
    const std::vector<double> own = field_of_patch(contact, patch, id);
    if (own.empty()) break;
    values.insert(values.end(), own.begin(), own.end());
  }
  return values;
}

bool all_finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}
bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

/// The statuses a call on a contact with valid handles and struct sizes may end with.
bool documented(std::int32_t status) {
  switch (status) {
    case WRC_OK:
    case WRC_FLAG_NO_CONTACT:
    case WRC_FLAG_ITERATION_CAP:
    case WRC_FLAG_PATCH_AT_EDGE:
    case WRC_FLAG_MORE_PATCHES:
    case WRC_FLAG_TABLE_RANGE:
    case WRC_FLAG_CREEPAGES_LIMITED:
    case WRC_FLAG_LOAD_JUMPS:
    case WRC_FLAG_BEYOND_GAP:
    case WRC_FLAG_CLIMBING:
    case WRC_FLAG_BEYOND_SECTIONS:
    case WRC_FLAG_FORCE_JUMPS:
    case WRC_FLAG_ROTATION_TRANSPOSED:
    case WRC_ERROR_NOT_FINITE:
    case WRC_ERROR_RANGE:
    case WRC_ERROR_GAP:
    case WRC_ERROR_LOAD:
    case WRC_ERROR_SEQUENCE:
    case WRC_ERROR_UNSUPPORTED:
      return true;
    default:
      return false;
  }
}

class Case {
 public:
  Case(Choices& choices, const Size& size) : choices_(choices), size_(size) {}
  ~Case() {
    wrc_contact_destroy(contact_);
    wrc_model_destroy(model_);
  }
  Case(const Case&) = delete;
  Case& operator=(const Case&) = delete;

  Verdict play() {
    ProfilePoints wheel, rail;
    make_wheel(choices_, wheel);
    make_rail(choices_, rail);
    config_ = make_config(choices_, size_.finest, wheel.profile, rail.profile);
    make_along_track(choices_, config_, along_track_);
    side_ = static_cast<std::int32_t>(choices_.below(2));
    const std::int32_t status =
        hand_over([&] { return wrc_model_create(&config_, nullptr, &model_, nullptr, 0); });
    if (choices_.one_in(8)) config_of_another_header(status);
    if (status < WRC_OK) {
      expect(model_ == nullptr, "a refused model is NULL");
      expect(status == WRC_ERROR_PROFILE || status == WRC_ERROR_NOT_FINITE || status == WRC_ERROR_RANGE ||
                 status == WRC_ERROR_UNSUPPORTED || status == WRC_ERROR_STRUCT_SIZE,
             "a model is refused with a documented status");
      return verdict_;
    }
    const bool alike = config_.wheel_material.shear_modulus == config_.rail_material.shear_modulus &&
                       config_.wheel_material.poisson == config_.rail_material.poisson;
    expect(status == WRC_OK || (status == WRC_FLAG_DISSIMILAR_MATERIALS && !alike),
           "a model is made without a flag, or of different materials");
    verdict_.model_made = true;
    if (!expect(wrc_contact_create(model_, side_, nullptr, &contact_, nullptr, 0) == WRC_OK,
                "a contact can be made"))
      return verdict_;
    check_profiles();

    const std::vector<double> good = good_step();
    const std::uint32_t calls = size_.shallow ? size_.calls : 1 + choices_.below(size_.calls);
    for (std::uint32_t i = 0; i < calls; ++i) call();
    const std::vector<double> again = good_step();
    // A warm start may come from another patch: then the last digits depend on the past.
    if (config_.planar.start == 0) expect(same_bits(good, again), "a later good step gives the same bits");
    return verdict_;
  }

 private:
  bool expect(bool holds, const char* property) {
    if (!holds && verdict_.broken.empty()) verdict_.broken = std::string(where_) + ": not so: " + property;
    return holds;
  }

  template <typename Call>
  std::int32_t hand_over(Call&& work) {
    ++verdict_.inputs;
    return timed(work);
  }

  template <typename Call>
  std::int32_t timed(Call&& work) {
    const std::clock_t start = std::clock();
    const std::int32_t status = work();
    const double took = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    verdict_.slowest_call = std::max(verdict_.slowest_call, took);
    return status;
  }

  /// An ordinary step, to be repeated later: every number of it, fields included, and its statuses.
  std::vector<double> good_step() {
    constexpr std::uint32_t rows = 8;  // every model has room for so many
    double y[rows], height[rows], curvature[rows];
    for (std::uint32_t j = 0; j < rows; ++j) {
      y[j] = -0.01 + 0.02 * j / (rows - 1);
      height[j] = 0.5 * y[j] * y[j] / 0.3;
      curvature[j] = 1.0 / 0.46;
    }
    wrc_planar_gap gap = sized<wrc_planar_gap>();
    gap.row_count = rows;
    gap.y = y;
    gap.height = height;
    gap.curvature = curvature;
    wrc_planar_input input = wrc_planar_input_default();
    input.load.normal_force = 80e3;
    input.creepage.longitudinal = 1e-3;
    input.creepage.spin = 0.3;
    std::vector<double> all;
    for (const wrc_planar_gap* each :
         {static_cast<const wrc_planar_gap*>(&gap), static_cast<const wrc_planar_gap*>(nullptr)}) {
      if (each == nullptr && config_.wheel.kind == WRC_PROFILE_NONE) continue;
      input.gap = each;
      wrc_planar_output results = sized<wrc_planar_output>();
      where_ = each != nullptr ? "good step with a gap" : "good step with a pose";
      const std::int32_t status = timed([&] { return wrc_planar_step(contact_, &input, &results); });
      check_step(status, results, input.load, input.creepage, input.friction.coefficient);
      all.push_back(status);
      for (double value : all_doubles(results)) all.push_back(value);
      for (std::int32_t id = 0; id <= WRC_FIELD_GAP_CURVATURE; ++id)
        for (double value : field(contact_, id)) all.push_back(value);
    }
    return all;
  }

  /// The curves the model uses: heights over a y that increases, at a stated distance from the points.
  void check_profiles() {
    where_ = "profiles of the model";
    for (std::int32_t body : {WRC_BODY_WHEEL, WRC_BODY_RAIL}) {
      wrc_view y{}, z = wrc_view{};
      double deviation = -1.0;
      const std::int32_t status = wrc_model_profile(model_, side_, body, &y, &z, &deviation);
      expect(status == (config_.wheel.kind != WRC_PROFILE_NONE ? WRC_OK : WRC_ERROR_SEQUENCE),
             "a model shows its profiles");
      expect(std::isfinite(deviation) && deviation >= 0.0, "the deviation is a distance");
      for (std::uint64_t i = 0; i < y.count; ++i) {
        expect(std::isfinite(y.data[i]) && std::isfinite(z.data[i]), "every node is finite");
        expect(i == 0 || y.data[i] > y.data[i - 1], "y increases from node to node");
      }
    }
  }

  /// Wear of whatever is in the contact.
  void wear() {
    where_ = "wear";
    const wrc_wear_laws laws = make_wear_laws(choices_);
    wrc_wear result{};
    const std::int32_t status = hand_over([&] {
      return wrc_contact_wear(contact_, WRC_ALL_REGIONS, choices_.one_in(4) ? nullptr : &laws, &result);
    });
    expect(documented(status), "the status is documented for this call");
    for (double rate : {result.worn_area_rate, result.largest_depth_rate, result.largest_depth_velocity}) {
      expect(std::isfinite(rate) && rate >= 0.0, "wear takes away");
      expect(status >= 0 || rate == 0.0, "outputs of a failed call are zero");
    }
    for (double rate : field(contact_, WRC_FIELD_STRIP_WEAR))
      expect(std::isfinite(rate) && rate >= 0.0, "no strip grows");
  }

  /// A wheel over films: sources, passages and friction of any numbers; books balance, friction is some.
  void films() {
    where_ = "films";
    std::vector<wrc_surface_bin> rail_bin, wheel_bin;
    double across[WRC_FILM_NUMBERS(WRC_MOST_FILM_ROWS, WRC_MOST_FILM_ROWS)];
    wrc_surface rail = wrc_surface_default(), wheel = wrc_surface_default();
    for (const auto& [surface, bins] : {std::pair{&rail, &rail_bin}, std::pair{&wheel, &wheel_bin}}) {
      surface->count = static_cast<std::uint32_t>(1 + choices_.below(30));
      if (choices_.one_in(2))
        surface->rows = static_cast<std::uint32_t>(choices_.below(WRC_MOST_FILM_ROWS + 1));
      surface->row_first = choices_.between(-0.1, 0.1);
      bins->resize(std::size_t{surface->count} * std::max(1U, surface->rows));
      surface->length = choices_.magnitude(1e-3, 1e4);
      surface->first = choices_.signed_magnitude(1e-3, 1e3);
      surface->closed = choices_.below(2);
      surface->bins = bins->data();
      surface->bin_size = sizeof(wrc_surface_bin);
    }
    if (choices_.one_in(12)) rail.width = choices_.poison();
    wrc_surface_laws laws = wrc_surface_laws_default();
    wrc_surface_laws_use(&laws, choices_.one_in(2) ? "low adhesion" : "low adhesion, layers", nullptr, 0);
    if (choices_.one_in(3)) laws.film.carry = choices_.between(0.0, 1.0);
    if (choices_.one_in(12)) laws.sand.removal = choices_.poison();
    for (int k = 0; k < 6; ++k) {
      const double from = choices_.signed_magnitude(1e-3, 1e4), way = choices_.magnitude(1e-6, 1e3);
      const double amount = choices_.one_in(12) ? choices_.poison() : choices_.magnitude(1e-9, 100.0);
      const auto quantity = static_cast<std::int32_t>(choices_.below(WRC_SURFACE_QUANTITIES + 1));
      film_status(wrc_surface_add(&rail, quantity, amount, from, from + way, sentence_, sizeof sentence_));
      wrc_surface_passage passage = sized<wrc_surface_passage>();
      passage.rail_from = choices_.signed_magnitude(1e-3, 1e4);
      passage.rail_to = passage.rail_from + choices_.signed_magnitude(1e-6, 1e3);
      passage.wheel_from = choices_.signed_magnitude(1e-3, 1e4);
      passage.wheel_to = passage.wheel_from + choices_.signed_magnitude(1e-6, 1e3);
      passage.energy = choices_.one_in(12) ? choices_.poison() : choices_.magnitude(1e-9, 1e9);
      passage.film_rows = across;
      passage.film_numbers = static_cast<std::uint32_t>(std::size(across));
      passage.contact = choices_.one_in(6) ? nullptr : contact_;
      wrc_friction friction = wrc_friction_default();
      wrc_surface* const rolls = choices_.one_in(6) ? nullptr : &wheel;
      film_status(wrc_surface_friction(&rail, rolls, &laws, &passage, nullptr, &friction, sentence_,
                                       sizeof sentence_));
      expect(friction.coefficient >= 1e-4 && friction.coefficient <= 2.0 && friction.layer_yield >= 0.0 &&
                 friction.layer_yield <= 1e11 && std::isfinite(friction.layer_modulus) &&
                 friction.bulk.rail <= 2000.0,
             "films give friction that a contact takes");
      film_status(wrc_surface_pass(&rail, rolls, &laws, &passage, nullptr, sentence_, sizeof sentence_));
      film_status(
          wrc_surface_rest(&wheel, &laws, choices_.magnitude(1e-6, 1e6), sentence_, sizeof sentence_));
    }
    for (std::int32_t quantity = 0; quantity < WRC_SURFACE_QUANTITIES; ++quantity) {
      double book[WRC_SURFACE_BOOKS] = {};
      for (std::int32_t k = 0; k < WRC_SURFACE_BOOKS; ++k)
        wrc_surface_values(&rail, quantity, k, nullptr, &book[k], nullptr, 0);
      const double gone = book[2] + book[3] + book[4] + book[5];
      expect(book[0] >= 0.0 && std::fabs(book[1] - gone - book[0]) <=
                                   1e-12 * (std::fabs(book[1]) + std::fabs(book[5]) + std::fabs(book[4])),
             "amounts are what was put on less what is gone");
    }
  }

  /// A call on films was done, or says in a sentence why not.
  void film_status(std::int32_t status) {
    expect(documented(status), "the status is documented for this call");
    expect((status == WRC_OK) == (sentence_[0] == '\0'), "a status has a sentence");
  }

  /// Temperatures of whatever is in the contact.
  void temperatures() {
    where_ = "temperatures";
    wrc_bulk_temperatures bulk = wrc_bulk_temperatures_default();
    if (choices_.one_in(2)) bulk.wheel = choices_.between(-273.0, 2000.0);
    if (choices_.one_in(20)) bulk.rail = choices_.poison();
    wrc_temperature result = sized<wrc_temperature>();
    const std::int32_t status = hand_over([&] {
      return wrc_contact_temperature(contact_, WRC_ALL_REGIONS, choices_.one_in(4) ? nullptr : &bulk,
                                     &result);
    });
    expect(documented(status), "the status is documented for this call");
    for (double value : {result.at_entry, result.rise, result.x, result.y, result.largest, result.mean_rise,
                         result.wheel_heat, result.rail_heat})
      expect(std::isfinite(value), "every number is finite");
    expect(result.rise >= 0.0 && result.mean_rise <= result.rise * (1.0 + 1e-9), "friction heats");
    expect(status >= 0 || result.largest == 0.0, "outputs of a failed call are zero");
    for (double rise : field(contact_, WRC_FIELD_TEMPERATURE_RISE))
      expect(std::isfinite(rise) && rise >= 0.0, "no cell is cooled by friction");
  }

  /// Creepages at whatever contact point is in the contact.
  void creepages() {
    where_ = "creepages";
    const wrc_planar_motion motion = make_motion(choices_);
    wrc_creepage result = wrc_creepage_default();
    const std::int32_t status = hand_over([&] { return wrc_planar_creepages(contact_, &motion, &result); });
    expect(documented(status), "the status is documented for this call");
    for (double value : doubles_from(result, result.longitudinal)) {
      expect(std::isfinite(value), "every creepage is finite");
      expect(status >= 0 || value == 0.0, "outputs of a failed call are zero");
    }
    expect(std::fabs(result.longitudinal) <= 10.0 && std::fabs(result.lateral) <= 10.0 &&
               std::fabs(result.spin) <= 1e3 && std::fabs(result.speed) <= 200.0 &&
               result.reverse_share >= 0.0 && result.reverse_share <= 0.5,
           "wrc_planar_tangential takes the creepages");
  }

  void call() {
    switch (choices_.below(12)) {
      case 11:
        return structs_of_other_headers();
      case 8:
      case 9:
      case 10:
        if (size_.shallow && !choices_.one_in(16)) return stages_in_any_order();
        return wheel_on_rail();
      case 0:
        return caller_patch();
      case 1:
        return caller_strips();
      case 2:
        return stages_in_any_order();
      case 3:
      case 4:
        return step(false);
      default:
        return step(config_.wheel.kind != WRC_PROFILE_NONE);
    }
  }

  /// The configuration of a program with another header, beside what became of that with ours.
  void config_of_another_header(std::int32_t status) {
    where_ = "configuration of another header";
    OfAnotherHeader<wrc_config> config(choices_, config_);
    char text[256] = "";
    const std::int32_t found = hand_over([&] { return wrc_config_check(config.get(), text, sizeof text); });
    expect(found == (config.is_readable() ? status : std::int32_t{WRC_ERROR_STRUCT_SIZE}),
           "it is taken as ours, or refused by its size");
    expect((found < 0) == (text[0] != '\0') || found > 0, "a refusal has a sentence");
    where_ = "model";
  }

  /// Inputs and results of a program with another header: the same results, or refused by their size.
  void structs_of_other_headers() {
    where_ = "structs of other headers";
    if (config_.wheel.kind != WRC_PROFILE_NONE && !size_.shallow) {
      wrc_wheel_input given;
      make_wheel_on_rail(choices_, config_, given);
      given.start = WRC_START_COLD;
      same_of_another_header<wrc_wheel_input, wrc_wrench>(given, wrc_contact_wrench, true);
    }
    wrc_planar_input given = wrc_planar_input_default();
    GapArrays gap;
    make_gap(choices_, config_.planar.gap_rows, gap);
    given.gap = &gap.gap;
    given.load = make_load(choices_);
    given.creepage = make_creepage(choices_);
    // Warm sweeps begin from the step before.
    const bool cold = config_.planar.start == WRC_START_COLD;
    same_of_another_header<wrc_planar_input, wrc_planar_output>(given, wrc_planar_step, cold);
    OfAnotherHeader<wrc_region> region(choices_, sized<wrc_region>());
    wrc_region ours = sized<wrc_region>();
    const std::int32_t status = wrc_contact_region(contact_, 0, &ours);
    const std::int32_t found = wrc_contact_region(contact_, 0, region.get());
    expect(found == (region.has_a_size() ? status : std::int32_t{WRC_ERROR_STRUCT_SIZE}),
           "a region is given as ours, or refused by its size");
    expect(!region.has_a_size() || region.holds(ours), "a region of another header has the same numbers");
  }

  template <typename Input, typename Result, typename Call>
  void same_of_another_header(const Input& given, const Call& call, bool repeatable) {
    Result ours = sized<Result>();
    const std::int32_t status = hand_over([&] { return call(contact_, &given, &ours); });
    OfAnotherHeader<Input> input(choices_, given);
    OfAnotherHeader<Result> result(choices_, sized<Result>());
    const std::int32_t found = hand_over([&] { return call(contact_, input.get(), result.get()); });
    if (!input.is_readable() || !result.has_a_size()) {
      expect(found == WRC_ERROR_STRUCT_SIZE, "it is refused by its size");
      char text[256] = "";
      expect(wrc_contact_last_error(contact_, text, sizeof text) == WRC_OK && text[0] != '\0',
             "an error has a sentence");
      expect(!result.has_a_size() || result.holds(Result{}), "results of a refused call are zero");
      return;
    }
    if (!repeatable) return;
    expect(found == status, "the same call of another header has the same status");
    expect(result.holds(ours), "the same call of another header gives the same bits");
  }

  void step(bool with_pose) {
    where_ = with_pose ? "step with a pose" : "step with a gap";
    wrc_planar_input input = wrc_planar_input_default();
    input.pose = make_pose(choices_);
    GapArrays gap;
    if (!with_pose) {
      make_gap(choices_, config_.planar.gap_rows, gap);
      input.gap = &gap.gap;
      input.pose = sized<wrc_planar_pose>();
    }
    input.load = make_load(choices_);
    input.creepage = make_creepage(choices_);
    FrictionArrays given;
    make_friction(choices_, given);
    input.friction = given.friction;
    wrc_planar_output results = sized<wrc_planar_output>();
    const std::int32_t status = hand_over([&] { return wrc_planar_step(contact_, &input, &results); });
    check_step(status, results, input.load, input.creepage, given.most());
    if (choices_.one_in(2)) wear();
    if (choices_.one_in(2)) temperatures();
    if (choices_.one_in(2)) creepages();
    if (choices_.one_in(8)) films();
  }

  /// Ellipse, damage and one field of a region.
  void ask_region(std::int32_t index, const wrc_region& region) {
    const wrc_ellipse& ellipse = region.ellipse;
    wrc_damage damage{};
    expect(wrc_contact_damage(contact_, index, &damage) == WRC_OK, "a region has damage numbers");
    wrc_temperature temperature = sized<wrc_temperature>();
    const std::int32_t heated = wrc_contact_temperature(contact_, index, nullptr, &temperature);
    expect(heated == WRC_OK || heated == WRC_ERROR_UNSUPPORTED,
           "a region has temperatures, or whole patches");
    expect(
        std::isfinite(temperature.rise) && std::isfinite(temperature.wheel_heat) && temperature.rise >= 0.0,
        "temperatures of a region are finite");
    expect(all_finite(doubles_from(ellipse, ellipse.a)) && std::isfinite(damage.local_fatigue_index) &&
               std::isfinite(damage.peak_power_density) && std::isfinite(damage.fatigue_index),
           "ellipse and damage of a region are finite");
    expect(std::fabs(ellipse.psi) <= 0.95 && ellipse.a > 0.0 && ellipse.b > 0.0, "an ellipse is one");
    const auto which = static_cast<std::int32_t>(choices_.below(WRC_FIELD_STRIP_ANGLE + 1));
    const auto strips = static_cast<std::size_t>(region.strip_count),
               cells = static_cast<std::size_t>(region.cell_count);
    const bool of_cells = which < WRC_FIELD_STRIP_Y;
    std::vector<double> values(of_cells ? strips * cells : strips);
    const std::int32_t shown =
        wrc_contact_field(contact_, index, which, values.data(), values.size(), nullptr);
    expect(shown == WRC_OK ||
               (shown == WRC_ERROR_UNSUPPORTED && config_.tangential.method != WRC_TANGENTIAL_STRIP_FASTSIM),
           "a region has that field, or its method has none");
    expect(all_finite(values), "fields of regions are finite");
  }

  /// A wheel on a rail, one call or two: the same twice has the same bits.
  void wheel_on_rail() {
    where_ = "wheel on rail";
    wrc_wheel_input given;
    make_wheel_on_rail(choices_, config_, given);
    wrc_wrench wrench = sized<wrc_wrench>(), again = wrench;
    const std::int32_t status = hand_over([&] { return wrc_contact_wrench(contact_, &given, &wrench); });
    const bool supported = config_.wheel.kind != WRC_PROFILE_NONE;
    expect(documented(status), "the status is documented for this call");
    expect(supported || status < 0, "without profiles it refuses");
    const std::vector<double> all = doubles_from(wrench, wrench.force[0]);
    expect(all_finite(all), "every output is finite");
    const auto zero = [](double value) { return value == 0.0; };
    if (status < 0) {
      expect(std::all_of(all.begin(), all.end(), zero) && wrench.region_count == 0,
             "outputs of a failed call are zero");
      char text[256] = "";
      expect(wrc_contact_last_error(contact_, text, sizeof text) == WRC_OK && text[0] != '\0',
             "an error has a sentence");
      return;
    }
    check_flags(status, wrench.flags);
    expect(wrench.power >= 0.0 && wrench.area >= 0.0 && wrench.peak_pressure >= 0.0 &&
               wrench.normal_force >= 0.0,
           "areas, pressures and power are not negative");
    expect((wrench.region_count > 0) == (status != WRC_FLAG_NO_CONTACT) || status == WRC_FLAG_CLIMBING,
           "bodies that touch do so in regions");
    if (wrench.region_count == 0) {
      expect(std::all_of(wrench.force, wrench.force + 3, zero), "apart there is no force");
    }
    if (wrench.normal_force > 0.0) ++verdict_.solved;
    double force[3] = {};
    for (std::int32_t i = 0; i < wrench.region_count; ++i) {
      wrc_region region = sized<wrc_region>();
      const std::int32_t seen = wrc_contact_region(contact_, i, &region);
      expect(seen == WRC_OK || seen == WRC_FLAG_TABLE_RANGE, "every region can be seen");
      expect(all_finite(doubles_from(region, region.point[0])), "every number of each region is finite");
      for (int k = 0; k < 3; ++k) force[k] += region.force[k];
      ask_region(i, region);
    }
    const double size = std::fabs(wrench.force[0]) + std::fabs(wrench.force[1]) + std::fabs(wrench.force[2]);
    for (int k = 0; k < 3; ++k) {
      expect(std::fabs(force[k] - wrench.force[k]) <= 1e-9 * size, "regions add up to the wrench");
    }
    wrc_wrench_derivatives found = sized<wrc_wrench_derivatives>();
    hand_over([&] { return wrc_contact_wrench_derivatives(contact_, &given, nullptr, &found); });
    expect(std::all_of(&found.wrench[0][0], &found.wrench[0][0] + 6 * WRC_WRENCH_INPUTS,
                       [](double entry) { return std::isfinite(entry); }),
           "every derivative is finite");
    if (given.start != WRC_START_COLD || !choices_.one_in(4)) return;
    expect(wrc_contact_wrench(contact_, &given, &again) == status, "the same call has the same status");
    expect(std::memcmp(&wrench, &again, sizeof wrench) == 0, "the same call gives the same bits");
  }

  void caller_patch() {
    where_ = "tangential on a patch of the caller";
    const wrc_ellipse ellipse = make_ellipse(choices_);
    const wrc_creepage creepage = make_creepage(choices_);
    FrictionArrays given;
    make_friction(choices_, given);
    const wrc_friction& friction = given.friction;
    wrc_planar_output results = sized<wrc_planar_output>();
    std::int32_t status = hand_over(
        [&] { return wrc_planar_tangential(contact_, &ellipse, &creepage, &friction, &results.forces); });
    if (status >= 0)
      status = std::max(status, wrc_contact_damage(contact_, WRC_ALL_REGIONS, &results.damage));
    check_results(status, results, given.most());
  }

  void caller_strips() {
    where_ = "strips of the caller";
    StripArrays strips;
    make_strips(choices_, config_.planar.strips, strips);
    const wrc_creepage creepage = make_creepage(choices_);
    FrictionArrays given;
    make_friction(choices_, given);
    const wrc_friction& friction = given.friction;
    wrc_planar_output results = sized<wrc_planar_output>();
    std::int32_t status =
        hand_over([&] { return wrc_planar_regularise(contact_, &strips.strips, &results.normal); });
    check_results(status, results, given.most());
    if (status < 0) return;
    wrc_planar_output rolling = sized<wrc_planar_output>();
    status = hand_over(
        [&] { return wrc_planar_tangential(contact_, nullptr, &creepage, &friction, &rolling.forces); });
    if (status >= 0)
      status = std::max(status, wrc_contact_damage(contact_, WRC_ALL_REGIONS, &rolling.damage));
    check_results(status, rolling, given.most());
  }

  /// Whatever the order: results or WRC_ERROR_SEQUENCE.
  void stages_in_any_order() {
    where_ = "stages in any order";
    for (int i = 0; i < 4; ++i) {
      const wrc_planar_pose pose = make_pose(choices_);
      const wrc_planar_load load = make_load(choices_);
      const wrc_creepage creepage = make_creepage(choices_);
      FrictionArrays given;
      make_friction(choices_, given);
      const wrc_friction& friction = given.friction;
      wrc_planar_output results = sized<wrc_planar_output>();
      std::int32_t status = WRC_OK;
      switch (choices_.below(7)) {
        case 0:
          status = hand_over([&] { return wrc_planar_geometry(contact_, &pose, &results.point); });
          break;
        case 1:
          status = hand_over([&] { return wrc_planar_normal(contact_, nullptr, &load, &results.normal); });
          break;
        case 2:
          status = timed([&] { return wrc_planar_regularise(contact_, nullptr, &results.normal); });
          break;
        case 3:
          status = hand_over([&] {
            return wrc_planar_tangential(contact_, nullptr, &creepage, &friction, &results.forces);
          });
          break;
        case 4:
          wear();
          break;
        case 5:
          creepages();
          break;
        default:
          status = timed([&] { return wrc_contact_damage(contact_, WRC_ALL_REGIONS, &results.damage); });
      }
      check_results(status, results, given.most());
    }
  }

  /// The status is one of the flags, and OK where there is none.
  void check_flags(std::int32_t status, std::uint32_t flags) {
    expect(status == WRC_OK ? flags == 0 : (flags & WRC_FLAG_BIT(status)) != 0,
           "the status is one of the flags");
  }

  /// What must hold after a step.
  void check_step(std::int32_t status, const wrc_planar_output& results, const wrc_planar_load& load,
                  const wrc_creepage& creepage, double friction) {
    check_results(status, results, friction);
    if (status < 0) return;
    check_flags(status, results.flags);
    if (load.prescribed == WRC_PRESCRIBE_NORMAL_FORCE) {
      expect(results.forces.fn > 0.0, "a prescribed load presses the bodies together");
      // The tolerance of the configuration, and what finite numbers allow.
      expect(std::fabs(results.forces.fn - load.normal_force) <=
                 (2.0 * config_.normal.load_tolerance + 1e-9) * load.normal_force,
             "the prescribed load is met");
    }
    if (creepage.reverse_share > 0.0) return;  // the fields are those of one way
    // Where every cell with friction sticks the field has no power; force times creepage may leave a trace.
    const double allowed = 1e-6 * results.damage.power + 1e-9 * friction * results.forces.fn;
    expect(std::fabs(results.forces.power - results.damage.power - power_of_sticking_patches()) <= allowed,
           "power of the forces and of the field agree");
  }

  /// Of patches that stick wherever they have friction, but for those whose field has power all the same [W].
  double power_of_sticking_patches() {
    double power = 0.0;
    for (std::int32_t each = 0; each < 16; ++each) {
      wrc_region one = sized<wrc_region>();
      if (wrc_contact_region(contact_, each, &one) != WRC_OK) break;
      const bool sticks = one.adhesion_fraction >= share_with_friction(each) * (1.0 - 1e-12);
      const std::vector<double> strip_power = field_of_patch(contact_, each, WRC_FIELD_STRIP_POWER);
      const bool dissipates =
          std::any_of(strip_power.begin(), strip_power.end(), [](double value) { return value > 0.0; });
      if (sticks && !strip_power.empty() && !dissipates) power += one.power;
    }
    return power;
  }

  /// Share of a patch's area on which there is friction; 1 with a method that does not show it.
  double share_with_friction(std::int32_t patch) {
    const std::vector<double> friction = field_of_patch(contact_, patch, WRC_FIELD_STRIP_FRICTION),
                              width = field_of_patch(contact_, patch, WRC_FIELD_STRIP_WIDTH),
                              half_length = field_of_patch(contact_, patch, WRC_FIELD_STRIP_HALF_LENGTH);
    double area = 0.0, with_friction = 0.0;
    for (std::size_t j = 0; j < friction.size(); ++j) {
      area += width[j] * half_length[j];
      if (friction[j] > 0.0) with_friction += width[j] * half_length[j];
    }
    return area > 0.0 ? with_friction / area : 1.0;
  }

  /// What must hold after any call.
  void check_results(std::int32_t status, const wrc_planar_output& results, double friction) {
    expect(documented(status), "the status is documented for this call");
    const std::vector<double> all = all_doubles(results);
    expect(all_finite(all), "every output is finite");
    if (status < 0) {
      expect(std::all_of(all.begin(), all.end(), [](double value) { return value == 0.0; }),
             "outputs of a failed call are zero");
      char text[256] = "";
      expect(wrc_contact_last_error(contact_, text, sizeof text) == WRC_OK && text[0] != '\0',
             "an error has a sentence");
    }
    const wrc_planar_forces& forces = results.forces;
    expect(forces.fn >= 0.0, "the normal force is compressive");
    constexpr double rounding = 1e-9;
    expect(std::hypot(forces.fx, forces.fy) <= friction * forces.fn * (1.0 + rounding) || forces.fn == 0.0,
           "creep forces stay within friction");
    expect(forces.power >= 0.0, "frictional power is not negative");
    expect(forces.adhesion_fraction >= 0.0 && forces.adhesion_fraction <= 1.0 + 1e-12, "adhesion is a share");
    expect(results.damage.power >= 0.0 && results.damage.peak_power_density >= 0.0, "power is not negative");
    const wrc_planar_normal_solution& normal = results.normal;
    expect(std::fabs(normal.ellipse.psi) < 1.0, "the shape number is within -1 .. 1");
    expect(normal.area >= 0.0 && normal.peak_pressure >= 0.0 && normal.y_max >= normal.y_min,
           "the patch is a patch");
    expect(normal.normal_force - normal.damping_force >= 0.0, "the elastic force is compressive");
    if (normal.normal_force > 0.0) {
      expect(
          normal.ellipse.a > 0.0 && normal.ellipse.b > 0.0 && normal.area > 0.0 && normal.peak_pressure > 0.0,
          "a loaded patch has a size");
    }
    if (forces.fn > 0.0) ++verdict_.solved;
    if (size_.shallow && !choices_.one_in(8)) return;
    for (std::int32_t each = 0; each < 16; ++each) {
      wrc_region one = sized<wrc_region>();
      if (wrc_contact_region(contact_, each, &one) != WRC_OK) break;
      expect(all_finite(doubles_from(one, one.point[0])), "every number of each patch is finite");
    }
    for (std::int32_t id = 0; id <= WRC_FIELD_GAP_CURVATURE; ++id) {
      const std::vector<double> values = field(contact_, id);
      expect(all_finite(values), "every field is finite");
      if (id == WRC_FIELD_PRESSURE || id == WRC_FIELD_POWER_DENSITY || id == WRC_FIELD_STRIP_POWER) {
        expect(std::all_of(values.begin(), values.end(), [](double value) { return value >= 0.0; }),
               "pressure and power are nowhere negative");
      }
    }
  }

  Choices& choices_;
  Size size_;
  std::int32_t side_ = WRC_SIDE_RIGHT;
  Verdict verdict_;
  const char* where_ = "model";
  char sentence_[400] = "";       ///< of the last call on films
  AlongTrackArrays along_track_;  // config_ points into it
  wrc_config config_{};
  wrc_model* model_ = nullptr;
  wrc_contact* contact_ = nullptr;
};

}  // namespace

Verdict play(Choices& choices, const Size& size) { return Case(choices, size).play(); }

}  // namespace hostile
