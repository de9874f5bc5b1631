/// Values of a JSON text: those that the geometry beside a file of rows is made of.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace compare {

/// A number, a text, a list or an object; what the text does not say is empty.
struct Json {
  double number = 0.0;
  std::string text;
  std::vector<Json> list;
  std::map<std::string, Json> members;

  bool has(const std::string& name) const { return members.count(name) != 0; }

  /// A member; throws std::runtime_error where there is none.
  const Json& operator[](const std::string& name) const;

  /// The numbers of a list, lists within it one after the other.
  std::vector<double> numbers() const;
};

/// Reads a file; throws std::runtime_error with the file's name where it cannot be read or is no JSON.
Json read_json(const std::string& path);

}  // namespace compare
