//! Compiled programs.

use std::sync::Arc;

use val3_lang::memory::{Lanes, PartInit, ValueType};
use val3_lang::types::Container;
use val3_lang::values::Text;

use crate::{CallSite, CopySite, Counters, InstructionSite, Op, Opcode, TaskSite};

/// A compiled program.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Program {
    /// Name.
    pub name: String,
    /// Whether other applications may call it.
    pub public: bool,
    /// Number of the source file in [`Image::files`](crate::Image::files).
    pub file: u32,
    /// Parameters.
    pub params: Vec<ProgramParam>,
    /// Names and locations of parameters and locals, for debuggers.
    pub variables: Vec<FrameVariable>,
    /// Number of lanes in a stack frame.
    pub frame: FrameSize,
    /// Size of a call on the stack that the project declares (2.1.4.2), in bytes: return address, parameters and
    /// locals.
    pub stack_bytes: u32,
    /// Numbers of a new frame: defaults of locals, constants, and 0 for all others.
    pub nums: Vec<f64>,
    /// Containers of a new frame: local arrays, and values of user types.
    pub parts: Vec<PartInit>,
    /// Operations.
    pub code: Vec<Opcode>,
    /// Instruction lines in source order.
    pub lines: Vec<SourceLine>,
    /// Keywords that close a block, with the operation that executes them: `endWhile`, `endFor`, `break`, `end`. They
    /// are no instruction lines, but tasks can stop before them.
    pub closings: Vec<SourceLine>,
    /// String constants.
    pub texts: Vec<Text>,
    /// Copies and comparisons.
    pub copies: Vec<CopySite>,
    /// Instructions and operators.
    pub instructions: Vec<InstructionSite>,
    /// Calls.
    pub calls: Vec<CallSite>,
    /// Creations of tasks.
    pub tasks: Vec<TaskSite>,
    /// Counters of executed lines and branch sides, if the program was compiled with counters.
    pub counters: Counters,
}

/// Number of lanes in a stack frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct FrameSize {
    /// Numbers, texts, links and containers.
    pub lanes: Lanes,
    /// Places.
    pub places: u32,
    /// Views.
    pub views: u32,
}

/// A parameter or local.
#[derive(Debug, Clone, PartialEq)]
pub struct FrameVariable {
    /// Name.
    pub name: String,
    /// Type.
    pub kind: Arc<ValueType>,
    /// Element, array or collection.
    pub container: Container,
    /// Location in the frame.
    pub storage: Storage,
}

/// Location of a parameter or local in the frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Storage {
    /// One value of a built-in type, which begins at these lanes.
    Value(Lanes),
    /// The container with this number.
    Part(u16),
    /// A reference to a value: the place with this number.
    Place(u16),
    /// A reference to a container: the view with this number.
    View(u16),
}

/// A parameter.
#[derive(Debug, Clone, PartialEq)]
pub struct ProgramParam {
    /// Name.
    pub name: String,
    /// Type.
    pub kind: Arc<ValueType>,
    /// Element, array or collection.
    pub container: Container,
    /// Location in the frame.
    pub storage: Storage,
}

/// Byte range in a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct SourceRange {
    /// First byte.
    pub start: u32,
    /// Byte after the last one.
    pub end: u32,
}

/// An instruction line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SourceLine {
    /// First operation.
    pub op: u32,
    /// Range in the file.
    pub range: SourceRange,
    /// Line of the file, from 1.
    pub row: u32,
}

impl Program {
    /// Whether the frame contains neither links nor containers, so that nothing has to be removed when the program
    /// ends.
    #[must_use]
    pub fn is_plain(&self) -> bool {
        let Lanes { link, part, .. } = self.frame.lanes;
        [link, part] == [0; 2]
    }

    /// Returns the first line at or after a row of the file, as an index into [`lines`](Self::lines).
    #[must_use]
    pub fn line_from(&self, row: u32) -> Option<usize> {
        let lines = self.lines.iter().enumerate().filter(|(_, line)| line.row >= row);
        lines.min_by_key(|(_, line)| (line.row, line.op)).map(|(number, _)| number)
    }

    /// Returns the first operation of the lines at a row of the file.
    #[must_use]
    pub fn first_op_at(&self, row: u32) -> Option<u32> {
        self.lines.iter().filter(|line| line.row == row).map(|line| line.op).min()
    }

    /// Returns the first line or closing keyword at or after a row of the file, before which tasks can stop.
    #[must_use]
    pub fn halt_from(&self, row: u32) -> Option<SourceLine> {
        let halts = self.lines.iter().chain(&self.closings).filter(|line| line.row >= row);
        halts.min_by_key(|line| (line.row, line.op)).copied()
    }

    /// Returns the closing keyword that an operation executes, otherwise the line of the operation.
    #[must_use]
    pub fn halt_at(&self, op: u32) -> Option<SourceLine> {
        let closing = self.closings.iter().find(|closing| closing.op == op);
        closing.or_else(|| self.lines.get(self.line_of(op)?)).copied()
    }

    /// Returns the operation that begins the first executed line. If the program begins with a loop, this may be a
    /// jump's target.
    #[must_use]
    pub fn entry(&self) -> Option<u32> {
        self.lines.first().map(|line| line.op)
    }

    /// Returns the line of an operation, as an index into [`lines`](Self::lines).
    ///
    /// The next iteration of a `for` belongs to the line of the `for`. An operation before all lines belongs to the
    /// first line.
    #[must_use]
    pub fn line_of(&self, op: u32) -> Option<usize> {
        let op = match self.code.get(op as usize).map(|step| &step.op) {
            Some(Op::ForNext { body, .. } | Op::ForNextUp { body, .. }) => body.saturating_sub(1),
            _ => op,
        };
        let before = |(_, line): &(usize, &SourceLine)| line.op <= op;
        let last = self.lines.iter().enumerate().filter(before).max_by_key(|(_, line)| line.op);
        last.map(|(number, _)| number).or((!self.lines.is_empty()).then_some(0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Image, assemble};

    fn program(text: &str) -> Program {
        let Image { mut programs, .. } = assemble(&format!("program p\n{text}\nend")).unwrap();
        programs.remove(0)
    }

    #[test]
    fn a_frame_without_links_and_containers_is_plain() {
        assert!(program("frame n1/t1/p1/v1 Return").is_plain());
        assert!(!program("frame l1 Return").is_plain());
        assert!(!program("container num[1] Return").is_plain());
    }

    #[test]
    fn a_row_without_code_leads_to_the_next_line() {
        let program = program("line 5 Line line 8 Line line 8 Line line 6 Return");
        let found = |row| program.line_from(row).map(|line| program.lines[line].op);
        assert_eq!([1, 5, 6, 7, 9].map(found), [Some(0), Some(0), Some(3), Some(1), None]);
    }

    #[test]
    fn a_row_begins_with_the_first_operation_of_its_lines() {
        let program = program("line 5 Line line 8 Line line 8 Line line 6 Return");
        assert_eq!([5, 6, 7, 8].map(|row| program.first_op_at(row)), [Some(0), Some(3), None, Some(1)]);
    }

    #[test]
    fn the_entry_is_the_first_line_of_the_file() {
        assert_eq!(program("line 7 at 50 60 Jump on on: line 6 at 40 49 Return").entry(), Some(1));
        assert_eq!(program("Return").entry(), None);
    }

    #[test]
    fn operations_belong_to_the_line_before_them() {
        let program = program("Line line 5 Line Line line 6 Line Return");
        assert_eq!([0, 1, 2, 3, 4].map(|op| program.line_of(op)), [Some(0), Some(0), Some(0), Some(1), Some(1)]);
        assert_eq!(Program::default().line_of(0), None);
    }

    #[test]
    fn the_next_iteration_belongs_to_the_line_of_the_loop() {
        for next in ["ForNext", "ForNextUp"] {
            let text = format!("frame n3 line 5 ForTest n0 n1 out body: line 6 Line {next} n0 n1 body out: Return");
            let program = program(&text);
            assert_eq!([0, 1, 2].map(|op| program.line_of(op)), [Some(0), Some(1), Some(0)], "{next}");
        }
    }
}
