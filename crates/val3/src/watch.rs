//! `val3 check --watch`: reports changes of files that a check reads.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::{Duration, Instant};

use camino::{Utf8Path, Utf8PathBuf};
use notify::{Config, Event, PollWatcher, RecommendedWatcher, RecursiveMode, Watcher};

use crate::user_error::UserError;

/// Duration without an event after which a change is complete, because an editor causes several events when it saves.
const QUIET: Duration = Duration::from_millis(100);

/// Polling interval for systems that do not report changes.
const POLL_INTERVAL: Duration = Duration::from_secs(1);

/// Extensions of files that a check reads.
const EXTENSIONS: [&str; 5] = ["pjx", "dtx", "pgx", "cfx", "toml"];

/// Watches folders.
pub(crate) struct FolderWatch {
    watcher: Box<dyn Watcher>,
    sender: Sender<notify::Result<Event>>,
    events: Receiver<notify::Result<Event>>,
    /// Watched folders; `true` includes subfolders.
    watched: BTreeSet<(Utf8PathBuf, bool)>,
    polls: bool,
}

impl FolderWatch {
    /// Starts to watch `paths` and their subfolders.
    pub(crate) fn start(paths: &[Utf8PathBuf]) -> Result<Self, UserError> {
        let (sender, events) = channel();
        let (watcher, polls): (Box<dyn Watcher>, _) = match RecommendedWatcher::new(sender.clone(), Config::default()) {
            Ok(watcher) => (Box::new(watcher), false),
            Err(_) => (polling(sender.clone())?, true),
        };
        let mut watch = Self { watcher, sender, events, watched: BTreeSet::new(), polls };
        for path in paths {
            watch.include(path, true)?;
        }
        Ok(watch)
    }

    /// Adds a folder, with or without subfolders. A missing folder is skipped.
    pub(crate) fn include(&mut self, folder: &Utf8Path, below: bool) -> Result<(), UserError> {
        if !folder.exists() {
            return Ok(());
        }
        self.watched.insert((folder.to_owned(), below));
        // A folder that was deleted and created again must be registered again.
        match self.watcher.watch(folder.as_std_path(), mode(below)) {
            Err(_) if !self.polls => self.poll_instead(),
            outcome => outcome.map_err(|error| cannot_watch(&error)),
        }
    }

    /// Switches to polling after the system has failed to watch a folder.
    fn poll_instead(&mut self) -> Result<(), UserError> {
        self.watcher = polling(self.sender.clone())?;
        self.polls = true;
        for (folder, below) in &self.watched {
            self.watcher.watch(folder.as_std_path(), mode(*below)).map_err(|error| cannot_watch(&error))?;
        }
        Ok(())
    }

    /// Waits until a change is complete. Returns the first changed file.
    pub(crate) fn changed(&self) -> Result<PathBuf, UserError> {
        let changed = loop {
            let event = self.events.recv().map_err(|_| UserError::new("the system no longer reports file changes"))?;
            if let Some(path) = event.ok().and_then(relevant) {
                break path;
            }
        };
        let mut quiet_from = Instant::now() + QUIET;
        while let Ok(event) = self.events.recv_timeout(quiet_from.saturating_duration_since(Instant::now())) {
            if event.ok().and_then(relevant).is_some() {
                quiet_from = Instant::now() + QUIET;
            }
        }
        Ok(changed)
    }
}

fn mode(below: bool) -> RecursiveMode {
    if below { RecursiveMode::Recursive } else { RecursiveMode::NonRecursive }
}

fn polling(sender: Sender<notify::Result<Event>>) -> Result<Box<dyn Watcher>, UserError> {
    // Times are compared in whole seconds, so a second change within the same second is only detected by the content.
    let config = Config::default().with_poll_interval(POLL_INTERVAL).with_compare_contents(true);
    let watcher = PollWatcher::new(sender, config).map_err(|error| cannot_watch(&error))?;
    Ok(Box::new(watcher))
}

fn cannot_watch(error: &notify::Error) -> UserError {
    UserError::new(format!("cannot watch for changes: {error}"))
}

/// Changed file, if a check reads it. Read access is no change.
fn relevant(event: Event) -> Option<PathBuf> {
    if event.kind.is_access() { None } else { event.paths.into_iter().find(|path| is_source(path)) }
}

/// Whether a check reads files with the extension of the path.
fn is_source(path: &Path) -> bool {
    let extension = path.extension().and_then(|extension| extension.to_str());
    extension.is_some_and(|extension| EXTENSIONS.iter().any(|known| known.eq_ignore_ascii_case(extension)))
}

#[cfg(test)]
mod tests {
    use notify::event::{AccessKind, EventKind, ModifyKind};

    use super::*;

    fn event(kind: EventKind, path: &str) -> Option<PathBuf> {
        relevant(Event::new(kind).add_path(path.into()))
    }

    #[test]
    fn only_changes_of_sources_are_reported() {
        let modified = EventKind::Modify(ModifyKind::Any);
        assert!(event(modified, "a/b.PGX").is_some());
        assert!(event(modified, "a/report.json").is_none());
        assert!(event(modified, "a/.b.pgx.swp").is_none());
        assert!(event(EventKind::Access(AccessKind::Any), "a/b.pgx").is_none());
    }

    #[test]
    fn polling_reports_changes() {
        let folder = tempfile::tempdir().unwrap();
        let path = Utf8PathBuf::from_path_buf(folder.path().to_owned()).unwrap();
        let mut watch = FolderWatch::start(std::slice::from_ref(&path)).unwrap();
        watch.poll_instead().unwrap();
        for text in ["", "a", "b", "c"] {
            std::fs::write(path.join("a.pgx"), text).unwrap();
            assert_eq!(watch.changed().unwrap().file_name(), Some("a.pgx".as_ref()));
        }
    }
}
