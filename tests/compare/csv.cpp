#include "csv.hpp"

#include <charconv>
#include <fstream>
#include <stdexcept>

namespace compare {
namespace {

/// The cells of a line. A cell in quotes may hold commas; its quotes are left out.
std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> pieces(1);
  bool quoted = false;
  for (char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      pieces.emplace_back();
    } else if (c != '\r' && c != ' ') {
      pieces.back() += c;
    }
  }
  return pieces;
}

}  // namespace

Csv::Csv(const std::string& path) : path_(path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  std::string line;
  if (!std::getline(file, line)) throw std::runtime_error(path + " is empty");
  const std::vector<std::string> names = split(line);
  while (std::getline(file, line)) {
    if (line.empty()) continue;
    const std::vector<std::string> pieces = split(line);
    const std::string where = path + ", line " + std::to_string(rows_ + 2);
    if (pieces.size() != names.size()) {
      throw std::runtime_error(where + " has " + std::to_string(pieces.size()) + " values, the heading " +
                               std::to_string(names.size()));
    }
    for (std::size_t i = 0; i < names.size(); ++i) columns_[names[i]].push_back(pieces[i]);
    ++rows_;
  }
}

double Csv::operator()(std::size_t row, const std::string& column) const {
  const std::string& written = text(row, column);
  double value = 0.0;
  const char* end = written.data() + written.size();
  const auto result = std::from_chars(written.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end) {
    throw std::runtime_error(path_ + ", line " + std::to_string(row + 2) + ", column " + column + ": '" +
                             written + "' is not a number");
  }
  return value;
}

const std::string& Csv::text(std::size_t row, const std::string& column) const {
  const auto found = columns_.find(column);
  if (found == columns_.end()) throw std::runtime_error("the file has no column '" + column + "'");
  return found->second.at(row);
}

std::string parameters_of(const std::string& path) {
  const std::size_t at = path.rfind("cases");
  if (at == std::string::npos)
    throw std::runtime_error(path + ": no 'cases' in its name to make 'params' of");
  return path.substr(0, at) + "params" + path.substr(at + 5);
}

}  // namespace compare
