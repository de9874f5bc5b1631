#include "golden/run.hpp"

#include <exception>
#include <stdexcept>
#include <thread>

#include "test_config.hpp"

Models::Models(const Plan& plan, int32_t instruction_set) {
  for (wrc_config config : plan.models) {
    config.instruction_set = instruction_set;
    wrc_model* model = nullptr;
    if (wrc_model_create(&config, nullptr, &model, nullptr, 0) < 0) {
      char text[256];
      wrc_config_check(&config, text, sizeof text);
      for (wrc_model* made_before : models_) wrc_model_destroy(made_before);
      throw std::runtime_error("model " + std::to_string(models_.size()) + ": " + text);
    }
    models_.push_back(model);
  }
}

Models::~Models() {
  for (wrc_model* model : models_) wrc_model_destroy(model);
}

namespace {

/// A job under way.
class Running {
 public:
  Running(const Job& job, const wrc_config& config, const wrc_model* model)
      : job_(&job), tractions_(method_gives_tractions(config.tangential.method)) {
    if (wrc_contact_create(model, job.side, nullptr, &contact_, nullptr, 0) < 0)
      throw std::runtime_error("no contact");
  }
  ~Running() { wrc_contact_destroy(contact_); }
  Running(Running&& other) noexcept
      : hash(other.hash), job_(other.job_), tractions_(other.tractions_), contact_(other.contact_) {
    other.contact_ = nullptr;
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;
  Running& operator=(Running&&) = delete;

  const Job& job() const { return *job_; }
  wrc_contact* contact() const { return contact_; }

  /// The structs a step reads and fills; a gap is this object's, which must stay where it is meanwhile.
  void prepare(std::size_t k) {
    const Step& step = job_->steps[k];
    if (step.gap != nullptr) gap_ = step.gap->view();
    input = wrc_planar_input_default();
    input.pose = step.pose;
    input.gap = step.gap == nullptr ? nullptr : &gap_;
    input.load = step.load;
    input.creepage = step.creepage;
    input.friction = step.friction;
    output = sized<wrc_planar_output>();
  }

  /// wrc_planar_step() in its stages: the first flag counts.
  int32_t run_stages() {
    int32_t status = WRC_OK;
    const auto keep = [&](int32_t next) {
      if (status == WRC_OK || next < 0) status = next;
    };
    if (input.gap == nullptr) keep(wrc_planar_geometry(contact_, &input.pose, &output.point));
    keep(wrc_planar_normal(contact_, input.gap, &input.load, &output.normal));
    keep(wrc_planar_tangential(contact_, nullptr, &input.creepage, &input.friction, &output.forces));
    keep(wrc_contact_damage(contact_, WRC_ALL_REGIONS, &output.damage));
    return status;
  }

  void keep(std::size_t k, int32_t status) {
    if (status < 0) {
      char text[256];
      wrc_contact_last_error(contact_, text, sizeof text);
      throw std::runtime_error(job_->group + ", step " + std::to_string(k) + ": " + text);
    }
    hash_step(contact_, status, output, tractions_, hash);
  }

  Hash hash;
  wrc_planar_input input{};
  wrc_planar_output output{};

 private:
  const Job* job_;
  bool tractions_;
  wrc_contact* contact_ = nullptr;
  wrc_planar_gap gap_{};
};

/// Step k of every contact before step k + 1 of any: what one contact left behind anywhere but in itself
/// would show in the next one's bits.
void run_in_turn(std::vector<Running>& all) {
  bool going = true;
  for (std::size_t k = 0; going; ++k) {
    going = false;
    for (Running& each : all) {
      if (k >= each.job().steps.size()) continue;
      going = true;
      each.prepare(k);
      each.keep(k, wrc_planar_step(each.contact(), &each.input, &each.output));
    }
  }
}

/// Every `threads`-th job from `first` on.
void run_share(const Plan& plan, const Models& models, int first, int threads, Way way,
               std::vector<std::uint64_t>& hashes) {
  std::vector<Running> mine;
  std::vector<std::size_t> places;
  for (std::size_t i = static_cast<std::size_t>(first); i < plan.jobs.size();
       i += static_cast<std::size_t>(threads)) {
    mine.emplace_back(plan.jobs[i], plan.models[plan.jobs[i].model], models[plan.jobs[i].model]);
    places.push_back(i);
  }
  if (way == Way::in_turn) run_in_turn(mine);
  for (Running& each : mine) {
    if (each.job().calls) each.job().calls(each.contact(), each.hash);
    if (each.job().calls_of_both) {
      wrc_contact* left = nullptr;
      if (wrc_contact_create(models[each.job().model], WRC_SIDE_LEFT, nullptr, &left, nullptr, 0) < 0)
        throw std::runtime_error("no contact");
      each.job().calls_of_both(each.contact(), left, each.hash);
      wrc_contact_destroy(left);
    }
    for (std::size_t k = 0; way != Way::in_turn && k < each.job().steps.size(); ++k) {
      each.prepare(k);
      each.keep(k, way == Way::stages ? each.run_stages()
                                      : wrc_planar_step(each.contact(), &each.input, &each.output));
    }
  }
  for (std::size_t i = 0; i < mine.size(); ++i) hashes[places[i]] = mine[i].hash.value();
}

}  // namespace

std::vector<std::uint64_t> run_jobs(const Plan& plan, const Models& models, int threads, Way way) {
  std::vector<std::uint64_t> hashes(plan.jobs.size());
  std::vector<std::exception_ptr> failures(static_cast<std::size_t>(threads));
  std::vector<std::thread> running;
  running.reserve(static_cast<std::size_t>(threads));
  for (int t = 0; t < threads; ++t) {
    running.emplace_back([&, t] {
      try {
        run_share(plan, models, t, threads, way, hashes);
      } catch (...) {
        failures[static_cast<std::size_t>(t)] = std::current_exception();
      }
    });
  }
  for (std::thread& each : running) each.join();
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
  return hashes;
}
