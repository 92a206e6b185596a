//! Ends the server when its client process has ended.

use std::time::Duration;

#[cfg(target_os = "linux")]
use val3_files::FileClass;

/// Polling interval for the client process.
const INTERVAL: Duration = Duration::from_secs(2);

/// Ends this process when the client process has ended. On systems without support, the end of the input ends the
/// server.
pub(crate) fn die_with(client: u32) {
    if !is_alive(client) {
        // The client process is not visible, for example from inside a container.
        return;
    }
    // Without this thread, the end of the input still ends the server.
    let _ = std::thread::Builder::new().name("client".to_owned()).spawn(move || exit_after(client));
}

/// Ends this process when the client process has ended.
fn exit_after(client: u32) {
    while is_alive(client) {
        std::thread::sleep(INTERVAL);
    }
    std::process::exit(1);
}

#[cfg(target_os = "linux")]
fn is_alive(process: u32) -> bool {
    // A zombie process has ended, although its parent has not collected its exit status yet.
    val3_files::read_text(format!("/proc/{process}/stat").as_str().into(), FileClass::Settings)
        .is_ok_and(|stat| !stat.rsplit(')').next().is_some_and(|rest| rest.trim_start().starts_with('Z')))
}

#[cfg(not(target_os = "linux"))]
fn is_alive(process: u32) -> bool {
    let mut command = if cfg!(windows) {
        let mut command = std::process::Command::new("tasklist");
        command.args(["/NH", "/FI", &format!("PID eq {process}")]);
        command
    } else {
        let mut command = std::process::Command::new("ps");
        command.args(["-p", &process.to_string()]);
        command
    };
    let output = command.stdin(std::process::Stdio::null()).output();
    output.is_ok_and(|output| String::from_utf8_lossy(&output.stdout).contains(&process.to_string()))
}
