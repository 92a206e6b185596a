//! The tree of a text as one list: a node precedes its children.
//!
//! Such a list is made and given back in one piece. An entry has a length but no position, so a range of entries has
//! the same meaning in every tree. [`View`](crate::view::View)s walk down the list; rowan's tree, which can also be
//! walked upwards and sideways, is built from it on demand ([`green`]).

mod green;
mod sharing;
mod visits;

use std::ops::Range;
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};

use rowan::{GreenNode, TextRange, TextSize};

use crate::edit::Change;
use crate::kind::SyntaxKind;
use crate::never::{Part, text_at};

pub use visits::visits;

/// A text and its tree.
#[derive(Debug)]
pub(crate) struct Tree {
    text: Arc<str>,
    entries: Box<[Entry]>,
    green: OnceLock<GreenNode>,
    /// A tree much like this one that has its rowan tree, until this one has.
    before: Mutex<Option<Arc<Self>>>,
}

/// A node or token.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Entry {
    pub(crate) kind: SyntaxKind,
    /// Length of its text in bytes.
    pub(crate) len: u32,
    /// How many entries it holds, at any depth: those that follow it.
    pub(crate) size: u32,
}

/// Stretches of entries in the place of others.
pub(crate) struct Splice<'n> {
    pub(crate) range: Range<usize>,
    pub(crate) new: &'n [&'n [Entry]],
}

/// A node or token with its place.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Piece<'t> {
    tree: &'t Tree,
    index: u32,
    start: TextSize,
}

impl Tree {
    /// A tree of entries of which the first holds all others.
    pub(crate) fn new(text: Arc<str>, entries: Vec<Entry>) -> Self {
        Self { text, entries: entries.into_boxed_slice(), green: OnceLock::new(), before: Mutex::default() }
    }

    /// The tree of `text`, which is that of this tree after `change`: the entries of `range` gave way to `new`. All of
    /// `around`, innermost last, hold that place.
    pub(crate) fn spliced(&self, text: Arc<str>, change: Change, around: &[Piece<'_>], splice: &Splice<'_>) -> Self {
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

    /// This tree is much like `other`: its rowan tree may share nodes with the one that was made last.
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

    pub(crate) fn root(&self) -> Piece<'_> {
        Piece { tree: self, index: 0, start: TextSize::new(0) }
    }

    /// The rowan tree, created on demand.
    pub(crate) fn green(&self) -> &GreenNode {
        self.green.get_or_init(|| {
            // Out of its lock: an edit on the way does not wait until the tree is made.
            let before = self.before().take();
            before
                .map_or_else(|| green::build_green(self.root()), |before| green::renewed(self, &before, before.green()))
        })
    }
}

/// The rowan tree follows from the rest.
impl PartialEq for Tree {
    fn eq(&self, other: &Self) -> bool {
        self.text == other.text && self.entries == other.entries
    }
}

impl Eq for Tree {}

/// A number of entries. A byte of text has few of them, so memory is full before there are too many.
pub(crate) fn count(entries: usize) -> u32 {
    u32::try_from(entries).unwrap_or(u32::MAX)
}

/// The index after the last entry.
const NOTHING: Entry = Entry { kind: SyntaxKind::EOF, len: 0, size: 0 };

impl<'t> Piece<'t> {
    fn entry(self) -> Entry {
        self.tree.entries.get(self.index()).copied().unwrap_or(NOTHING)
    }

    /// The index of its entry in the list.
    pub(crate) fn index(self) -> usize {
        self.index as usize
    }

    /// Its entry with those below.
    pub(crate) fn entries(self) -> &'t [Entry] {
        self.tree.entries.get(self.indexes()).unwrap_or(&[])
    }

    /// Entries of its tree.
    pub(crate) fn entries_of_tree(self, range: Range<usize>) -> &'t [Entry] {
        self.tree.entries.part(range)
    }

    /// Their range in the list.
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

    /// The nodes that hold `range`, from this one to the innermost. An empty range between two nodes is in the first.
    pub(crate) fn path_to(self, range: TextRange) -> impl Iterator<Item = Piece<'t>> {
        let holds = move |piece: &Piece<'_>| piece.kind().is_node() && piece.range().contains_range(range);
        std::iter::successors(Some(self), move |piece| piece.children().find(holds))
    }

    /// Its children, in order.
    pub(crate) fn children(self) -> Children<'t> {
        let first = Piece { index: self.index + 1, ..self };
        Children { next: first, end: first.index + self.entry().size }
    }
}

/// The pieces that another one holds directly.
#[derive(Debug, Clone)]
pub(crate) struct Children<'t> {
    next: Piece<'t>,
    /// The index after the last of them.
    end: u32,
}

impl<'t> Iterator for Children<'t> {
    type Item = Piece<'t>;

    fn next(&mut self) -> Option<Piece<'t>> {
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
