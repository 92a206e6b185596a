//! Labels of targets.

use std::collections::BTreeMap;

use crate::Picture;

/// Distance in pixels below which points share a label.
pub(super) const SAME: f64 = 3.0;

/// Program name and line number.
pub(super) type ProgramLine<'a> = (&'a str, u32);

/// Number of targets above which a line is a loop.
const REPEATED: usize = 3;

/// Maximum number of lines in a label.
const MOST: usize = 4;

/// A target in a view, or several targets at the same place.
pub(super) struct Named<'a> {
    /// Pixel coordinates of the target.
    pub(super) point: [f64; 2],
    /// Moves to the target.
    pub(super) origins: Vec<ProgramLine<'a>>,
    /// Label; empty if another target has it.
    pub(super) text: String,
}

impl<'a> Named<'a> {
    /// Returns the targets of a view. Moves to the same place share a label, and a line with many targets is labelled
    /// at the first target.
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

/// Lines with more than [`REPEATED`] targets, with their number of moves until the label is written.
struct Loops<'a>(BTreeMap<ProgramLine<'a>, Option<usize>>);

impl<'a> Loops<'a> {
    fn of(picture: &Picture, all: &[Named<'a>]) -> Self {
        let mut targets: BTreeMap<ProgramLine<'_>, usize> = BTreeMap::new();
        all.iter().flat_map(|named| &named.origins).for_each(|origin| *targets.entry(*origin).or_default() += 1);
        let loops = targets.into_iter().filter(|(_, count)| *count > REPEATED);
        Self(loops.map(|(origin, _)| (origin, Some(move_count(picture, origin)))).collect())
    }

    /// Returns the label of a line, with the number of moves if it is a loop; `None` if the loop was already labelled.
    fn label(&mut self, origin: ProgramLine<'a>) -> Option<(ProgramLine<'a>, Option<usize>)> {
        match self.0.get_mut(&origin) {
            None => Some((origin, None)),
            Some(count) => count.take().map(|count| (origin, Some(count))),
        }
    }
}

/// Returns the number of moves that the line has recorded.
fn move_count(picture: &Picture, (program, line): ProgramLine<'_>) -> usize {
    picture.moves.iter().filter(|mark| mark.program == program && mark.line == line).count()
}

/// Joins several lines to a label. The program is written before its first line, unless it is the only program.
fn together<'a>(lines: impl Iterator<Item = (ProgramLine<'a>, Option<usize>)>, only: Option<&'a str>) -> String {
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
