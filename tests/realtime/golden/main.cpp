/// Are the results the same bits whatever computes them?
///     golden_hash print                  one hash per group of cases, and one over all
///     golden_hash write FILE             the same into a file: the expected values
///     golden_hash check FILE             every instruction set of this processor, 1 to 8 threads, contact by
///                                        contact, in turn and stages alone, against the file
///     golden_hash check FILE shortly     two of these per instruction set named, none for the best of them
///     golden_hash check FILE rest        the others
///     golden_hash check FILE once        one of these per instruction set named
///     golden_hash check FILE threads     8 threads with the best instruction set
/// The same program built with another compiler, other options or for another processor must print the same.
#include <cstdio>
#include <exception>
#include <fstream>
#include <map>

#include "golden/run.hpp"

namespace {

using Hashes = std::map<std::string, std::uint64_t>;  // by group, sorted

Hashes by_group(const Plan& plan, const std::vector<std::uint64_t>& of_jobs) {
  std::map<std::string, Hash> groups;
  for (std::size_t i = 0; i < of_jobs.size(); ++i) groups[plan.jobs[i].group].add(of_jobs[i]);
  Hashes hashes;
  Hash all;
  for (const auto& [name, hash] : groups) {
    hashes[name] = hash.value();
    all.add(hash.value());
  }
  hashes["all"] = all.value();
  return hashes;
}

constexpr const char* set_names[] = {"best", "baseline", "AVX2", "AVX-512"};
constexpr const char* way_names[] = {"one by one", "in turn", "stages alone"};

Hashes expected_from(const char* path) {
  Hashes hashes;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    const std::size_t end = line.rfind(' ');
    if (line.empty() || line[0] == '#' || end == std::string::npos) continue;
    hashes[line.substr(0, end)] = std::stoull(line.substr(end + 1), nullptr, 16);
  }
  return hashes;
}

void print(const Hashes& hashes, std::FILE* to) {
  for (const auto& [name, hash] : hashes)
    std::fprintf(to, "%s %016llx\n", name.c_str(), static_cast<unsigned long long>(hash));
}

/// The groups that differ, with commas; empty when none does.
std::string difference(const Hashes& found, const Hashes& expected) {
  std::string names;
  for (const auto& [name, hash] : found) {
    const auto it = expected.find(name);
    if (it == expected.end() || it->second != hash) names += (names.empty() ? "" : ", ") + name;
  }
  if (names.empty() && found.size() != expected.size()) names = "the file knows groups that are not there";
  return names;
}

int check(const Plan& plan, const char* path, const std::string& extent) {
  const Hashes expected = expected_from(path);
  if (expected.empty()) {
    std::printf("no expected values in %s\n", path);
    return 2;
  }
  struct Run {
    int threads;
    Way way;
  };
  std::vector<Run> runs = {{1, Way::step},   {3, Way::in_turn}, {1, Way::in_turn},
                           {1, Way::stages}, {2, Way::step},    {8, Way::step}};
  if (extent == "once") runs.resize(1);
  if (extent == "shortly") runs.resize(2);
  if (extent == "rest") runs.erase(runs.begin(), runs.begin() + 2);
  if (extent == "threads") runs = {runs.back()};
  const bool named_sets = extent == "shortly" || extent == "once";
  const std::int32_t first_set = named_sets ? WRC_INSTRUCTIONS_BASELINE : WRC_INSTRUCTIONS_BEST;
  const std::int32_t last_set = extent == "threads" ? WRC_INSTRUCTIONS_BEST : WRC_INSTRUCTIONS_AVX512;
  int same = 0, different = 0;
  std::string named;  // the groups last printed: usually the same ones differ everywhere
  for (std::int32_t set = first_set; set <= last_set; ++set) {
    if (!available(set)) {
      std::printf("%-8s  not in this build or on this processor\n", set_names[set]);
      continue;
    }
    const Models models(plan, set);
    for (const Run& run : runs) {
      if (set == WRC_INSTRUCTIONS_BEST && &run != &runs.back()) continue;  // it is one of the named sets
      const std::string names =
          difference(by_group(plan, run_jobs(plan, models, run.threads, run.way)), expected);
      ++(names.empty() ? same : different);
      const bool known = !names.empty() && names == named;
      std::printf("%-8s  %d thread%s  %-12s  %s%s\n", set_names[set], run.threads,
                  run.threads == 1 ? " " : "s", way_names[static_cast<int>(run.way)],
                  names.empty() ? "same bits"
                  : known       ? "DIFFERENT, the same groups"
                                : "DIFFERENT: ",
                  known ? "" : names.c_str());
      named = names;
    }
  }
  if (different > 0)
    std::printf("numbers moved on purpose? cmake --build --preset release --target renew_golden\n");
  std::printf("%d passed, %d failed\n", same, different);
  return different == 0 ? 0 : 1;
}

Hashes plain_run(const Plan& plan) {
  return by_group(plan, run_jobs(plan, Models(plan, WRC_INSTRUCTIONS_BEST), 1, Way::step));
}

int write(const Plan& plan, const char* path) {
  std::FILE* file = std::fopen(path, "w");
  if (file == nullptr) {
    std::printf("cannot write %s\n", path);
    return 2;
  }
  std::fprintf(file,
               "# Hashes of the library's results over groups of cases, written by\n"
               "#     cmake --build --preset release --target renew_golden\n"
               "# They change with every change of numbers; the changelog says why.\n");
  print(plain_run(plan), file);
  std::fclose(file);
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    const Plan plan = golden_plan();
    const std::string command = count > 1 ? arguments[1] : "print";
    if (command == "write" && count > 2) return write(plan, arguments[2]);
    if (command == "check" && count > 2) return check(plan, arguments[2], count > 3 ? arguments[3] : "");
    if (command == "print") {
      print(plain_run(plan), stdout);
      return 0;
    }
  } catch (const std::exception& failure) {
    std::printf("%s\n", failure.what());
    return 1;
  }
  std::printf("golden_hash print | write FILE | check FILE [shortly | rest | once | threads]\n");
  return 2;
}
