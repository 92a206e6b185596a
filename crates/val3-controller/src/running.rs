//! Applications that run on the controller, according to its log.
//!
//! CS9 writes JSON lines to `user.log`, CS8 text to `errors.log`. An entry 0x5402 states that an application has
//! started, 0x5403 that it has stopped; the name is in quotes. This was seen in logs of real controllers, not tried.

use std::collections::BTreeSet;

use crate::access::ControllerFiles;
use crate::error::ControllerError;
use crate::path::ControllerPath;
use crate::scan::Presence;

/// Folder of the controller's logs.
pub const LOG_FOLDER: &str = "log";

/// Logs, the first existing one counts.
const LOGS: [&str; 2] = ["log/user.log", "log/errors.log"];

/// Limit of a log in bytes. A CS9 log with 147,000 entries has about 30 MB.
const LIMIT: u64 = 100 << 20;

/// Codes of the start and the end of an application.
const STARTED: &str = "0x5402";
const STOPPED: &str = "0x5403";

/// Returns the applications that have started and not stopped; `None` if no log states anything about applications.
///
/// # Errors
/// If a log exists and cannot be read.
pub fn running_applications(files: &mut dyn ControllerFiles) -> Result<Option<BTreeSet<String>>, ControllerError> {
    let mut presence = Presence::default();
    for log in LOGS {
        let path = ControllerPath::parse(log).map_err(ControllerError::Name)?;
        if presence.has(files, &path)? {
            let bytes = files.read(&path, LIMIT)?;
            return Ok(running(&String::from_utf8_lossy(&bytes)));
        }
    }
    Ok(None)
}

fn running(log: &str) -> Option<BTreeSet<String>> {
    let mut running = None;
    for line in log.lines() {
        let set: &mut BTreeSet<String> = match line {
            _ if line.contains(STARTED) || line.contains(STOPPED) => running.get_or_insert_default(),
            _ => continue,
        };
        let Some(name) = quoted(line) else { continue };
        if line.contains(STARTED) {
            set.insert(name.to_owned());
        } else {
            set.remove(name);
        }
    }
    running
}

/// Text between single quotes.
fn quoted(line: &str) -> Option<&str> {
    line.split_once('\'')?.1.split_once('\'').map(|(name, _)| name)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(log: &str) -> Option<Vec<String>> {
        running(log).map(|names| names.into_iter().collect())
    }

    #[test]
    fn the_last_entry_of_an_application_counts() {
        let entry = |code: &str, text: &str| {
            format!("{{\"entry\":{{\"lvl\":\"INFO\",\"id\":\"{code}\",\"val\":\"{text}\"}},\"hash\":\"0\"}}\n")
        };
        let log = [
            entry(STARTED, "Application 'a' started."),
            entry(STARTED, "Application 'b' started."),
            entry("0x5464", "'c' is only a message"),
            entry(STOPPED, "Application 'a' stopped."),
        ];
        assert_eq!(names(&log.concat()), Some(vec!["b".to_owned()]));
        assert_eq!(names("[01/05/21 08:00:00]: <0x5402> Application 'a' started. {0000}"), Some(vec!["a".to_owned()]));
        assert_eq!(names("Logger started\n"), None);
    }
}
