/// Runs the plan of golden hashes: which instruction set, how many threads, contact by contact,
/// contacts in turn or stage by stage.
#pragma once

#include "golden/plan.hpp"

enum class Way { step, in_turn, stages };

/// The plan's models for one instruction set, shared by all threads.
class Models {
 public:
  /// Throws std::runtime_error with the library's sentence when a model cannot be made.
  Models(const Plan& plan, int32_t instruction_set);
  ~Models();
  Models(const Models&) = delete;
  Models& operator=(const Models&) = delete;
  const wrc_model* operator[](std::size_t i) const { return models_[i]; }

 private:
  std::vector<wrc_model*> models_;
};

/// One hash per job, in the order of the plan. Jobs are dealt out to the threads; results must not tell.
/// Throws std::runtime_error when a step fails that should not.
std::vector<std::uint64_t> run_jobs(const Plan& plan, const Models& models, int threads, Way way);
