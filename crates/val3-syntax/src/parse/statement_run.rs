//! Lines of a block, for edits of lines: the examined lines and their replacement.
//!
//! A program may be one long block, so nothing here reads the text after an edit.

use std::ops::Range;
use std::slice;

use rowan::{TextRange, TextSize};

use crate::kind::SyntaxKind;
use crate::tree::{NodeRef, TreeEntry, count};

/// A block of statements with its surrounding trivia.
pub(super) struct StatementRun<'p, 't> {
    /// Nodes that contain the block and its trivia, innermost last.
    pub(super) around: &'p [NodeRef<'t>],
    /// Trivia before the block.
    before: Vec<NodeRef<'t>>,
    block: NodeRef<'t>,
    /// Trivia after the block.
    after: Vec<NodeRef<'t>>,
    /// Whether nothing else follows in the innermost node.
    is_last: bool,
}

/// A range of pieces in a run, given by the first and the last piece.
#[derive(Debug, Clone, Copy)]
pub(super) struct LineRun<'t> {
    first: NodeRef<'t>,
    last: NodeRef<'t>,
}

/// Returns the runs that may contain an edit, inner ones first. `path` goes from the root to the innermost node with
/// the edit.
pub(super) fn runs_around<'p, 't>(path: &'p [NodeRef<'t>]) -> impl Iterator<Item = StatementRun<'p, 't>> {
    let paths = (1..=path.len()).rev().filter_map(|len| path.get(..len));
    paths.flat_map(StatementRun::all_in_last)
}

impl<'p, 't> StatementRun<'p, 't> {
    /// Returns the runs in the last node of `path`.
    pub(super) fn all_in_last(path: &'p [NodeRef<'t>]) -> impl Iterator<Item = Self> {
        let parent = path.last().filter(|node| node.kind() != SyntaxKind::BLOCK);
        let siblings: Vec<NodeRef<'t>> = parent.into_iter().flat_map(|parent| parent.children()).collect();
        let blocks = (0..).zip(&siblings).filter(|(_, piece)| piece.kind() == SyntaxKind::BLOCK);
        let blocks: Vec<usize> = blocks.map(|(index, _)| index).collect();
        blocks.into_iter().filter_map(move |block| Self::new(path, &siblings, block))
    }

    fn new(around: &'p [NodeRef<'t>], siblings: &[NodeRef<'t>], block: usize) -> Option<Self> {
        let (before, after) = (siblings.get(..block)?, siblings.get(block + 1..)?);
        let first = block - before.iter().rev().take_while(|piece| piece.kind().is_trivia()).count();
        let last = block + 1 + after.iter().take_while(|piece| piece.kind().is_trivia()).count();
        let (before, after) = (siblings.get(first..block)?, siblings.get(block + 1..last)?);
        let block = *siblings.get(block)?;
        let is_last = last == siblings.len();
        Some(Self { around, before: before.to_vec(), block, after: after.to_vec(), is_last })
    }

    /// Returns the pieces: trivia, the statements of the block with trivia between them, and trivia.
    pub(super) fn pieces(&self) -> impl Iterator<Item = NodeRef<'t>> {
        self.before.iter().copied().chain(self.block.children()).chain(self.after.iter().copied())
    }

    /// Returns the range in the text.
    pub(super) fn range(&self) -> TextRange {
        self.lines().range()
    }

    /// Returns the index range in the tree's list of entries.
    pub(super) fn indexes(&self) -> Range<usize> {
        self.lines().indexes()
    }

    /// Returns the run as lines.
    fn lines(&self) -> LineRun<'t> {
        let first = self.before.first().unwrap_or(&self.block);
        let last = self.after.last().unwrap_or(&self.block);
        LineRun { first: *first, last: *last }
    }

    /// Returns the entries of the run within an index range, in three slices, without the entry of the block itself.
    fn entries(&self, range: &Range<usize>) -> [&'t [TreeEntry]; 3] {
        let (run, block) = (self.indexes(), self.block.indexes());
        [run.start..block.start, block.start + 1..block.end, block.end..run.end].map(|part| {
            let start = part.start.max(range.start);
            // Empty if the part is outside of the range.
            self.block.entries_of_tree(start..part.end.min(range.end).max(start))
        })
    }

    /// Returns the pieces from the line end before an edit to the line end that is after the edit or contains its end.
    pub(super) fn lines_around(&self, edit: TextRange) -> Option<LineRun<'t>> {
        let mut first = None;
        for piece in self.pieces().filter(|piece| is_line_end(*piece)) {
            match first {
                Some(first) if piece.range().end() >= edit.end() => return Some(LineRun { first, last: piece }),
                _ if piece.range().start() < edit.start() => first = Some(piece),
                _ => {}
            }
        }
        None
    }

    /// Replaces some lines by a run from a different tree.
    pub(super) fn with<'n>(&self, lines: LineRun<'t>, new: &StatementRun<'_, 'n>) -> Option<EditedRun<'n>>
    where
        't: 'n,
    {
        let (run, replaced) = (self.indexes(), lines.indexes());
        let before = self.entries(&(run.start..replaced.start));
        let after = self.entries(&(replaced.end..run.end));
        let entries: Vec<&[TreeEntry]> = [before, new.entries(&new.indexes()), after].concat();
        // A trivia token has one entry, and no node ends with trivia.
        let size: usize = entries.iter().map(|stretch| stretch.len()).sum();
        let leading = entries.iter().copied().flatten().take_while(|entry| entry.kind.is_trivia()).count();
        let backwards = entries.iter().copied().rev().flat_map(|stretch| stretch.iter().rev());
        let trailing = backwards.take_while(|entry| entry.kind.is_trivia());
        let trailing = if leading == size { 0 } else { trailing.count() };
        // Trivia at the end of a node belongs to the parent node.
        if trailing > 0 && self.is_last {
            return None;
        }
        let (before, rest) = split(&entries, leading);
        let (inside, after) = split(&rest, size - leading - trailing);
        let len = self.range().len() - lines.range().len() + new.range().len() - len(&before) - len(&after);
        let block = TreeEntry { kind: SyntaxKind::BLOCK, len: len.into(), size: count(size - leading - trailing) };
        Some(EditedRun { before, block, inside, after })
    }
}

impl<'t> LineRun<'t> {
    /// Returns the range in the text.
    pub(super) fn range(self) -> TextRange {
        self.first.range().cover(self.last.range())
    }

    /// Returns the index range in the tree's list of entries.
    fn indexes(self) -> Range<usize> {
        self.first.index()..self.last.indexes().end
    }

    /// Returns the entries, including the block's own entry if the block begins or ends in the lines.
    pub(super) fn entries(self) -> &'t [TreeEntry] {
        self.first.entries_of_tree(self.indexes())
    }
}

/// Entries of a run after an edit.
pub(super) struct EditedRun<'t> {
    before: Vec<&'t [TreeEntry]>,
    block: TreeEntry,
    inside: Vec<&'t [TreeEntry]>,
    after: Vec<&'t [TreeEntry]>,
}

impl EditedRun<'_> {
    /// Returns all entries in order.
    pub(super) fn entries(&self) -> Vec<&[TreeEntry]> {
        [&*self.before, &[slice::from_ref(&self.block)], &*self.inside, &*self.after].concat()
    }
}

/// Splits the entries after the first `at` entries.
fn split<'t>(stretches: &[&'t [TreeEntry]], mut at: usize) -> (Vec<&'t [TreeEntry]>, Vec<&'t [TreeEntry]>) {
    let cut = stretches.iter().map(|stretch| {
        let (left, right) = stretch.split_at(at.min(stretch.len()));
        at -= left.len();
        (left, right)
    });
    cut.unzip()
}

/// Returns the text length of trivia.
fn len(trivia: &[&[TreeEntry]]) -> TextSize {
    trivia.iter().copied().flatten().map(|entry| TextSize::new(entry.len)).sum()
}

pub(super) fn is_line_end(piece: NodeRef<'_>) -> bool {
    !piece.kind().is_node() && piece.text().starts_with(['\n', '\r'])
}
