// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace lanefuse {

/// The command line while it is built and parsed. Only files named *arguments.cpp include this: CLI11 costs
/// half a minute to compile.
struct CommandLine {
  CLI::App app;
  std::vector<std::shared_ptr<void>> options;  ///< what the subcommands are parsed into
  std::function<int()> action;                 ///< of the subcommand that was named

  /// Room for one subcommand's options, which lives as long as the command line.
  template <typename Options>
  Options& make() {
    const auto room = std::make_shared<Options>();
    options.push_back(room);
    return *room;
  }
};

/// A check for unsigned numbers: CLI11 reads "-1" into one as 2^64 - 1, and names the largest double as its
/// own check's other end.
std::string not_negative(const std::string& text);

/// One of the subcommands must be named. CLI11's own check would call an unknown name a missing one.
void demand_subcommand(CLI::App& app);

/// --json and --force, which every subcommand has; then `run_command` is what the subcommand does.
template <typename Options, typename Command>
void finish(CLI::App& command, CommandLine& line, Options& options, Command run_command) {
  command.add_flag("--json", options.json, "print the result as JSON on standard output");
  command.add_flag("--force", options.force, "overwrite outputs that are there already");
  command.callback([&line, &options, run_command] {
    line.action = [&options, run_command] { return run_command(options); };
  });
}

/// Subcommands that have a file of their own.
void add_bench(CommandLine& line);
void add_benchmark(CommandLine& line);
void add_calibrate(CommandLine& line);
void add_evaluate(CommandLine& line);
void add_graph(CommandLine& line);
void add_import(CommandLine& line);
void add_map(CommandLine& line);
void add_overlay(CommandLine& line);
void add_simulate(CommandLine& line);

/// The subcommands of `map` that make maps of drives and use them.
void add_survey(CLI::App& map, CommandLine& line);

}  // namespace lanefuse
