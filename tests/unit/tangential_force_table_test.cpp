/// The force table: limits that are known, symmetries, smoothness, the solver it was made from, its file.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "field_values.hpp"
#include "halfspace/pressure.hpp"
#include "halfspace/tangential.hpp"
#include "patch/material.hpp"
#include "sdec_pressure.hpp"
#include "tangential/force_table/force_table_file.hpp"
#include "test_config.hpp"
#include "theory/sdec.hpp"
#include "wrc/wrc_damage.h"
#include "wrc/wrc_planar.h"

namespace wrc::tangential {
namespace {

constexpr double G = 80e9, N = 60e3, mu = 0.3;
constexpr patch::Sdec patch{5e-3, 4e-3, 0.4};

/// The table that ships, read once.
class TableFile {
 public:
  TableFile() {
    EXPECT_EQ(read_force_table_axes(WRC_FORCE_TABLE, table.axes).status, WRC_OK);
    coefficients_.resize(force_table_size(table.axes));
    EXPECT_EQ(read_force_table(WRC_FORCE_TABLE, table.axes, coefficients_.data()).status, WRC_OK);
    table.coefficients = coefficients_.data();
    adapt_to_poisson(table.axes.poisson, table);
  }
  ForceTable table;

 private:
  std::vector<float> coefficients_;
};
TableFile& table_file() {
  static TableFile the_file;
  return the_file;
}

TangentialForces forces(const patch::Sdec& sdec, const Creepage& creepage, Fault* fault = nullptr) {
  Fault unused;
  return table_forces(table_file().table, sdec, N, G, mu, creepage, fault ? *fault : unused);
}
TangentialForces forces(const Creepage& creepage) { return forces(patch, creepage); }

/// Creepage whose force by linear theory is about `share` of the friction limit.
double creepage_unit(double share) { return share * mu * N / (4.0 * G * patch.a * patch.b); }

double length(const TangentialForces& f) { return std::sqrt(f.fx * f.fx + f.fy * f.fy); }

TEST(ForceTable, SmallCreepagesFollowLinearTheory) {
  const double c = std::sqrt(patch.a * patch.b), tiny = creepage_unit(1e-6);
  for (const double ratio : {0.2, 1.0, 4.0}) {
    for (const double psi : {-0.6, 0.0, 0.3}) {
      const patch::Sdec sdec{c * std::sqrt(ratio), c / std::sqrt(ratio), psi};
      Fault fault;
      const theory::SdecCoefficients k =
          theory::SdecTable(table_file().table.axes.poisson).at(ratio, psi, fault);
      const TangentialForces x = forces(sdec, {tiny, 0.0, 0.0}), y = forces(sdec, {0.0, tiny, 0.0}),
                             spin = forces(sdec, {0.0, 0.0, tiny / c});
      const double unit = -G * c * c * tiny;
      // Kalker's table has three digits; the table's own face 0.5 % at most for these shapes.
      EXPECT_NEAR(x.fx / unit, k.c11, 0.015 * k.c11) << ratio << " " << psi;
      EXPECT_NEAR(y.fy / unit, k.c22, 0.015 * k.c22) << ratio << " " << psi;
      EXPECT_NEAR(spin.fy / unit, k.c23, 0.02 * k.c22) << ratio << " " << psi;
      EXPECT_NEAR(spin.fx / unit, k.c13, 0.02 * k.c11) << ratio << " " << psi;
      // Maxwell's reciprocity: the moment of a creepage is the force of spin (for nu_y with its sign
      // changed).
      EXPECT_NEAR(x.mz / (unit * c), k.c13, 0.03 * k.c11) << ratio << " " << psi;
      EXPECT_NEAR(y.mz / (unit * c), -k.c23, 0.03 * k.c22) << ratio << " " << psi;
      EXPECT_NEAR(x.adhesion_fraction, 1.0, 1e-3);
    }
  }
}

TEST(ForceTable, LargeCreepagesSlideWithCoulombFriction) {
  const double large = creepage_unit(1e6);
  for (const double angle : {0.0, 0.5, 1.9, 3.0, 4.4}) {
    const double cx = std::cos(angle), cy = std::sin(angle);
    const TangentialForces f = forces({large * cx, large * cy, 0.0});
    EXPECT_NEAR(f.fx / (mu * N), -cx, 3e-3);
    EXPECT_NEAR(f.fy / (mu * N), -cy, 3e-3);
    // The resultant goes through the centre of pressure.
    EXPECT_NEAR(f.mz, -pressure_centre(patch) * f.fx, 3e-3 * mu * N * patch.a);
    EXPECT_NEAR(f.power_per_speed / (mu * N * large), 1.0, 3e-3);
    EXPECT_NEAR(f.adhesion_fraction, 0.0, 1e-3);
  }
}

TEST(ForceTable, LargeSpinOfACircleHasTheMomentOfDrillingFriction) {
  // Integral of mu p r over a circle with p = p0 sqrt(1 - r^2 / a^2): (3 pi / 16) mu N a.
  const double a = 5e-3;
  const TangentialForces f = forces({a, a, 0.0}, {0.0, 0.0, creepage_unit(1e7) / a});
  EXPECT_NEAR(f.mz / (mu * N * a), -3.0 * pi / 16.0, 2e-3);
  EXPECT_NEAR(length(f) / (mu * N), 0.0, 3e-3);
}

TEST(ForceTable, NoCreepageNoForce) {
  const TangentialForces f = forces({0.0, 0.0, 0.0});
  EXPECT_EQ(f.fx, 0.0);
  EXPECT_EQ(f.fy, 0.0);
  EXPECT_EQ(f.mz, 0.0);
  EXPECT_EQ(f.power_per_speed, 0.0);
  EXPECT_EQ(f.adhesion_fraction, 1.0);
}

/// Random creepages of all sizes and shapes within and beyond the table.
struct Draw {
  patch::Sdec sdec;
  Creepage creepage;
};
Draw draw(std::mt19937& random) {
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
  };
  const double level = creepage_unit(std::pow(10.0, uniform(-2.0, 2.0))), c = 4.5e-3;
  const double root = std::pow(10.0, uniform(-0.6, 0.6));
  return {{c * root, c / root, uniform(-0.9, 0.9)},
          {level * uniform(-1.0, 1.0), level * uniform(-1.0, 1.0), level / c * uniform(-1.0, 1.0)}};
}

// Friction may be none, in a zone of it: then everything slides, and nothing holds.
TEST(ForceTable, WithoutFrictionSlidesWithoutForce) {
  for (const double friction : {0.0, 1e-300, 1e-100, 1e-12}) {
    for (const Creepage& creepage :
         {Creepage{0.0, 0.0, 0.3}, Creepage{1e-15, 0.0, 0.0}, Creepage{1e-3, -0.02, 100.0}}) {
      Fault fault;
      const TangentialForces f = table_forces(table_file().table, patch, N, G, friction, creepage, fault);
      EXPECT_EQ(fault.status, WRC_OK);
      EXPECT_LE(length(f), friction * N * (1.0 + 1e-12));
      EXPECT_LE(std::abs(f.mz), friction * N * (patch.a + patch.b));
      EXPECT_TRUE(std::isfinite(f.power_per_speed) && f.power_per_speed >= 0.0);
      if (friction < 1e-90) {
        EXPECT_NEAR(f.adhesion_fraction, 0.0, 1e-2);
      }
    }
  }
}

TEST(ForceTable, ChangesSignWithTheCreepagesAndMirrorsWithThePatch) {
  std::mt19937 random(1);
  for (int k = 0; k < 200; ++k) {
    const auto [sdec, c] = draw(random);
    const TangentialForces f = forces(sdec, c), back = forces(sdec, {-c.longitudinal, -c.lateral, -c.spin}),
                           mirror =
                               forces({sdec.a, sdec.b, -sdec.psi}, {c.longitudinal, -c.lateral, -c.spin});
    EXPECT_EQ(back.fx, -f.fx);
    EXPECT_EQ(back.fy, -f.fy);
    EXPECT_EQ(back.mz, -f.mz);
    EXPECT_EQ(mirror.fx, f.fx);
    EXPECT_EQ(mirror.fy, -f.fy);
    EXPECT_EQ(mirror.mz, -f.mz);
    EXPECT_EQ(back.power_per_speed, f.power_per_speed);
    EXPECT_EQ(mirror.adhesion_fraction, f.adhesion_fraction);
  }
}

TEST(ForceTable, StaysWithinFrictionAndDissipates) {
  std::mt19937 random(2);
  for (int k = 0; k < 5000; ++k) {
    const auto [sdec, c] = draw(random);
    const TangentialForces f = forces(sdec, c);
    EXPECT_LE(length(f), mu * N * (1.0 + 1e-12));
    EXPECT_TRUE(std::isfinite(f.mz));
    const double work = -(f.fx * c.longitudinal + f.fy * c.lateral + f.mz * c.spin);
    EXPECT_GE(work, 0.0);
    EXPECT_GE(f.adhesion_fraction, 0.0);
    EXPECT_LE(f.adhesion_fraction, 1.0);
  }
}

TEST(ForceTable, ForcesAndTheirSlopesAreContinuous) {
  // A path through every seam of the table's coordinates: zero spin, the ends of the azimuth, pure spin.
  const double u = creepage_unit(1.0), c = std::sqrt(patch.a * patch.b), centre = pressure_centre(patch);
  const auto path = [&](int leg, double s) -> Creepage {
    switch (leg) {
      case 0:
        return {0.4 * u, -0.3 * u, s * u / c};  // through zero spin
      case 1:
        return {0.8 * u + 0.3 * u / c * centre, s * u, 0.3 * u / c};  // through azimuth 0
      case 2:
        return {-0.8 * u + 0.3 * u / c * centre, s * u, 0.3 * u / c};  // and through half a turn
      default:
        return {s * u + 0.9 * u / c * centre, 0.0, 0.9 * u / c};  // through pure spin
    }
  };
  for (int leg = 0; leg < 4; ++leg) {
    const double h = 1e-5;
    const auto at = [&](double s) { return forces(path(leg, s)); };
    const TangentialForces far_left = at(-2 * h), left = at(-h), middle = at(0.0), right = at(h),
                           far_right = at(2 * h);
    for (double TangentialForces::*force :
         {&TangentialForces::fx, &TangentialForces::fy, &TangentialForces::mz}) {
      const double scale = mu * N * (force == &TangentialForces::mz ? c : 1.0);
      const double before = (left.*force - far_left.*force) / (h * scale);
      const double after = (far_right.*force - right.*force) / (h * scale);
      // The numbers of the file have seven digits.
      EXPECT_NEAR(middle.*force / scale, 0.5 * (left.*force + right.*force) / scale, 1e-6) << leg;
      EXPECT_NEAR(before, after, 1e-3) << leg;
    }
  }
  // The two ends of psi meet, and the shapes beyond the table join on.
  const Creepage any{0.5 * u, 0.3 * u, 0.7 * u / c};
  for (const double psi : {0.0, 0.8, -0.8}) {
    const TangentialForces below = forces({patch.a, patch.b, psi - 1e-9}, any),
                           above = forces({patch.a, patch.b, psi + 1e-9}, any);
    EXPECT_NEAR(below.fx, above.fx, 1e-6 * mu * N) << psi;
    EXPECT_NEAR(below.fy, above.fy, 1e-6 * mu * N) << psi;
    EXPECT_NEAR(below.mz, above.mz, 1e-6 * mu * N * c) << psi;
  }
}

TEST(ForceTable, FlagsShapesBeyondItsEnds) {
  const Creepage c{creepage_unit(1.0), 0.0, 0.0};
  const auto status = [&](const patch::Sdec& sdec) {
    Fault fault;
    forces(sdec, c, &fault);
    return fault.status;
  };
  EXPECT_EQ(status(patch), WRC_OK);
  EXPECT_EQ(status({11e-3, 1e-3, 0.0}), WRC_FLAG_TABLE_RANGE);
  EXPECT_EQ(status({1e-3, 11e-3, 0.0}), WRC_FLAG_TABLE_RANGE);
  EXPECT_EQ(status({5e-3, 4e-3, -0.9}), WRC_FLAG_TABLE_RANGE);
}

/// The solver, extrapolated to cells of no size as the generator does it, but on other grids.
TangentialForces solved(const patch::Sdec& sdec, const Creepage& creepage, double poisson) {
  const halfspace::SdecPatch region{sdec.a, sdec.b, sdec.psi};
  const auto on = [&](int cells) {
    const halfspace::Grid grid = halfspace::grid_over(region, cells, cells);
    halfspace::RollingProblem problem;
    problem.pressure =
        halfspace::sdec_pressure(region, patch::peak_pressure(sdec, N), grid, halfspace::CellPressure::mean);
    problem.friction = {mu};
    problem.creepage = creepage;
    return halfspace::RollingSolver(grid, {G, poisson}).solve(problem).forces;
  };
  const TangentialForces coarse = on(24), fine = on(40);
  const auto limit = [&](double TangentialForces::*f) {
    return fine.*f + (fine.*f - coarse.*f) * 24.0 / (40.0 - 24.0);
  };
  return {.fx = limit(&TangentialForces::fx),
          .fy = limit(&TangentialForces::fy),
          .mz = limit(&TangentialForces::mz),
          .adhesion_fraction = fine.adhesion_fraction};
}

TEST(ForceTable, AgreesWithTheSolverBetweenItsNodes) {
  const double c = 4.5e-3;
  std::mt19937 random(3);
  double sum = 0.0;
  constexpr int cases = 12;
  for (int k = 0; k < cases; ++k) {
    auto [sdec, creepage] = draw(random);
    const double root = 0.6 + 0.1 * k;  // a/b 0.36 to 2.9
    sdec = {c * root, c / root, 0.1 * (k - 6)};
    const double level = creepage_unit(0.4 + 0.4 * k) /
                         std::sqrt(creepage.longitudinal * creepage.longitudinal +
                                   creepage.lateral * creepage.lateral + std::pow(c * creepage.spin, 2));
    creepage = {level * creepage.longitudinal, level * creepage.lateral, level * creepage.spin};
    const TangentialForces ours = forces(sdec, creepage),
                           exact = solved(sdec, creepage, table_file().table.axes.poisson);
    const double error = std::hypot(ours.fx - exact.fx, ours.fy - exact.fy) / (mu * N);
    EXPECT_LT(error, 0.015) << k;
    EXPECT_NEAR(ours.mz, exact.mz, 0.015 * mu * N * c) << k;
    EXPECT_NEAR(ours.adhesion_fraction, exact.adhesion_fraction, 0.06) << k;
    sum += error;
  }
  EXPECT_LT(sum / cases, 0.004);
}

TEST(ForceTable, CountsThePoissonRatioByLinearTheory) {
  const double u = creepage_unit(1.0), c = std::sqrt(patch.a * patch.b);
  for (const double poisson : {0.20, 0.33}) {
    ForceTable table = table_file().table;
    adapt_to_poisson(poisson, table);
    for (const Creepage& creepage :
         {Creepage{u, 0.0, 0.0}, Creepage{0.3 * u, -0.8 * u, 0.5 * u / c}, Creepage{2.0 * u, u, u / c}}) {
      Fault fault;
      const TangentialForces ours = table_forces(table, patch, N, G, mu, creepage, fault),
                             exact = solved(patch, creepage, poisson), unadapted = forces(creepage);
      const double error = std::hypot(ours.fx - exact.fx, ours.fy - exact.fy);
      EXPECT_LT(error / (mu * N), 0.015) << poisson;
      if (std::hypot(unadapted.fx - exact.fx, unadapted.fy - exact.fy) > 0.02 * mu * N) {
        EXPECT_LT(error, std::hypot(unadapted.fx - exact.fx, unadapted.fy - exact.fy)) << poisson;
      }
    }
  }
}

// -------------------------------------------------------------------------------------------------- the file

std::vector<char> shipped() {
  std::vector<char> bytes;
  std::FILE* file = std::fopen(WRC_FORCE_TABLE, "rb");
  if (file == nullptr) return bytes;
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) bytes.push_back(static_cast<char>(c));
  std::fclose(file);
  return bytes;
}

/// A file of its own for each test, removed with it.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::vector<char>& bytes)
      : path_(testing::TempDir() + "force_table_" +
              testing::UnitTest::GetInstance()->current_test_info()->name() + ".bin") {
    std::FILE* file = std::fopen(path_.c_str(), "wb");
    if (file == nullptr) throw std::runtime_error("cannot write " + path_);
    if (!bytes.empty()) std::fwrite(bytes.data(), 1, bytes.size(), file);
    std::fclose(file);
  }
  ~TemporaryFile() { std::remove(path_.c_str()); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const char* path() const { return path_.c_str(); }

 private:
  std::string path_;
};

wrc_config configuration(const char* path) {
  wrc_config config = test_config();
  config.normal.method = WRC_NORMAL_HERTZ;  // the default prepares tables of its own, which takes a while
  config.tangential.method = WRC_TANGENTIAL_FORCE_TABLE;
  config.tangential.force_table = path;
  return config;
}

/// What wrc_config_check says about a file of these bytes; checks that init and create say the same.
std::string complaint(const std::vector<char>& bytes, std::int32_t status = WRC_ERROR_FILE) {
  const TemporaryFile file(bytes);
  const wrc_config config = configuration(file.path());
  char text[256];
  EXPECT_EQ(wrc_config_check(&config, text, sizeof text), status) << text;
  wrc_model* model = nullptr;
  EXPECT_EQ(wrc_model_create(&config, nullptr, &model, nullptr, 0), status);
  EXPECT_EQ(model, nullptr);
  return text;
}

void expect_mentions(const std::string& sentence, const char* words) {
  EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("config.tangential.force_table"), std::string::npos) << sentence;
}

TEST(ForceTableFile, IsNeeded) {
  wrc_config config = configuration(nullptr);
  EXPECT_EQ(wrc_config_check(&config, nullptr, 0), WRC_ERROR_NULL);
  config.tangential.force_table = "/nowhere/force_table.bin";
  char text[256];
  std::uint64_t bytes = 0, alignment = 0;
  EXPECT_EQ(wrc_config_check(&config, text, sizeof text), WRC_ERROR_FILE);
  expect_mentions(text, "cannot be opened");
  expect_mentions(text, config.tangential.force_table);
  EXPECT_EQ(wrc_model_size(&config, &bytes, &alignment), WRC_ERROR_FILE);
  EXPECT_EQ(bytes, 0u);
  config.tangential.method = WRC_TANGENTIAL_STRIP_FASTSIM;  // which does not look at it
  EXPECT_EQ(wrc_config_check(&config, text, sizeof text), WRC_ERROR_UNSUPPORTED);
  expect_mentions(text, "WRC_TANGENTIAL_FORCE_TABLE");
}

TEST(ForceTableFile, IsRefusedWhenShort) {
  const std::vector<char> whole = shipped();
  ASSERT_GT(whole.size(), sizeof(ForceTableFileHeader));
  for (const std::size_t size : {std::size_t{0}, std::size_t{7}, sizeof(ForceTableFileHeader) - 1,
                                 sizeof(ForceTableFileHeader), whole.size() / 2, whole.size() - 1}) {
    expect_mentions(complaint({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}),
                    "ends before");
  }
}

TEST(ForceTableFile, IsRefusedWhenLong) {
  std::vector<char> bytes = shipped();
  bytes.push_back('\n');
  expect_mentions(complaint(bytes), "goes on");
}

TEST(ForceTableFile, IsRefusedWhenOneBitIsWrong) {
  const std::vector<char> whole = shipped();
  for (const std::size_t at :
       {sizeof(ForceTableFileHeader) - 1, sizeof(ForceTableFileHeader), whole.size() / 3, whole.size() - 1}) {
    std::vector<char> bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ 1);
    expect_mentions(complaint(bytes), "checksum");
  }
}

TEST(ForceTableFile, IsRefusedWhenOfAnotherKind) {
  std::vector<char> bytes = shipped();
  const auto changed = [&](std::size_t offset, auto value) {
    std::vector<char> copy = bytes;
    std::memcpy(copy.data() + offset, &value, sizeof value);
    return copy;
  };
  expect_mentions(complaint(changed(0, 'x')), "not a force table");
  expect_mentions(complaint(changed(offsetof(ForceTableFileHeader, byte_order), std::uint32_t{0x04030201})),
                  "byte order");
  expect_mentions(complaint(changed(offsetof(ForceTableFileHeader, version), std::uint32_t{2})), "version");
  expect_mentions(complaint(changed(offsetof(ForceTableFileHeader, nodes), std::int32_t{-3})), "header");
  expect_mentions(complaint(changed(offsetof(ForceTableFileHeader, largest_ratio), std::nan(""))), "header");
  expect_mentions(complaint(std::vector<char>(5000, '?')), "not a force table");
}

TEST(ForceTableFile, WithNumbersOfNoForceIsRefusedEvenIfItsChecksumIsRight) {
  std::vector<char> bytes = shipped();
  ForceTableFileHeader header;
  std::memcpy(&header, bytes.data(), sizeof header);
  const float not_a_number = NAN;
  std::memcpy(bytes.data() + sizeof header + 4000, &not_a_number, sizeof not_a_number);
  header.checksum = 0;
  header.checksum = file_checksum(bytes.data() + sizeof header, bytes.size() - sizeof header,
                                  file_checksum(&header, sizeof header));
  std::memcpy(bytes.data(), &header, sizeof header);
  expect_mentions(complaint(bytes), "out of range");
}

TEST(ForceTableFile, IsClosedWhateverHappens) {
  const std::vector<char> whole = shipped();
  const TemporaryFile file({whole.begin(), whole.begin() + 200});
  const wrc_config config = configuration(file.path());
  for (int i = 0; i < 3000; ++i)  // more than a process may have open
    ASSERT_EQ(wrc_config_check(&config, nullptr, 0), WRC_ERROR_FILE);
  std::FILE* another = std::fopen(file.path(), "rb");
  ASSERT_NE(another, nullptr);
  std::fclose(another);
}

// --------------------------------------------------------------------------------------------- the interface

TEST(ForceTableMethod, GivesTotalsAndRefusesFields) {
  const wrc_config config = configuration(WRC_FORCE_TABLE);
  wrc_model* model = nullptr;
  wrc_contact* contact = nullptr;
  ASSERT_EQ(wrc_model_create(&config, nullptr, &model, nullptr, 0), WRC_OK);
  ASSERT_EQ(wrc_contact_create(model, WRC_SIDE_RIGHT, nullptr, &contact, nullptr, 0), WRC_OK);
  wrc_ellipse sdec = sized<wrc_ellipse>();
  sdec.a = patch.a;
  sdec.b = patch.b;
  sdec.psi = patch.psi;
  sdec.normal_force = N;
  wrc_creepage creepage = wrc_creepage_default();
  creepage.longitudinal = 1e-3;
  creepage.lateral = -5e-4;
  creepage.spin = 0.2;
  creepage.speed = 20.0;
  wrc_friction friction = wrc_friction_default();
  friction.coefficient = mu;
  wrc_planar_forces totals = {};
  ASSERT_EQ(wrc_planar_tangential(contact, &sdec, &creepage, &friction, &totals), WRC_OK);
  EXPECT_NEAR(totals.power, -20.0 * (totals.fx * 1e-3 - totals.fy * 5e-4 + totals.mz * 0.2),
              1e-12 * totals.power);

  wrc_damage damage = {};
  ASSERT_EQ(wrc_contact_damage(contact, WRC_ALL_REGIONS, &damage), WRC_OK);
  EXPECT_EQ(damage.power, totals.power);
  EXPECT_NEAR(damage.t_gamma, totals.power / 20.0, 1e-12 * totals.power);
  EXPECT_NEAR(damage.utilisation, std::hypot(totals.fx, totals.fy) / N, 1e-12);
  EXPECT_EQ(damage.peak_power_density, 0.0);
  EXPECT_EQ(damage.local_fatigue_index, 0.0);
  EXPECT_EQ(damage.available & WRC_AVAILABLE_TRACTIONS, 0u);
  EXPECT_EQ(totals.available & WRC_AVAILABLE_TRACTIONS, 0u);
  wrc_wear wear = {};
  EXPECT_EQ(wrc_contact_wear(contact, WRC_ALL_REGIONS, nullptr, &wear), WRC_ERROR_UNSUPPORTED);

  for (const std::int32_t field : {WRC_FIELD_TRACTION_X, WRC_FIELD_SLIP_Y, WRC_FIELD_POWER_DENSITY,
                                   WRC_FIELD_STRIP_POWER, WRC_FIELD_STRIP_WEAR, WRC_FIELD_STRIP_FRICTION}) {
    const FieldValues values = field_values(contact, 0, field);
    EXPECT_EQ(values.status, WRC_ERROR_UNSUPPORTED) << field;
    EXPECT_TRUE(values.values.empty());
  }
  const FieldValues peaks = field_values(contact, 0, WRC_FIELD_STRIP_PEAK);
  EXPECT_EQ(peaks.status, WRC_OK);
  EXPECT_EQ(peaks.strips, 60u);
  const FieldValues pressure = field_values(contact, 0, WRC_FIELD_PRESSURE);
  EXPECT_EQ(pressure.status, WRC_OK);
  EXPECT_EQ(pressure.strips, 60u);
  EXPECT_GT(pressure.at(pressure.cells / 2, 30), 0.9 * peaks[30]);
  wrc_contact_destroy(contact);
  wrc_model_destroy(model);
}

TEST(ForceTableMethod, WorksInMemoryOfTheCaller) {
  const wrc_config config = configuration(WRC_FORCE_TABLE);
  std::uint64_t bytes = 0, alignment = 0;
  ASSERT_EQ(wrc_model_size(&config, &bytes, &alignment), WRC_OK);
  EXPECT_GT(bytes, force_table_size(table_file().table.axes) * sizeof(float));
  std::vector<char> memory(bytes + alignment);
  void* start = memory.data();
  std::size_t room = memory.size();
  ASSERT_NE(std::align(alignment, bytes, start, room), nullptr);
  wrc_model* model = nullptr;
  EXPECT_EQ(wrc_model_init(&config, start, bytes - 1, &model, nullptr, 0), WRC_ERROR_BUFFER);
  EXPECT_EQ(wrc_model_init(&config, start, bytes, &model, nullptr, 0), WRC_OK);
  EXPECT_NE(model, nullptr);
}

}  // namespace
}  // namespace wrc::tangential
