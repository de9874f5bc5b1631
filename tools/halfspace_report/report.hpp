/// Commands of halfspace_report: each prints its tables and returns its numbers.
#pragma once

#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace wrc::halfspace::report {

/// The numbers of a command, in the order they were added, as JSON text.
class Json {
 public:
  void add(const std::string& key, double value) {
    char digits[40];
    std::snprintf(digits, sizeof digits, "%.8g", value);
    append(key, std::isfinite(value) ? digits : "null");
  }
  void add(const std::string& key, const char* value) {
    append(key, std::string("\"").append(value).append("\""));
  }
  void add(const std::string& key, const Json& value) { append(key, value.text()); }
  void add(const std::string& key, const std::vector<Json>& values) {
    std::string list;
    for (const Json& each : values) list.append(list.empty() ? "" : ", ").append(each.text());
    append(key, std::string("[").append(list).append("]"));
  }
  std::string text() const { return std::string("{").append(members_).append("}"); }

 private:
  void append(const std::string& key, const std::string& value) {
    members_.append(members_.empty() ? "\"" : ", \"").append(key).append("\": ").append(value);
  }
  std::string members_;
};

double seconds_of(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Json sdec(const char* path);  ///< against reference cases with prescribed SDEC pressure
Json balance(
    const char* path);  ///< dissipation summed over the cells against the energy balance, on finer grids
Json kalker();          ///< linear theory against Kalker's printed coefficients
Json hertz();           ///< peak, axes and approach of Hertz's contact, and the order of convergence
Json carter();          ///< the middle of a long contact against Carter's closed solution
Json paper();           ///< the source paper's two cases on finer and finer grids
Json speed();           ///< cost against grid size

}  // namespace wrc::halfspace::report
