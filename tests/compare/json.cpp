#include "json.hpp"

#include <cctype>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace compare {
namespace {

/// Reads one value after the other from a text.
class Reader {
 public:
  explicit Reader(const std::string& text) : at_(text.c_str()) {}

  Json value() {
    Json read;
    switch (next()) {
      case '{':
        read_list('}', [&] { read_member(read); });
        break;
      case '[':
        read_list(']', [&] { read.list.push_back(value()); });
        break;
      case '"':
        read.text = string();
        break;
      default:
        read.number = number();
    }
    return read;
  }

  void end() {
    if (next() != '\0') fail();
  }

 private:
  [[noreturn]] void fail() const {
    throw std::runtime_error("no JSON from '" + std::string(at_, strnlen(at_, 20)) + "' on");
  }

  char next() {
    while (std::isspace(static_cast<unsigned char>(*at_))) ++at_;
    return *at_;
  }

  void skip(char expected) {
    if (next() != expected) fail();
    ++at_;
  }

  /// What stands between a bracket and its end, each by `read`, commas between.
  template <class Read>
  void read_list(char last, Read read) {
    ++at_;
    if (next() == last) {
      ++at_;
      return;
    }
    for (;;) {
      read();
      if (next() == last) break;
      skip(',');
    }
    ++at_;
  }

  void read_member(Json& into) {
    if (next() != '"') fail();
    const std::string name = string();
    skip(':');
    into.members[name] = value();
  }

  std::string string() {
    const char* const first = ++at_;
    while (*at_ != '"' && *at_ != '\0') ++at_;
    const std::string text(first, at_);
    skip('"');
    return text;
  }

  double number() {
    char* end = nullptr;
    const double value = std::strtod(at_, &end);
    if (end == at_) fail();
    at_ = end;
    return value;
  }

  const char* at_;
};

void append(const Json& json, std::vector<double>& numbers) {
  for (const Json& each : json.list) {
    if (each.list.empty())
      numbers.push_back(each.number);
    else
      append(each, numbers);
  }
}

}  // namespace

const Json& Json::operator[](const std::string& name) const {
  const auto found = members.find(name);
  if (found == members.end()) throw std::runtime_error("no member '" + name + "' in an object");
  return found->second;
}

std::vector<double> Json::numbers() const {
  std::vector<double> all;
  append(*this, all);
  return all;
}

Json read_json(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  try {
    Reader reader(text);
    Json read = reader.value();
    reader.end();
    return read;
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

}  // namespace compare
