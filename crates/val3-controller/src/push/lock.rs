//! Lock against a second push: a file below the applications. It is advisory, because FTP has no exclusive creation.

use crate::access::ControllerFiles;
use crate::error::ControllerError;
use crate::path::ControllerPath;
use crate::rules::LOCK_NAME;
use crate::scan::Presence;

/// Age from which a lock is left over from a killed push, in seconds.
const STALE_SECONDS: u64 = 600;

/// Limit of a lock file in bytes.
const LIMIT: u64 = 4096;

/// The user who pushes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LockOwner {
    /// User name.
    pub user: String,
    /// Name of the computer.
    pub host: String,
}

/// Returns the text of a lock. `time` is in seconds since 1970.
pub(super) fn text(owner: &LockOwner, time: u64) -> String {
    let shown = |text: &str| text.chars().filter(|character| !character.is_control()).take(100).collect::<String>();
    format!("val3 push by {} at {}\ntime {time}\n", shown(&owner.user), shown(&owner.host))
}

fn path() -> Result<ControllerPath, ControllerError> {
    ControllerPath::applications().child(LOCK_NAME).map_err(ControllerError::Name)
}

/// Writes the lock, unless another push holds it.
///
/// # Errors
/// If another lock is not stale, or the lock cannot be written.
pub(super) fn acquire(files: &mut dyn ControllerFiles, text: &str, now: u64) -> Result<(), ControllerError> {
    check_free(files, text, now)?;
    files.write(&path()?, text.as_bytes())?;
    check(files, text)
}

/// Checks that no other push holds the lock.
///
/// # Errors
/// If another lock is not stale, or the lock cannot be read.
pub(super) fn check_free(files: &mut dyn ControllerFiles, text: &str, now: u64) -> Result<(), ControllerError> {
    match read(files, &path()?)? {
        Some(other) if !text.starts_with(&other) && !is_stale(&other, now) => {
            let ahead = time_of(&other).map_or(0, |time| time.saturating_sub(now));
            Err(held(&other, if ahead > STALE_SECONDS { ahead } else { 0 }))
        }
        _ => Ok(()),
    }
}

/// Checks that the lock still has this text.
///
/// # Errors
/// If another push has written the lock, or it cannot be read.
pub(super) fn check(files: &mut dyn ControllerFiles, text: &str) -> Result<(), ControllerError> {
    match read(files, &path()?)? {
        Some(found) if found == text => Ok(()),
        Some(other) => Err(held(&other, 0)),
        None => Err(ControllerError::ChangedMeanwhile(path()?)),
    }
}

/// Removes the lock if it has this text.
///
/// # Errors
/// If the lock cannot be read or removed.
pub(super) fn release(files: &mut dyn ControllerFiles, text: &str) -> Result<(), ControllerError> {
    let path = path()?;
    match read(files, &path)? {
        // A part of the text is left over from a lost connection.
        Some(found) if text.starts_with(&found) => Ok(files.remove(&path)?),
        _ => Ok(()),
    }
}

fn read(files: &mut dyn ControllerFiles, path: &ControllerPath) -> Result<Option<String>, ControllerError> {
    if !Presence::default().has(files, path)? {
        return Ok(None);
    }
    let bytes = files.read(path, LIMIT)?;
    Ok(Some(String::from_utf8_lossy(&bytes).into_owned()))
}

fn held(lock: &str, ahead: u64) -> ControllerError {
    ControllerError::Locked { owner: lock.lines().next().unwrap_or_default().to_owned(), ahead }
}

/// Whether the lock has no time, or an old one. A lock from a clock that is ahead does not end by itself: whether its push
/// is running cannot be known, so that a person decides.
fn is_stale(text: &str, now: u64) -> bool {
    time_of(text).is_none_or(|time| now.saturating_sub(time) > STALE_SECONDS)
}

/// Time in a lock, in seconds since 1970 on the owner's clock.
fn time_of(text: &str) -> Option<u64> {
    text.lines().find_map(|line| line.strip_prefix("time ")).and_then(|time| time.trim().parse().ok())
}
