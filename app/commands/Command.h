#pragma once

#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace haptiv {

/// What a number on the command line may be: from `low`, or above it where `open`, up to `high`. NaN is in no range.
struct Range {
  double low = 0;
  double high = 0;
  bool open = false;
};

/// What else there is to say of an option.
class CommandOption {
 public:
  explicit CommandOption(CLI::Option* option) : option_(option) {}
  CommandOption required() const;
  /// The default, which is the value when the option is declared, stands in the help.
  CommandOption showDefault() const;
  /// What stands for the value in the help, such as FILE.csv.
  CommandOption type(const char* name) const;

 private:
  CLI::Option* option_;
};

/// A command of the command line as its own file declares it: its options, where their values go, and what it does.
/// The values must live as long as the action: both share the options in a shared_ptr.
///
/// A name without dashes takes its place on the command line; one that starts with -- is given by name.
class Command {
 public:
  using Action = std::function<int()>;

  /// The program itself. What the command line asks for comes to stand in `chosen`.
  Command(CLI::App& app, Action& chosen) : app_(&app), chosen_(&chosen) {}

  /// A command below this one.
  Command add(const char* name, const char* help, const Action& action) const;
  /// A command that only holds others, one of which must be given.
  Command addGroup(const char* name, const char* help) const;
  /// More help, below the options.
  void footer(const char* text) const;

  CommandOption path(const char* name, std::string& value, const char* help) const;  ///< a file or folder; not empty
  CommandOption text(const char* name, std::string& value, const char* help) const;
  /// May be given several times.
  CommandOption texts(const char* name, std::vector<std::string>& values, const char* help) const;
  CommandOption number(const char* name, double& value, const Range& range, const char* help) const;
  CommandOption number(const char* name, std::optional<double>& value, const Range& range, const char* help) const;
  CommandOption count(const char* name, int& value, const Range& range, const char* help) const;
  CommandOption choice(const char* name, std::string& value, std::initializer_list<const char*> from,
                       const char* help) const;
  /// Several of them, with commas between.
  CommandOption choices(const char* name, std::vector<std::string>& values, std::initializer_list<const char*> from,
                        const char* help) const;
  /// Any words, with commas or blanks between.
  CommandOption list(const char* name, std::vector<std::string>& values, const char* help) const;
  CommandOption flag(const char* name, bool& value, const char* help) const;
  /// --json
  void json(bool& value) const;

 private:
  CLI::App* app_;
  Action* chosen_;
};

}  // namespace haptiv
