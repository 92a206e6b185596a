//! Commands as child processes with limits.

use std::io::{self, Write as _};
use std::path::PathBuf;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use camino::Utf8PathBuf;
use tempfile::TempDir;
use val3_files::replace;
use val3_mcp::{CommandEnd, CommandLimits, CommandOutput, CommandRequest, Commands};

use super::reader::OutputReader;
use crate::user_error::UserError;

/// Name of the file with the script of a run.
const SCRIPT: &str = "script.toml";

/// Polling interval for the state of a process.
const PAUSE: Duration = Duration::from_millis(2);

/// Starts this program with the arguments of commands.
#[derive(Debug)]
pub(super) struct Processes {
    executable: PathBuf,
    /// Folder in which commands are started.
    folder: Utf8PathBuf,
    /// Empty folder with the settings of a user who trusts nothing.
    settings: TempDir,
}

impl Processes {
    /// # Errors
    /// The temporary folder cannot be created.
    pub(super) fn new(executable: PathBuf, folder: Utf8PathBuf) -> Result<Self, UserError> {
        Ok(Self { executable, folder, settings: temporary().map_err(|error| UserError::new(error.to_string()))? })
    }

    /// Command without the permissions in the user's settings and environment, so that the files of an untrusted cell
    /// cannot reach devices, other machines or outside folders.
    fn command(&self) -> Command {
        let mut command = Command::new(&self.executable);
        command.current_dir(&self.folder).env("NO_COLOR", "1").env("CI", "1").env_remove("VAL3_TRUST");
        for folder in ["XDG_CONFIG_HOME", "APPDATA"] {
            command.env(folder, self.settings.path());
        }
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        command
    }
}

fn temporary() -> io::Result<TempDir> {
    tempfile::Builder::new().prefix("val3-mcp-").tempdir()
}

/// Creates a folder with a script.
fn folder_with(script: &str) -> io::Result<TempDir> {
    let folder = temporary()?;
    let path = Utf8PathBuf::try_from(folder.path().join(SCRIPT)).map_err(io::Error::other)?;
    replace(&path, script.as_bytes()).map_err(|reason| io::Error::other(reason.to_string()))?;
    Ok(folder)
}

impl Commands for Processes {
    fn start(&self, request: &CommandRequest, is_cancelled: &dyn Fn() -> bool) -> Result<CommandOutput, CommandEnd> {
        let failed = |error: io::Error| CommandEnd::Start(error.to_string());
        let mut command = self.command();
        command.args(&request.arguments);
        let folder = request.script.as_deref().map(folder_with).transpose().map_err(failed)?;
        if let Some(folder) = &folder {
            command.arg("--script").arg(folder.path().join(SCRIPT));
        }
        let mut child = command.spawn().map_err(failed)?;
        limit_memory(&child, request.limits);
        let input = child.stdin.take();
        let text = request.input.clone();
        // A process may end without reading its input.
        let writer = thread::spawn(move || input.map(|mut input| input.write_all(text.as_bytes())));
        let output = OutputReader::of(child.stdout.take());
        let messages = OutputReader::of(child.stderr.take());
        let ended = wait(&mut child, request.limits, is_cancelled, &[&output, &messages]);
        drop(writer);
        let status = ended?;
        let folder = folder.as_ref().and_then(|folder| folder.path().to_str());
        let [text, messages] = [output.text(), messages.text()].map(|text| without_folder(text, folder));
        match status.code() {
            Some(exit_code) if !is_panic(exit_code) => Ok(CommandOutput { exit_code, text, messages }),
            _ => Err(CommandEnd::Crash(last_lines(&messages))),
        }
    }
}

/// Shortens the paths of files in the folder with the script to their names.
fn without_folder(text: String, folder: Option<&str>) -> String {
    match folder {
        Some(folder) => text.replace(&format!("{folder}/"), ""),
        None => text,
    }
}

/// Whether the process has ended by a panic.
fn is_panic(exit_code: i32) -> bool {
    exit_code == 101
}

/// Waits for the end of the process, and ends it at a limit.
fn wait(
    child: &mut Child,
    limits: CommandLimits,
    is_cancelled: &dyn Fn() -> bool,
    outputs: &[&OutputReader],
) -> Result<ExitStatus, CommandEnd> {
    let begun = Instant::now();
    loop {
        if let Some(status) = child.try_wait().map_err(|error| CommandEnd::Start(error.to_string()))? {
            return Ok(status);
        }
        let end = if is_cancelled() {
            CommandEnd::Cancelled
        } else if begun.elapsed() > limits.wall {
            CommandEnd::Time
        } else if outputs.iter().any(|output| output.is_full()) {
            CommandEnd::Output
        } else {
            thread::sleep(PAUSE);
            continue;
        };
        // The process may have ended by itself in the meantime.
        let _ = child.kill();
        let _ = child.wait();
        return Err(end);
    }
}

/// Last lines of a process's messages, for a process that has ended unexpectedly.
fn last_lines(messages: &str) -> String {
    let lines: Vec<&str> = messages.lines().filter(|line| !line.trim().is_empty()).collect();
    let skipped = lines.len().saturating_sub(5);
    lines.iter().skip(skipped).copied().collect::<Vec<_>>().join("\n")
}

/// Limits the memory of a process, on systems where another process can set this limit.
#[cfg(target_os = "linux")]
fn limit_memory(child: &Child, limits: CommandLimits) {
    use rustix::process::{Pid, Resource, Rlimit, prlimit};

    let limit = Rlimit { current: Some(limits.memory), maximum: Some(limits.memory) };
    if let Some(pid) = i32::try_from(child.id()).ok().and_then(Pid::from_raw) {
        // The process may have ended already.
        let _ = prlimit(Some(pid), Resource::Data, limit);
    }
}

#[cfg(not(target_os = "linux"))]
fn limit_memory(_: &Child, _: CommandLimits) {}
