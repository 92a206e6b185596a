//! The project's own tasks. `cargo xtask help` lists them.

use std::process::ExitCode;

use clap::{Parser, Subcommand};
use xtask::{build, dap, dist, format, install, metrics, setup, test, tidy, vsix, workspace};

/// The project's own tasks.
#[derive(Parser)]
#[command(name = "cargo xtask")]
struct Arguments {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    /// Format every Rust file, also those that a macro declares
    Fmt(format::Arguments),
    /// Look for what a formatter does not see, and list the largest files and functions
    Tidy,
    /// Run every check and every test of the project, or the steps that are named
    Test(test::Arguments),
    /// Install the tools of steps of `test`, and print the folder with Node if it is not on the `PATH`
    Setup(setup::Arguments),
    /// Pack `val3` into target/packages: the archive, the Python wheel, and the VS Code extension with the server inside
    Dist(build::Arguments),
    /// Pack the VS Code extension with the server inside
    Vsix(build::Arguments),
    /// Install `val3` for this user, and the extension in their VS Code
    Install(build::Arguments),
    /// Write a large workspace of VAL 3 applications
    Workspace(workspace::Arguments),
    /// Generate the types of the Debug Adapter Protocol from its JSON schema
    Dap,
    /// Count the code and measure `val3 check` on a generated workspace
    Metrics(metrics::Arguments),
}

fn main() -> ExitCode {
    let outcome = run(Arguments::parse().task);
    if let Err(error) = outcome {
        eprintln!("error: {error:#}");
        return ExitCode::FAILURE;
    }
    ExitCode::SUCCESS
}

fn run(task: Task) -> anyhow::Result<()> {
    match task {
        Task::Fmt(arguments) => format::run(&arguments),
        Task::Tidy => tidy::run(),
        Task::Test(arguments) => test::run(&arguments),
        Task::Setup(arguments) => setup::run(&arguments),
        Task::Dist(arguments) => dist::run(&arguments),
        Task::Vsix(arguments) => vsix::run(&arguments),
        Task::Install(arguments) => install::run(&arguments),
        Task::Workspace(arguments) => workspace::run(&arguments),
        Task::Dap => dap::run(),
        Task::Metrics(arguments) => metrics::run(&arguments),
    }
}
