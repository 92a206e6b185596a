//! The lines of a block: what an edit of lines looks at, and what it puts in their place.

use std::ops::Range;
use std::slice;

use rowan::{TextRange, TextSize};

use crate::kind::SyntaxKind;
use crate::tree::{Entry, Piece, count};

/// A block of statements with the trivia around it.
pub(super) struct Run<'p, 't> {
    /// The nodes that hold both, innermost last.
    pub(super) around: &'p [Piece<'t>],
    /// Trivia, the statements of the block with trivia between them, and trivia.
    pub(super) pieces: Vec<Piece<'t>>,
    block: Piece<'t>,
    pub(super) start: TextSize,
    /// Nothing else follows in the innermost node.
    is_last: bool,
}

/// The runs that an edit may lie in, inner ones first; `path` leads from the root to the innermost node with the edit.
pub(super) fn runs_around<'p, 't>(path: &'p [Piece<'t>]) -> impl Iterator<Item = Run<'p, 't>> {
    let paths = (1..=path.len()).rev().filter_map(|len| path.get(..len));
    paths.flat_map(Run::all_in_last)
}

impl<'p, 't> Run<'p, 't> {
    /// The runs that stand in the last node of `path`.
    pub(super) fn all_in_last(path: &'p [Piece<'t>]) -> impl Iterator<Item = Self> {
        let parent = path.last().filter(|node| node.kind() != SyntaxKind::BLOCK);
        let siblings: Vec<Piece<'t>> = parent.into_iter().flat_map(|parent| parent.children()).collect();
        let is_block = |index: &usize| siblings.get(*index).is_some_and(|piece| piece.kind() == SyntaxKind::BLOCK);
        let blocks: Vec<usize> = (0..siblings.len()).filter(is_block).collect();
        blocks.into_iter().filter_map(move |block| Self::new(path, &siblings, block))
    }

    fn new(around: &'p [Piece<'t>], siblings: &[Piece<'t>], block: usize) -> Option<Self> {
        let (before, behind) = (siblings.get(..block)?, siblings.get(block + 1..)?);
        let first = block - before.iter().rev().take_while(|piece| piece.kind().is_trivia()).count();
        let last = block + 1 + behind.iter().take_while(|piece| piece.kind().is_trivia()).count();
        let (before, behind) = (siblings.get(first..block)?, siblings.get(block + 1..last)?);
        let block = *siblings.get(block)?;
        let pieces: Vec<Piece<'t>> =
            before.iter().copied().chain(block.children()).chain(behind.iter().copied()).collect();
        let start = before.first().unwrap_or(&block).range().start();
        Some(Self { around, pieces, block, start, is_last: last == siblings.len() })
    }

    pub(super) fn len(&self) -> TextSize {
        self.pieces.iter().map(|piece| piece.range().len()).sum()
    }

    /// Where its entries stand in the list of the tree.
    pub(super) fn indexes(&self) -> Range<usize> {
        let start = self.pieces.first().map_or(self.block.index(), |piece| piece.index().min(self.block.index()));
        let end = self.pieces.last().map_or(0, |piece| piece.indexes().end);
        start..end.max(self.block.indexes().end)
    }

    /// The pieces from the line end before an edit to the one behind it, or in which it ends.
    pub(super) fn lines_around(&self, edit: TextRange) -> Option<Range<usize>> {
        let mut first = None;
        for (index, piece) in self.pieces.iter().enumerate().filter(|(_, piece)| is_line_end(**piece)) {
            match first {
                Some(first) if piece.range().end() >= edit.end() => return Some(first..index + 1),
                _ if piece.range().start() < edit.start() => first = Some(index),
                _ => {}
            }
        }
        None
    }

    pub(super) fn range_of(&self, pieces: &Range<usize>) -> TextRange {
        let pieces = self.pieces.get(pieces.clone()).unwrap_or(&[]);
        let range = |piece: Option<&Piece<'_>>| piece.map_or(TextRange::empty(self.start), |piece| piece.range());
        range(pieces.first()).cover(range(pieces.last()))
    }

    /// The run with other pieces in the place of some.
    pub(super) fn with<'n>(&self, replaced: Range<usize>, pieces: &[Piece<'n>]) -> Option<NewRun<'n>>
    where
        't: 'n,
    {
        let (before, behind) = (self.pieces.get(..replaced.start)?, self.pieces.get(replaced.end..)?);
        let pieces: Vec<Piece<'n>> = [before, pieces, behind].concat();
        let is_solid = |piece: &Piece<'_>| !piece.kind().is_trivia();
        let first = pieces.iter().position(is_solid).unwrap_or(pieces.len());
        let last = pieces.iter().rposition(is_solid).map_or(first, |last| last + 1);
        // Trivia at the end of a node belongs to the node around it.
        if last < pieces.len() && self.is_last {
            return None;
        }
        let (before, pieces) = pieces.split_at_checked(first)?;
        let (inside, behind) = pieces.split_at_checked(last - first)?;
        let len = inside.iter().map(|piece| piece.range().len()).sum::<TextSize>().into();
        let size = inside.iter().map(|piece| piece.indexes().len()).sum();
        let block = Entry { kind: SyntaxKind::BLOCK, len, size: count(size) };
        let [before, inside, behind] = [before, inside, behind].map(stretches);
        Some(NewRun { before, block, inside, behind })
    }
}

/// The entries of a run after an edit.
pub(super) struct NewRun<'t> {
    before: Vec<&'t [Entry]>,
    block: Entry,
    inside: Vec<&'t [Entry]>,
    behind: Vec<&'t [Entry]>,
}

impl NewRun<'_> {
    /// All entries in order.
    pub(super) fn entries(&self) -> Vec<&[Entry]> {
        [&*self.before, &[slice::from_ref(&self.block)], &*self.inside, &*self.behind].concat()
    }
}

/// The entries of the pieces, those in one that stand one behind the other.
fn stretches<'t>(pieces: &[Piece<'t>]) -> Vec<&'t [Entry]> {
    let stretches = pieces.chunk_by(|piece, next| piece.is_followed_by(*next));
    stretches.filter_map(|stretch| Some(stretch.first()?.entries_to(*stretch.last()?))).collect()
}

pub(super) fn is_line_end(piece: Piece<'_>) -> bool {
    !piece.kind().is_node() && piece.text().starts_with(['\n', '\r'])
}
