//! The trees of files that are being edited, to make the next ones of.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use val3_syntax::Parse;

use super::File;

/// Files of which the latest tree is kept. More are seldom edited by turns.
const FILES: usize = 4;

/// The latest trees of a few files. They say nothing that the texts do not say: a tree that is made of another one is
/// equal to one made anew, only faster to make.
#[derive(Debug, Default)]
pub struct LatestTrees(Mutex<Vec<Latest>>);

#[derive(Debug)]
struct Latest {
    file: File,
    text: Arc<str>,
    parse: Parse,
}

impl LatestTrees {
    /// The tree of `text`, which is what `file` holds now.
    pub(crate) fn parse(&self, file: File, text: &Arc<str>) -> Parse {
        let latest = self.take(file);
        let parse = match &latest {
            Some(latest) => latest.parse.reparse_as(&latest.text, text),
            None => val3_syntax::parse(text),
        };
        self.put(Latest { file, text: Arc::clone(text), parse: parse.clone() });
        parse
    }

    fn take(&self, file: File) -> Option<Latest> {
        let mut trees = self.trees();
        let at = trees.iter().position(|latest| latest.file == file)?;
        Some(trees.remove(at))
    }

    fn put(&self, latest: Latest) {
        let mut trees = self.trees();
        let forgotten = (trees.len() >= FILES).then(|| trees.remove(0));
        trees.push(latest);
        drop(trees);
        // A large tree takes a while to be taken apart.
        drop(forgotten);
    }

    fn trees(&self) -> MutexGuard<'_, Vec<Latest>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
