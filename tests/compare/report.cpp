#include "report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace compare {
namespace {

/// Linear interpolation between order statistics of a sorted sample.
double quantile(const std::vector<double>& sorted, double share) {
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + "\"";
}

}  // namespace

Statistics statistics(const Errors& errors) {
  Statistics result;
  if (errors.values.empty()) return result;
  std::vector<double> signed_errors = errors.values, sizes;
  for (std::size_t i = 0; i < signed_errors.size(); ++i) {
    sizes.push_back(std::fabs(signed_errors[i]));
    if (sizes[i] >= result.max) {
      result.max = sizes[i];
      result.worst_row = errors.rows[i];
    }
  }
  std::sort(signed_errors.begin(), signed_errors.end());
  std::sort(sizes.begin(), sizes.end());
  result.median = quantile(sizes, 0.5);
  result.p95 = quantile(sizes, 0.95);
  result.bias = quantile(signed_errors, 0.5);
  return result;
}

void Report::fail(std::size_t row, const std::string& variant, const std::string& reason) {
  for (const std::string& measure : measures) errors[variant][measure].add(row, 1.0);
  failed.push_back({row, variant, reason});
}

void Report::print_table() const {
  std::printf("%s: %zu rows. |error|: median / 95th percentile / worst (row), bias = signed median; in %%.\n",
              kind.c_str(), rows);
  std::printf("The default variant is marked *. Rows are counted from 1, the heading apart.\n");
  for (const std::string& measure : measures) {
    std::printf("\n%-34s %8s %8s %8s %6s %8s %6s\n", measure.c_str(), "median", "p95", "worst", "row", "bias",
                "n");
    for (const std::string& variant : variants) {
      const Errors& sample = errors.at(variant).at(measure);
      const Statistics s = statistics(sample);
      std::printf("%c %-32s %8.2f %8.2f %8.2f %6zu %+8.2f %6zu\n", variant == default_variant ? '*' : ' ',
                  variant.c_str(), 100 * s.median, 100 * s.p95, 100 * s.max, s.worst_row + 1, 100 * s.bias,
                  sample.values.size());
    }
  }
  for (const Failure& each : failed) {
    std::printf("failed: row %zu, %s: %s\n", each.row + 1, each.variant.c_str(), each.reason.c_str());
  }
}

void Report::print_json() const {
  std::printf("{\"kind\": %s, \"rows\": %zu, \"variants\": {", quoted(kind).c_str(), rows);
  const char* separator = "";
  for (const std::string& variant : variants) {
    std::printf("%s%s: {", separator, quoted(variant).c_str());
    const char* inner = "";
    for (const std::string& measure : measures) {
      const Statistics s = statistics(errors.at(variant).at(measure));
      std::printf("%s%s: {\"median\": %.6g, \"p95\": %.6g, \"max\": %.6g, \"bias\": %.6g}", inner,
                  quoted(measure).c_str(), s.median, s.p95, s.max, s.bias);
      inner = ", ";
    }
    std::printf("}");
    separator = ", ";
  }
  std::printf("}, \"default\": %s, \"failed\": [", quoted(default_variant).c_str());
  separator = "";
  for (const Failure& each : failed) {
    std::printf("%s{\"row\": %zu, \"variant\": %s, \"reason\": %s}", separator, each.row + 1,
                quoted(each.variant).c_str(), quoted(each.reason).c_str());
    separator = ", ";
  }
  std::printf("]}\n");
}

}  // namespace compare
