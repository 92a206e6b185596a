//! `--open`: opens the page in the user's browser.

use std::process::{Command, Stdio};

/// Opens an address in the browser. Returns whether the system's opener was started.
pub(crate) fn open(address: &str) -> bool {
    let mut command = match () {
        () if cfg!(target_os = "macos") => Command::new("open"),
        () if cfg!(windows) => {
            let mut command = Command::new("rundll32");
            command.arg("url.dll,FileProtocolHandler");
            command
        }
        () => Command::new("xdg-open"),
    };
    let process = command.arg(address).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).spawn();
    let Ok(mut process) = process else { return false };
    std::thread::spawn(move || process.wait());
    true
}
