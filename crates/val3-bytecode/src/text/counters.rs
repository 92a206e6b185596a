//! Counters of lines and branch sides.

use super::error::Result;
use super::reader::ListingReader;
use super::writer::Writer;
use crate::{BranchSide, LineMark, Program};

impl Writer<'_> {
    /// Writes the branches of a program.
    pub(super) fn branches(&mut self, program: &Program) {
        for branch in &program.counters.branches {
            self.put(&format!("    branch {}", branch.row));
            for side in &branch.sides {
                self.put(" ");
                self.quoted(&side.name);
                self.put(&format!(" {}", side.counter));
            }
            self.put("\n");
        }
    }

    /// Writes the counter of a line, after the line's location.
    pub(super) fn line_counter(&mut self, mark: LineMark) {
        if let LineMark::CountedLine(counter) = mark {
            self.put(&format!(" counter {counter}"));
        }
    }

    /// Writes the counter of a branch side that has no counted line.
    pub(super) fn side_counter(&mut self, mark: LineMark) {
        if let LineMark::CountedSide(counter) = mark {
            self.put(&format!("    side {counter}\n"));
        }
    }
}

impl ListingReader<'_> {
    /// Reads the mark of the operation after `line`.
    pub(super) fn line_mark(&mut self) -> Result<LineMark> {
        if self.is_label() || !self.accept("counter") {
            return Ok(LineMark::Line);
        }
        Ok(LineMark::CountedLine(self.number()?))
    }

    /// Reads `side 3`.
    pub(super) fn side_mark(&mut self) -> Result<LineMark> {
        self.take();
        Ok(LineMark::CountedSide(self.number()?))
    }

    /// Reads `branch 12 "true" 3 "false" 4`.
    pub(super) fn branch(&mut self) -> Result<()> {
        let row = self.after_word()?;
        let mut sides = Vec::new();
        while self.peek().starts_with('"') {
            sides.push(BranchSide { name: self.quoted()?, counter: self.number()? });
        }
        self.code.counters.branches.push(crate::Branch { row, sides });
        Ok(())
    }
}

/// Returns the number of counters that the program's code contains.
pub(super) fn counted(program: &Program) -> u32 {
    program.code.iter().filter_map(|step| step.mark.counter()).map(|counter| u32::from(counter) + 1).max().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use crate::{LineMark, assemble, disassemble};

    #[test]
    fn counters_of_lines_and_branches_are_kept() {
        let text = "image \"\" \"\"\nversion s7.11\nstack 5000

program start
    file 0 stack 0
    branch 4 \"true\" 1 \"case \\\"a\\\"\" 2
line 4 at 3 9 counter 0
    Line
    side 1
    Line
line 5 at 10 12 counter 2
    Return
end

program stop
    file 0 stack 0
line 1 at 0 0 counter 0
    Return
end
";
        let image = assemble(text).unwrap();
        assert_eq!(disassemble(&image), text);
        assert_eq!(image.counters(), 4);
        let marks: Vec<LineMark> = image.programs[0].code.iter().map(|step| step.mark).collect();
        assert_eq!(marks, [LineMark::CountedLine(0), LineMark::CountedSide(1), LineMark::CountedLine(2)]);
        assert_eq!(image.programs[0].counted_lines().collect::<Vec<_>>(), [(4, 0), (5, 2)]);
        assert_eq!(image.programs[1].counters.first, 3);
        assert_eq!(image.programs[0].counters.branches[0].sides[1].name, "case \"a\"");
    }
}
