//! `val3 lsp`: the language server.

use std::process::ExitCode;

use val3_lsp::ServerOptions;

use crate::args::LspArgs;
use crate::user_error::UserError;
use crate::version::VERSION;

/// Serves one client. The exit code states whether the client has ended the session as the protocol requires.
pub(crate) fn run(args: &LspArgs) -> Result<ExitCode, UserError> {
    let executable = std::env::current_exe().ok().and_then(|path| path.into_os_string().into_string().ok());
    let defaults = ServerOptions::default();
    let executable = executable.unwrap_or(defaults.executable);
    let options = ServerOptions { log: args.log.clone(), executable, version: VERSION.to_owned() };
    let code = val3_lsp::run(std::io::stdin(), std::io::stdout(), &options)
        .map_err(|error| UserError::new(format!("the language server cannot start: {error}")))?;
    Ok(ExitCode::from(code))
}
