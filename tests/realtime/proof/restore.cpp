/// A rejected step leaves no trace: after wrc_contact_restore() the same step gives the same bits.
#include <cstdio>

#include "golden/plan.hpp"
#include "proof/proofs.hpp"
#include "proof/wheel.hpp"

namespace {

std::uint64_t hash_of_step(Wheel& wheel, int i) {
  Hash hash;
  wheel.vary(i);
  wheel.vary_laws(i);
  const int32_t status = wheel.step();
  hash_step(wheel.contact, status, wheel.output, gives_tractions(wheel.methods.tangential), hash);
  return hash.value();
}

}  // namespace

bool prove_restore() {
  int compared = 0, different = 0, remembered = 0;
  for (const Methods& methods : all_methods()) {
    Wheel wheel(methods);
    wrc_contact* second = nullptr;
    if (wrc_contact_create(wheel.model, wheel.methods.side, nullptr, &second, nullptr, 0) < 0) return false;
    for (int i = 0; i < 20; ++i) {
      wheel.save();
      const std::uint64_t first_time = hash_of_step(wheel, 401 * i);
      for (int k = 1; k < 4; ++k) hash_of_step(wheel, 401 * i + 1000 * k);  // steps to be forgotten
      const std::uint64_t unrestored = hash_of_step(wheel, 401 * i);
      wheel.restore();
      const std::uint64_t again = hash_of_step(wheel, 401 * i);
      wrc_contact* const kept = wheel.contact;
      wheel.contact = second;
      wheel.restore();
      const std::uint64_t elsewhere = hash_of_step(wheel, 401 * i);
      wheel.contact = kept;
      ++compared;
      different += again != first_time || elsewhere != first_time;
      remembered += unrestored != first_time;
      if (i % 2 == 0) hash_of_step(wheel, 401 * i + 77);
    }
    wrc_contact_destroy(second);
  }
  std::printf(
      "%d steps repeated after a restore, in the same contact and another: %d differ (without the restore: "
      "%d, "
      "as warm starts are on)\n",
      compared, different, remembered);
  return different == 0 && remembered > 0;  // without warm start in effect the comparison would be empty
}
