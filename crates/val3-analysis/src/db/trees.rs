//! Cache of syntax trees. A tree depends only on its text, because an incremental or repeated parse yields an equal
//! tree. Trees are therefore no dependencies of queries, and can be dropped at any time.

use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};

use rustc_hash::FxHashMap;
use val3_syntax::{Parse, parse_shared};

use super::inputs::File;

/// Cached trees by file.
#[derive(Debug, Default)]
pub struct Trees(Mutex<TreeCache>);

#[derive(Debug, Default)]
struct TreeCache {
    trees: FxHashMap<File, CachedTree>,
    /// Number of uses so far.
    clock: u64,
}

#[derive(Debug)]
struct CachedTree {
    text: Arc<str>,
    /// Tree, parsed by the first caller. Concurrent callers wait for it.
    parse: Arc<OnceLock<Parse>>,
    /// Value of `clock` at the last use.
    used: u64,
}

impl Trees {
    /// Returns the tree of `text`, the present content of `file`.
    pub(crate) fn parse(&self, file: File, text: &Arc<str>) -> Parse {
        let (parse, before) = self.tree(file, text);
        let former = before.as_ref().and_then(|before| before.parse.get());
        let tree = parse.get_or_init(|| match former {
            Some(former) => former.reparse_as(Arc::clone(text)),
            None => parse_shared(Arc::clone(text)),
        });
        tree.clone()
    }

    /// Returns the cache entry for the tree of `text`, and the previous entry if its text was different.
    fn tree(&self, file: File, text: &Arc<str>) -> (Arc<OnceLock<Parse>>, Option<CachedTree>) {
        let mut kept = self.kept();
        kept.clock += 1;
        let used = kept.clock;
        if let Some(tree) = kept.trees.get_mut(&file).filter(|tree| Arc::ptr_eq(&tree.text, text)) {
            tree.used = used;
            return (Arc::clone(&tree.parse), None);
        }
        let parse = Arc::default();
        let before = kept.trees.insert(file, CachedTree { text: Arc::clone(text), parse: Arc::clone(&parse), used });
        (parse, before)
    }

    /// Removes the trees of `files` from the cache.
    pub fn forget(&self, files: impl IntoIterator<Item = File>) {
        let mut kept = self.kept();
        let forgotten: Vec<CachedTree> = files.into_iter().filter_map(|file| kept.trees.remove(&file)).collect();
        // Dropped after the lock, because dropping a large tree takes time.
        drop(kept);
        drop(forgotten);
    }

    /// Returns the number of cached trees.
    pub fn count(&self) -> usize {
        self.kept().trees.len()
    }

    /// Removes all trees except the `count` most recently used ones.
    pub fn keep_latest(&self, count: usize) {
        let kept = self.kept();
        let Some(surplus) = kept.trees.len().checked_sub(count).filter(|surplus| *surplus > 0) else { return };
        let mut uses: Vec<(u64, File)> = kept.trees.iter().map(|(file, tree)| (tree.used, *file)).collect();
        drop(kept);
        uses.sort_unstable_by_key(|(used, _)| *used);
        self.forget(uses.into_iter().take(surplus).map(|(_, file)| file));
    }

    fn kept(&self) -> MutexGuard<'_, TreeCache> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[cfg(test)]
mod tests {
    use crate::db::Database;
    use crate::items::parse;
    use crate::load::load_into;
    use crate::system::Memory;

    #[test]
    fn the_last_used_trees_are_kept() {
        // Small nodes are shared; this node is too long to be shared.
        let text = format!("<Project>{}</Project>", " ".repeat(80));
        let files = ["a", "b", "c"].map(|name| (format!("/d/{name}/{name}.pjx"), text.clone()));
        let workspace = load_into(Database::default(), &Memory::new(files), &["/d".into()]).unwrap();
        let db = &workspace.db;
        let files = [0, 2, 1].map(|at: usize| workspace.projects[at].manifest(db));
        let trees = files.map(|file| parse(db, file));
        db.trees.keep_latest(2);
        let same = |at: usize| std::ptr::eq(&**parse(db, files[at]).green(), &**trees[at].green());
        assert_eq!([same(1), same(2), same(0)], [true, true, false]);
        assert_eq!(parse(db, files[0]), trees[0]);
        db.trees.forget([files[1]]);
        assert!(!same(1) && same(2));
    }
}
