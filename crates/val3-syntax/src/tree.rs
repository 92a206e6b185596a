//! Tree of a text as one list, in which a node precedes its children.
//!
//! The list is allocated and freed as one block. An entry has a length but no position, so a range of entries is valid
//! in every tree. [`View`](crate::view::View)s walk down the list. The rowan tree, which can also be walked upwards and
//! sideways, is built from it on demand ([`green`]).

mod green;
mod sharing;
mod visits;

use std::ops::Range;
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};

use rowan::{GreenNode, TextRange, TextSize};

use crate::edit::Change;
use crate::kind::SyntaxKind;
use crate::never::{TextSlice, text_at};

pub use visits::visits;

/// A text and its tree.
#[derive(Debug)]
pub(crate) struct SourceTree {
    text: Arc<str>,
    entries: Box<[TreeEntry]>,
    green: OnceLock<GreenNode>,
    /// A similar tree that has its rowan tree, until this tree has its own.
    before: Mutex<Option<Arc<Self>>>,
}

/// Entry of a node or token.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct TreeEntry {
    pub(crate) kind: SyntaxKind,
    /// Length of the text in bytes.
    pub(crate) len: u32,
    /// Number of entries below it at any depth, which follow it in the list.
    pub(crate) size: u32,
}

/// Replacement of a range of entries by slices from another tree.
pub(crate) struct Splice<'n> {
    pub(crate) range: Range<usize>,
    pub(crate) new: &'n [&'n [TreeEntry]],
}

/// A node or token with its position.
#[derive(Debug, Clone, Copy)]
pub(crate) struct NodeRef<'t> {
    tree: &'t SourceTree,
    index: u32,
    start: TextSize,
}

impl SourceTree {
    /// Creates a tree from entries; the first entry contains all others.
    pub(crate) fn new(text: Arc<str>, entries: Vec<TreeEntry>) -> Self {
        Self { text, entries: entries.into_boxed_slice(), green: OnceLock::new(), before: Mutex::default() }
    }

    /// Returns the tree of `text`, which is this tree's text after `change`: the entries in `range` are replaced by
    /// `new`. All nodes in `around`, innermost last, contain this range.
    pub(crate) fn spliced(&self, text: Arc<str>, change: Change, around: &[NodeRef<'_>], splice: &Splice<'_>) -> Self {
        let Splice { range, new } = splice;
        let (before, rest) = self.entries.split_at(range.start.min(self.entries.len()));
        let after = rest.part(range.len()..);
        let size: usize = new.iter().map(|entries| entries.len()).sum();
        let mut entries = Vec::with_capacity(before.len() + size + after.len());
        entries.extend_from_slice(before);
        new.iter().for_each(|new| entries.extend_from_slice(new));
        entries.extend_from_slice(after);
        for piece in around {
            if let Some(entry) = entries.get_mut(piece.index()) {
                entry.len = change.moved(TextSize::new(entry.len)).into();
                entry.size = count(entry.size as usize + size - range.len());
            }
        }
        Self::new(text, entries)
    }

    /// Records that this tree is similar to `other`, so that its rowan tree may share nodes with the latest rowan tree.
    pub(crate) fn follow(&self, other: &Arc<Self>) {
        let before = if other.green.get().is_some() { Some(Arc::clone(other)) } else { other.before().clone() };
        *self.before() = before;
    }

    fn before(&self) -> MutexGuard<'_, Option<Arc<Self>>> {
        self.before.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub(crate) fn text(&self) -> &Arc<str> {
        &self.text
    }

    pub(crate) fn root(&self) -> NodeRef<'_> {
        NodeRef { tree: self, index: 0, start: TextSize::new(0) }
    }

    /// Returns the rowan tree, which is created on demand.
    pub(crate) fn green(&self) -> &GreenNode {
        self.green.get_or_init(|| {
            // Released before building, so that a concurrent edit does not wait for it.
            let before = self.before().take();
            before
                .map_or_else(|| green::build_green(self.root()), |before| green::renewed(self, &before, before.green()))
        })
    }
}

/// Compares text and entries, which determine the rowan tree.
impl PartialEq for SourceTree {
    fn eq(&self, other: &Self) -> bool {
        self.text == other.text && self.entries == other.entries
    }
}

impl Eq for SourceTree {}

/// Converts a number of entries. A byte of text has only a few entries, so the memory limit is reached before an
/// overflow.
pub(crate) fn count(entries: usize) -> u32 {
    u32::try_from(entries).unwrap_or(u32::MAX)
}

/// Entry for an index after the last entry.
const NOTHING: TreeEntry = TreeEntry { kind: SyntaxKind::EOF, len: 0, size: 0 };

impl<'t> NodeRef<'t> {
    fn entry(self) -> TreeEntry {
        self.tree.entries.get(self.index()).copied().unwrap_or(NOTHING)
    }

    /// Returns the index of the piece's entry.
    pub(crate) fn index(self) -> usize {
        self.index as usize
    }

    /// Returns the entries of the piece and everything below it.
    pub(crate) fn entries(self) -> &'t [TreeEntry] {
        self.tree.entries.get(self.indexes()).unwrap_or(&[])
    }

    /// Returns entries of the piece's tree.
    pub(crate) fn entries_of_tree(self, range: Range<usize>) -> &'t [TreeEntry] {
        self.tree.entries.part(range)
    }

    /// Returns the index range of the piece's entries.
    pub(crate) fn indexes(self) -> Range<usize> {
        self.index()..self.index() + 1 + self.entry().size as usize
    }

    pub(crate) fn kind(self) -> SyntaxKind {
        self.entry().kind
    }

    pub(crate) fn range(self) -> TextRange {
        TextRange::at(self.start, TextSize::new(self.entry().len))
    }

    pub(crate) fn text(self) -> &'t str {
        text_at(&self.tree.text, self.range())
    }

    /// Returns the nodes that contain `range`, from this one to the innermost. An empty range between two nodes is in
    /// the first.
    pub(crate) fn path_to(self, range: TextRange) -> impl Iterator<Item = NodeRef<'t>> {
        let holds = move |piece: &NodeRef<'_>| piece.kind().is_node() && piece.range().contains_range(range);
        std::iter::successors(Some(self), move |piece| piece.children().find(holds))
    }

    /// Returns the children in order.
    pub(crate) fn children(self) -> Children<'t> {
        let first = NodeRef { index: self.index + 1, ..self };
        Children { next: first, end: first.index + self.entry().size }
    }
}

/// Direct children of a piece.
#[derive(Debug, Clone)]
pub(crate) struct Children<'t> {
    next: NodeRef<'t>,
    /// Index after the last child.
    end: u32,
}

impl<'t> Iterator for Children<'t> {
    type Item = NodeRef<'t>;

    fn next(&mut self) -> Option<NodeRef<'t>> {
        let piece = self.next;
        if piece.index >= self.end {
            return None;
        }
        visits::count_visit();
        let entry = piece.entry();
        self.next.index += 1 + entry.size;
        self.next.start += TextSize::new(entry.len);
        Some(piece)
    }
}
