//! `val3 mcp`: tools for language models. Each call of a tool starts a command of this program as a separate process.

mod process;
mod reader;

use std::process::ExitCode;
use std::sync::Arc;

use val3_mcp::{Refusal, Roots, ServerOptions, serve};

use crate::args::McpArgs;
use crate::paths::current_folder;
use crate::trust::trust_nothing;
use crate::user_error::UserError;
use crate::version::VERSION;

use process::Processes;

/// Serves one client on standard input and output.
///
/// # Errors
/// A root is no folder, a named tool does not exist, or the server cannot start.
pub(crate) fn run(args: &McpArgs) -> Result<ExitCode, UserError> {
    trust_nothing();
    let current = current_folder()?;
    let roots: Vec<_> = args.root.iter().map(|root| current.join(root)).collect();
    let (first, others) = roots.split_first().unwrap_or((&current, &[]));
    let roots = Roots::new(first, others)?;
    let executable = std::env::current_exe()
        .map_err(|error| UserError::new(format!("the path of this program is unknown: {error}")))?;
    let commands = Processes::new(executable, roots.first().to_owned())?;
    let options =
        ServerOptions { version: VERSION.to_owned(), roots, may_write: args.write, tools: args.tools.clone() };
    serve(options, Arc::new(commands))?;
    Ok(ExitCode::SUCCESS)
}

impl From<Refusal> for UserError {
    fn from(refusal: Refusal) -> Self {
        Self::new(refusal.0)
    }
}
