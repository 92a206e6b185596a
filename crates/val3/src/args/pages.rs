//! Pages of the book about the command line, one for each command, generated from the declared arguments.
//!
//! The pages are the files in `docs/src/commands`. A test compares them; after a change of arguments,
//! `UPDATE_EXPECT=1 cargo test -p val3 the_pages_of_commands` updates them.

mod markdown;

use clap::builder::PossibleValue;
use clap::{Arg, ArgAction, Command};

use markdown::{bullet, notes, prose};

/// Heading of the global options.
const GLOBAL: &str = "Options of every command";

/// Returns each page with its file name: one page for each command below `command`, and the index.
fn pages(mut command: Command) -> Vec<(String, String)> {
    command.build();
    let mut pages = vec![("index.md".to_owned(), index(&command))];
    collect(&command, &mut pages);
    pages
}

fn collect(command: &Command, pages: &mut Vec<(String, String)>) {
    for child in shown(command) {
        pages.push((file(child), page(child)));
        collect(child, pages);
    }
}

/// Subcommands of `command`, without `help` and hidden ones.
fn shown(command: &Command) -> impl Iterator<Item = &Command> {
    command.get_subcommands().filter(|child| !child.is_hide_set() && child.get_name() != "help")
}

/// Full command name, for example `val3 arm list`.
fn name(command: &Command) -> String {
    command.get_bin_name().unwrap_or_else(|| command.get_name()).to_owned()
}

/// File name of the command's page, for example `arm-list.md`.
fn file(command: &Command) -> String {
    format!("{}.md", name(command).split_whitespace().skip(1).collect::<Vec<_>>().join("-"))
}

fn index(command: &Command) -> String {
    let mut text = String::from(
        "# Commands\n\nEach page lists the arguments, options and exit codes of a command, as `--help` does.\n\n| command | purpose |\n\
         |---|---|\n",
    );
    rows(command, &mut text);
    text.push_str(ENVIRONMENT);
    text
}

fn rows(command: &Command, text: &mut String) {
    for child in shown(command) {
        text.push_str(&format!("| [`{}`]({}) | {} |\n", name(child), file(child), prose(&about(child))));
        rows(child, text);
    }
}

const ENVIRONMENT: &str = "
## Environment variables
| variable | meaning |
|---|---|
| `NO_COLOR` | not empty: no colours, unless `--color` requests them |
| `FORCE_COLOR`, `CLICOLOR_FORCE` | not empty, `0` or `false`: colours also in files and pipes, unless `NO_COLOR` or `--color` forbids them |
| `TERM` | `dumb`: no colours |
| `CI` | not empty and not `false`: a port that only a cell names is not connected |
| `VAL3_TRUST` | folders whose settings may reach outside of their cell, as in `PATH`, in addition to the folders of `val3 trust` |
| `VAL3_PASSWORD` | the password of `val3 pull`, `status`, `push` and `diff` for a controller |
| `VAL3_DEBUG_SECRET` | the secret of `val3 dap --port` and `val3 run --debug-port`; a random one otherwise |
";

/// Description of the command.
fn about(command: &Command) -> String {
    command.get_long_about().or_else(|| command.get_about()).map(ToString::to_string).unwrap_or_default()
}

fn page(command: &Command) -> String {
    let mut text = format!("# {}\n\n{}.\n", name(command), prose(about(command).trim_end_matches('.')));
    let usage = command.clone().render_usage().to_string();
    let usage: Vec<&str> = usage.trim_start_matches("Usage: ").lines().map(str::trim).collect();
    text.push_str(&format!("\n```text\n{}\n```\n", usage.join("\n")));
    let children: Vec<&Command> = shown(command).collect();
    if !children.is_empty() {
        text.push_str("\n## Commands\n");
        for child in children {
            text.push_str(&bullet(&format!("[`{}`]({})", name(child), file(child)), &prose(&about(child))));
        }
    }
    for (heading, arguments) in sections(command) {
        text.push_str(&format!("\n## {heading}\n"));
        arguments
            .iter()
            .for_each(|argument| text.push_str(&bullet(&format!("`{}`", form(argument)), &meaning(argument))));
    }
    let after = command.get_after_long_help().or_else(|| command.get_after_help());
    text.push_str(&notes(&after.map(ToString::to_string).unwrap_or_default()));
    text
}

/// Arguments grouped by heading; the global options are last.
fn sections(command: &Command) -> Vec<(String, Vec<&Arg>)> {
    let mut sections: Vec<(String, Vec<&Arg>)> = Vec::new();
    let mut arguments: Vec<&Arg> = command.get_arguments().filter(|argument| is_listed(argument)).collect();
    arguments.sort_by_key(|argument| (argument.is_global_set(), !argument.is_positional()));
    for argument in arguments {
        let usual = if argument.is_positional() { "Arguments" } else { "Options" };
        let own = argument.get_help_heading().unwrap_or(usual);
        let heading = if argument.is_global_set() { GLOBAL } else { own };
        match sections.iter_mut().find(|(known, _)| known == heading) {
            Some((_, arguments)) => arguments.push(argument),
            None => sections.push((heading.to_owned(), vec![argument])),
        }
    }
    sections
}

/// Whether the page of a command lists the argument.
fn is_listed(argument: &Arg) -> bool {
    !argument.is_hide_set() && !matches!(argument.get_id().as_str(), "help" | "version")
}

/// Syntax of the argument, for example `-q, --quiet`, `--format <FORMAT>` or `[PATH]...`.
fn form(argument: &Arg) -> String {
    let form = argument.to_string();
    match argument.get_short() {
        Some(short) if !argument.is_positional() => format!("-{short}, {form}"),
        _ => form,
    }
}

/// Argument's help text, possible values and default.
fn meaning(argument: &Arg) -> String {
    let help = argument.get_long_help().or_else(|| argument.get_help()).map(ToString::to_string).unwrap_or_default();
    let mut text = format!("{}.", prose(help.trim_end_matches('.')));
    let takes_value = matches!(argument.get_action(), ArgAction::Set | ArgAction::Append);
    let values = if takes_value && !argument.is_hide_possible_values_set() { values(argument) } else { Vec::new() };
    let are_explained = values.iter().any(|(_, help)| !help.is_empty());
    if !values.is_empty() && !are_explained {
        let names: Vec<&str> = values.iter().map(|(name, _)| name.as_str()).collect();
        text.push_str(&format!(" Values: {}.", names.join(", ")));
    }
    let defaults: Vec<_> = argument.get_default_values().iter().map(|value| value.to_string_lossy()).collect();
    if takes_value && !defaults.is_empty() && !argument.is_hide_default_value_set() {
        text.push_str(&format!(" Default: `{}`.", defaults.join(" ")));
    }
    if are_explained {
        text.extend(values.iter().map(|(name, help)| format!("\n  - {name}: {help}")));
    }
    text
}

/// Argument's possible values, formatted as code, each with its help text.
fn values(argument: &Arg) -> Vec<(String, String)> {
    let values = argument.get_possible_values().into_iter().filter(|value| !value.is_hide_set());
    let help = |value: &PossibleValue| value.get_help().map(|help| prose(&help.to_string())).unwrap_or_default();
    values.map(|value| (format!("`{}`", value.get_name()), help(&value))).collect()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::path::Path;

    use clap::CommandFactory as _;
    use expect_test::{expect, expect_file};

    use super::*;
    use crate::args::Args;

    #[test]
    fn the_pages_of_commands_are_up_to_date() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/src/commands");
        let pages = pages(Args::command());
        for (file, text) in &pages {
            expect_file![folder.join(file)].assert_eq(text);
        }
        #[allow(clippy::disallowed_methods, reason = "the files of the book are compared")]
        let files: BTreeSet<String> = std::fs::read_dir(&folder)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        assert_eq!(pages.into_iter().map(|(file, _)| file).collect::<BTreeSet<_>>(), files);
    }

    #[test]
    fn a_page_has_all_parts_of_a_command() {
        let command = Command::new("val3").arg(Arg::new("color").long("color").global(true).help("When")).subcommand(
            Command::new("do")
                .about("Do a thing")
                .arg(Arg::new("path").help("What"))
                .arg(
                    Arg::new("mode")
                        .long("mode")
                        .value_parser(["a", "b"])
                        .default_value("a")
                        .help("With --color: <how> --start=0,1, x"),
                )
                .arg(
                    Arg::new("quiet")
                        .short('q')
                        .long("quiet")
                        .action(ArgAction::SetTrue)
                        .help("Less")
                        .help_heading("Output"),
                )
                .after_help("Exit codes:\n  0  fine\n  1  not\n     fine\n\nA longer line ends:\nhere."),
        );
        let pages = pages(command);
        expect![[r#"
            # val3 do

            Do a thing.

            ```text
            val3 do [OPTIONS] [path]
            ```

            ## Arguments
            - `[path]`: What.

            ## Options
            - `--mode <mode>`: With `--color`: \<how> `--start=0,1`, x. Values: `a`, `b`. Default: `a`.

            ## Output
            - `-q, --quiet`: Less.

            ## Options of every command
            - `--color <color>`: When.

            ## Exit codes
            - `0`: fine
            - `1`: not fine

            A longer line ends: here.
        "#]]
        .assert_eq(&pages.iter().find(|(file, _)| file == "do.md").unwrap().1);
    }
}
