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
  fail(row, variant, reason, measures);
}

void Report::fail(std::size_t row, const std::string& variant, const std::string& reason,
                  const std::vector<std::string>& of_measures) {
  for (const std::string& measure : of_measures) errors[variant][measure].add(row, 1.0);
  failed.push_back({row, variant, reason});
}

Errors Report::sample_of(const std::string& variant, const std::string& measure) const {
  const auto of_variant = errors.find(variant);
  if (of_variant == errors.end()) return {};
  const auto found = of_variant->second.find(measure);
  return found == of_variant->second.end() ? Errors{} : found->second;
}

void Report::print_table() const {
  const char* const name = numbered ? "case" : "row";
  const std::size_t first = numbered ? 0 : 1;
  std::printf(
      "%s: %zu %ss. |error|: median / 95th percentile / worst (%s), bias = signed median; in %% unless "
      "said.\n",
      kind.c_str(), rows, name, name);
  std::printf("The default variant is marked *. %s\n", numbered
                                                           ? "Cases have their numbers in the file."
                                                           : "Rows are counted from 1, the heading apart.");
  for (const std::string& measure : measures) {
    const auto empty = [&](const std::string& variant) { return sample_of(variant, measure).values.empty(); };
    if (std::all_of(variants.begin(), variants.end(), empty)) continue;
    const auto unit = units.find(measure);
    const double scale = unit == units.end() ? 100.0 : 1.0;
    const std::string title = unit == units.end() ? measure : measure + " [" + unit->second + "]";
    std::printf("\n%-34s %8s %8s %8s %6s %8s %6s\n", title.c_str(), "median", "p95", "worst", name, "bias",
                "n");
    for (const std::string& variant : variants) {
      const Errors sample = sample_of(variant, measure);
      if (sample.values.empty()) continue;
      const Statistics s = statistics(sample);
      const int digits = numbered && scale * s.max < 0.1 ? 5 : 2;
      std::printf("%c %-32s %8.*f %8.*f %8.*f %6zu %+8.*f %6zu\n", variant == default_variant ? '*' : ' ',
                  variant.c_str(), digits, scale * s.median, digits, scale * s.p95, digits, scale * s.max,
                  s.worst_row + first, digits, scale * s.bias, sample.values.size());
    }
  }
  for (const Failure& each : failed) {
    std::printf("failed: %s %zu, %s: %s\n", name, each.row + first, each.variant.c_str(),
                each.reason.c_str());
  }
}

void Report::print_json() const {
  std::printf("{\"kind\": %s, \"rows\": %zu, \"variants\": {", quoted(kind).c_str(), rows);
  const char* separator = "";
  for (const std::string& variant : variants) {
    std::printf("%s%s: {", separator, quoted(variant).c_str());
    const char* inner = "";
    for (const std::string& measure : measures) {
      const Errors sample = sample_of(variant, measure);
      if (sample.values.empty()) continue;
      const Statistics s = statistics(sample);
      std::printf("%s%s: {\"median\": %.6g, \"p95\": %.6g, \"max\": %.6g, \"bias\": %.6g, \"n\": %zu}", inner,
                  quoted(measure).c_str(), s.median, s.p95, s.max, s.bias, sample.values.size());
      inner = ", ";
    }
    std::printf("}");
    separator = ", ";
  }
  std::printf("}, \"default\": %s, \"failed\": [", quoted(default_variant).c_str());
  separator = "";
  for (const Failure& each : failed) {
    std::printf("%s{\"%s\": %zu, \"variant\": %s, \"reason\": %s}", separator, numbered ? "case" : "row",
                each.row + (numbered ? 0 : 1), quoted(each.variant).c_str(), quoted(each.reason).c_str());
    separator = ", ";
  }
  std::printf("]}\n");
}

}  // namespace compare
