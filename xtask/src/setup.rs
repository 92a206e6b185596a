//! `setup`: the tools for steps of `test`, for scripts that are started separately.

use crate::node::Node;
use crate::requirements;

/// Options of `setup`.
#[derive(clap::Args)]
pub struct Arguments {
    /// The steps
    #[arg(value_name = "STEP", required = true)]
    steps: Vec<String>,
}

/// Installs the packages and the Node of the steps. Prints the folder with Node if it is not on the `PATH`.
///
/// # Errors
/// The tools cannot be installed.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    let steps: Vec<&str> = arguments.steps.iter().map(String::as_str).collect();
    requirements::install(&requirements::missing(&steps)?)?;
    if let Some(folder) = Node::find_or_install()?.folder {
        println!("{folder}");
    }
    Ok(())
}
