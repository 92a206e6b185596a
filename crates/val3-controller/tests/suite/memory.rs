//! A controller in memory, without sockets, that dies at a chosen operation, so that tests can try every operation.

use std::sync::{Arc, Mutex, MutexGuard};

use val3_controller::{AccessError, AccessFault, ControllerFiles, ControllerPath, ListedEntry};

use crate::server::{Death, Tree};

/// State that all connections share.
#[derive(Debug, Default)]
pub(crate) struct MemoryState {
    pub(crate) tree: Tree,
    /// Number of the operation at which the controller dies, from 0.
    pub(crate) death: Option<(usize, Death)>,
    /// Whether renaming over a file is rejected.
    pub(crate) keeps_targets: bool,
    pub(crate) is_dead: bool,
    /// Number of operations.
    pub(crate) count: usize,
}

/// A connection to the controller.
#[derive(Debug, Clone, Default)]
pub(crate) struct MemoryFiles(Arc<Mutex<MemoryState>>);

impl MemoryFiles {
    pub(crate) fn new(tree: Tree, keeps_targets: bool) -> Self {
        Self(Arc::new(Mutex::new(MemoryState { tree, keeps_targets, ..MemoryState::default() })))
    }

    pub(crate) fn state(&self) -> MutexGuard<'_, MemoryState> {
        self.0.lock().unwrap()
    }

    /// Revives the controller, which dies at an operation from now on.
    pub(crate) fn revive(&self, death: Option<(usize, Death)>) {
        let mut state = self.state();
        (state.is_dead, state.death, state.count) = (false, death, 0);
    }

    /// Executes an operation. `half` is its effect if the controller dies in the middle.
    fn execute<T>(
        &self,
        half: impl FnOnce(&mut Tree),
        operation: impl FnOnce(&mut Tree) -> Option<T>,
    ) -> Result<T, AccessError> {
        let error = |reason| AccessError { step: "work".into(), place: "memory".into(), reason };
        let dead = || error(AccessFault::Connection("dead".into()));
        let mut state = self.state();
        if state.is_dead {
            return Err(dead());
        }
        let number = state.count;
        state.count += 1;
        let rejected = || error(AccessFault::Rejected { code: 550, text: "no".into() });
        match state.death.filter(|(at, _)| *at == number).map(|(_, death)| death) {
            None => operation(&mut state.tree).ok_or_else(rejected),
            Some(death) => {
                match death {
                    Death::Before => {}
                    Death::Half => half(&mut state.tree),
                    Death::After => _ = operation(&mut state.tree),
                }
                state.is_dead = true;
                Err(dead())
            }
        }
    }

    fn simple<T>(&self, operation: impl FnOnce(&mut Tree) -> Option<T>) -> Result<T, AccessError> {
        self.execute(|_| {}, operation)
    }
}

fn key(path: &ControllerPath) -> String {
    format!("/{}", path.as_str()).trim_end_matches('/').to_owned()
}

impl ControllerFiles for MemoryFiles {
    fn place(&self) -> &str {
        "memory"
    }

    fn list(&mut self, folder: &ControllerPath) -> Result<Vec<ListedEntry>, AccessError> {
        let at = key(folder);
        self.simple(|tree| {
            tree.folders.contains(&at).then_some(())?;
            let inner = |path: &String| {
                let (parent, name) = path.rsplit_once('/')?;
                (parent == at && !name.is_empty()).then(|| folder.child(name).unwrap())
            };
            let files = tree.files.keys().filter_map(inner).map(|path| ListedEntry { path, is_folder: false });
            let folders = tree.folders.iter().filter_map(inner).map(|path| ListedEntry { path, is_folder: true });
            Some(files.chain(folders).collect())
        })
    }

    fn read(&mut self, file: &ControllerPath, limit: u64) -> Result<Vec<u8>, AccessError> {
        let bytes = self.simple(|tree| tree.files.get(&key(file)).cloned())?;
        let reason = AccessFault::TooLarge(limit);
        if bytes.len() as u64 <= limit {
            Ok(bytes)
        } else {
            Err(AccessError { step: String::new(), place: String::new(), reason })
        }
    }

    fn write(&mut self, file: &ControllerPath, bytes: &[u8]) -> Result<(), AccessError> {
        let half = bytes[..bytes.len() / 2].to_vec();
        self.execute(
            |tree| _ = tree.files.insert(key(file), half),
            |tree| {
                tree.files.insert(key(file), bytes.to_vec());
                Some(())
            },
        )
    }

    fn rename(&mut self, from: &ControllerPath, to: &ControllerPath) -> Result<(), AccessError> {
        let keeps_targets = self.state().keeps_targets;
        self.simple(|tree| {
            if keeps_targets && tree.files.contains_key(&key(to)) {
                return None;
            }
            let bytes = tree.files.remove(&key(from))?;
            tree.files.insert(key(to), bytes);
            Some(())
        })
    }

    fn remove(&mut self, file: &ControllerPath) -> Result<(), AccessError> {
        self.simple(|tree| tree.files.remove(&key(file)).map(|_| ()))
    }

    fn make_folder(&mut self, folder: &ControllerPath) -> Result<(), AccessError> {
        self.simple(|tree| tree.folders.insert(key(folder)).then_some(()))
    }

    fn remove_folder(&mut self, folder: &ControllerPath) -> Result<(), AccessError> {
        self.simple(|tree| {
            let prefix = format!("{}/", key(folder));
            let is_empty = !tree.files.keys().chain(&tree.folders).any(|path| path.starts_with(&prefix));
            (is_empty && tree.folders.remove(&key(folder))).then_some(())
        })
    }

    fn reconnect(&mut self) -> Result<(), AccessError> {
        self.simple(|_| Some(()))
    }
}
