#include "app/commands/Command.h"

#include <CLI/CLI.hpp>
#include <cmath>

#include "app/commands/ExitCode.h"

namespace haptiv {
namespace {

CLI::Validator within(const Range& range) {
  return {[range](std::string& text) -> std::string {
            double value = NAN;
            if (!CLI::detail::lexical_cast(text, value)) return text + " is no number";
            if ((value > range.low || (!range.open && value == range.low)) && value <= range.high) return {};
            return text + " is not " + (range.open ? "above " : "from ") + CLI::detail::to_string(range.low) +
                   (range.open ? " and at most " : " to ") + CLI::detail::to_string(range.high);
          },
          ""};
}

CLI::Validator notEmpty() {
  return {[](std::string& text) { return std::string(text.empty() ? "the name is empty" : ""); }, ""};
}

CLI::Validator oneOf(std::initializer_list<const char*> from) {
  return {[names = std::vector<std::string>(from.begin(), from.end())](std::string& text) -> std::string {
            std::string all;
            for (const std::string& name : names) {
              if (text == name) return {};
              all += (all.empty() ? "" : ", ") + name;
            }
            return text + " is none of " + all;
          },
          ""};
}

}  // namespace

CommandOption CommandOption::required() const {
  option_->required();
  return *this;
}

CommandOption CommandOption::showDefault() const {
  option_->capture_default_str();
  return *this;
}

CommandOption CommandOption::type(const char* name) const {
  option_->type_name(name);
  return *this;
}

Command Command::add(const char* name, const char* help, const Action& action) const {
  CLI::App* below = app_->add_subcommand(name, help);
  below->callback([chosen = chosen_, action] { *chosen = action; });
  return {*below, *chosen_};
}

Command Command::addGroup(const char* name, const char* help) const {
  CLI::App* below = app_->add_subcommand(name, help);
  below->require_subcommand(0, 1);  // what is none of them is named then
  below->callback([below, chosen = chosen_] {
    if (!below->get_subcommands().empty()) return;
    *chosen = [below]() -> int {
      std::string all;
      for (const CLI::App* each : below->get_subcommands({})) all += (all.empty() ? "" : ", ") + each->get_name();
      throw CommandFailure(kWrongUsage, below->get_name() + ": give one of its commands: " + all);
    };
  });
  return {*below, *chosen_};
}

void Command::footer(const char* text) const {
  app_->footer(text);
}

CommandOption Command::path(const char* name, std::string& value, const char* help) const {
  return CommandOption(app_->add_option(name, value, help)->check(notEmpty()));
}

CommandOption Command::text(const char* name, std::string& value, const char* help) const {
  return CommandOption(app_->add_option(name, value, help));
}

CommandOption Command::texts(const char* name, std::vector<std::string>& values, const char* help) const {
  return CommandOption(
      app_->add_option(name, values, help)->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll));
}

CommandOption Command::number(const char* name, double& value, const Range& range, const char* help) const {
  return CommandOption(app_->add_option(name, value, help)->check(within(range)));
}

CommandOption Command::number(const char* name, std::optional<double>& value, const Range& range,
                              const char* help) const {
  return CommandOption(app_->add_option(name, value, help)->check(within(range)));
}

CommandOption Command::count(const char* name, int& value, const Range& range, const char* help) const {
  return CommandOption(app_->add_option(name, value, help)->check(within(range)));
}

CommandOption Command::choice(const char* name, std::string& value, std::initializer_list<const char*> from,
                              const char* help) const {
  return CommandOption(app_->add_option(name, value, help)->check(oneOf(from)));
}

CommandOption Command::choices(const char* name, std::vector<std::string>& values,
                               std::initializer_list<const char*> from, const char* help) const {
  return CommandOption(app_->add_option(name, values, help)->delimiter(',')->check(oneOf(from)));
}

CommandOption Command::list(const char* name, std::vector<std::string>& values, const char* help) const {
  return CommandOption(app_->add_option(name, values, help)->delimiter(','));
}

CommandOption Command::flag(const char* name, bool& value, const char* help) const {
  return CommandOption(app_->add_flag(name, value, help));
}

void Command::json(bool& value) const {
  flag("--json", value, "Print one JSON object to stdout instead of the table");
}

}  // namespace haptiv
