//! The labels of targets.

use std::collections::BTreeMap;

use crate::Picture;

/// Points nearer than this have one label, in pixels.
pub(super) const SAME: f64 = 3.0;

/// A line of a program.
pub(super) type Origin<'a> = (&'a str, u32);

/// A line with more targets than this is a loop.
const REPEATED: usize = 3;

/// Most lines in a label.
const MOST: usize = 4;

/// A target in a view, or targets at one place.
pub(super) struct Named<'a> {
    /// Pixels of the target.
    pub(super) point: [f64; 2],
    /// The moves to it.
    pub(super) origins: Vec<Origin<'a>>,
    /// The label; empty if another target has it.
    pub(super) text: String,
}

impl<'a> Named<'a> {
    /// The targets of a view. Moves to the same place share a label, and a line that moves to many places has its label at
    /// the first of them.
    pub(super) fn all(picture: &'a Picture, at: impl Fn(&[f64; 3]) -> [f64; 2]) -> Vec<Self> {
        let mut all: Vec<Self> = Vec::new();
        for mark in &picture.moves {
            let (point, origin) = (at(&mark.target), (mark.program.as_str(), mark.line));
            match all.iter_mut().find(|named| distance(named.point, point) < SAME) {
                Some(named) if named.origins.contains(&origin) => {}
                Some(named) => named.origins.push(origin),
                None => all.push(Self { point, origins: vec![origin], text: String::new() }),
            }
        }
        let mut loops = Loops::of(picture, &all);
        let program = picture.only_program();
        for named in &mut all {
            named.text = together(named.origins.iter().filter_map(|origin| loops.label(*origin)), program);
        }
        all
    }
}

fn distance([x, y]: [f64; 2], [other_x, other_y]: [f64; 2]) -> f64 {
    libm::hypot(other_x - x, other_y - y)
}

/// The lines that are at more than [`REPEATED`] targets, with their number of moves until the label was written.
struct Loops<'a>(BTreeMap<Origin<'a>, Option<usize>>);

impl<'a> Loops<'a> {
    fn of(picture: &Picture, all: &[Named<'a>]) -> Self {
        let mut targets: BTreeMap<Origin<'_>, usize> = BTreeMap::new();
        all.iter().flat_map(|named| &named.origins).for_each(|origin| *targets.entry(*origin).or_default() += 1);
        let moves = |(program, line): Origin<'_>| {
            picture.moves.iter().filter(|mark| mark.program == program && mark.line == line).count()
        };
        let loops = targets.into_iter().filter(|(_, count)| *count > REPEATED);
        Self(loops.map(|(origin, _)| (origin, Some(moves(origin)))).collect())
    }

    /// The label of a line with the number of its moves if it is a loop; `None` if the loop has its label.
    fn label(&mut self, origin: Origin<'a>) -> Option<(Origin<'a>, Option<usize>)> {
        match self.0.get_mut(&origin) {
            None => Some((origin, None)),
            Some(count) => count.take().map(|count| (origin, Some(count))),
        }
    }
}

/// Several lines as one label. A program is written before the first of its lines, unless it is the only one.
fn together<'a>(lines: impl Iterator<Item = (Origin<'a>, Option<usize>)>, only: Option<&'a str>) -> String {
    let mut text = String::new();
    let mut program = only;
    for (index, ((own, line), moves)) in lines.enumerate() {
        if index == MOST {
            return text + " …";
        }
        text += if text.is_empty() { "" } else { ", " };
        text += &if program == Some(own) { line.to_string() } else { format!("{own}:{line}") };
        text += &moves.map_or_else(String::new, |moves| format!(" ({moves} moves)"));
        program = Some(own);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::together;

    #[test]
    fn a_program_is_written_before_its_first_line() {
        let lines = [("start", 12), ("start", 18), ("pick", 7)];
        let text = |count: usize, only| together(lines.into_iter().cycle().take(count).map(|line| (line, None)), only);
        assert_eq!(text(3, None), "start:12, 18, pick:7");
        assert_eq!(text(2, Some("start")), "12, 18");
        assert_eq!(text(5, None), "start:12, 18, pick:7, start:12 …");
        assert_eq!(together([(("start", 13), Some(4))].into_iter(), Some("start")), "13 (4 moves)");
    }
}
