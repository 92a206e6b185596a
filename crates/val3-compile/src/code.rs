//! Code under construction: operations, jumps to labels, tables.

use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_analysis::body::Stmt;
use val3_bytecode::{
    CallSite, CopySite, Counters, InstructionSite, LineMark, Op, Opcode, Register, SourceLine, SourceRange, TaskSite,
};
use val3_lang::values::Text;
use val3_lines::LineIndex;
use val3_syntax::TextRange;

use crate::counting::{BranchId, Counting};
use crate::error::{CompileLimit, Result};

/// Operations of a program and the tables to which they refer. Until [`finish`](Self::finish) jump targets are labels.
#[derive(Debug, Default)]
pub(crate) struct CodeBuilder {
    steps: Vec<Opcode>,
    /// Mark for the next operation.
    pending: LineMark,
    counting: Counting,
    labels: Vec<u32>,
    constants: FxHashMap<Text, Register>,
    /// Lines of the file.
    file_lines: LineIndex,
    pub(crate) lines: Vec<SourceLine>,
    pub(crate) closings: Vec<SourceLine>,
    pub(crate) texts: Vec<Text>,
    pub(crate) copies: Vec<CopySite>,
    pub(crate) instructions: Vec<InstructionSite>,
    pub(crate) calls: Vec<CallSite>,
    pub(crate) tasks: Vec<TaskSite>,
    pub(crate) counters: Counters,
}

/// A position at the end of the code.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CodePosition {
    steps: usize,
    pending: LineMark,
    copies: usize,
    instructions: usize,
}

/// Target of jumps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Label(pub(crate) u32);

impl CodeBuilder {
    /// Creates the code for a program in a file with this source.
    pub(crate) fn new(text: &str, counting: Counting) -> Self {
        Self { file_lines: LineIndex::new(text), counting, ..Self::default() }
    }

    /// Adds an operation.
    ///
    /// If a waiting task returns to the operation, a separate operation begins the line, so that the line counts once.
    pub(crate) fn emit(&mut self, op: Op) {
        if matches!(op, Op::Instruction { .. }) {
            self.begin();
        }
        let mark = std::mem::take(&mut self.pending);
        self.steps.push(Opcode { op, mark });
    }

    /// Begins the pending line or side, if any, with a separate operation.
    pub(crate) fn begin(&mut self) {
        if self.pending != LineMark::Within {
            self.steps.push(Opcode { op: Op::Line, mark: std::mem::take(&mut self.pending) });
        }
    }

    /// Returns the present end of the code.
    pub(crate) fn mark(&self) -> CodePosition {
        let (copies, instructions) = (self.copies.len(), self.instructions.len());
        CodePosition { steps: self.steps.len(), pending: self.pending, copies, instructions }
    }

    /// Removes the operations after `mark`, with their table entries. Program calls are never removed.
    pub(crate) fn take_back(&mut self, mark: CodePosition) {
        self.steps.truncate(mark.steps);
        self.pending = mark.pending;
        self.copies.truncate(mark.copies);
        self.instructions.truncate(mark.instructions);
    }

    /// Creates a label, which is placed later.
    pub(crate) fn label(&mut self) -> Label {
        self.labels.push(0);
        Label(count(&self.labels) - 1)
    }

    /// Places the label at the present end of the code.
    pub(crate) fn place(&mut self, label: Label) {
        self.begin();
        let here = count(&self.steps);
        if let Some(slot) = self.labels.get_mut(label.0 as usize) {
            *slot = here;
        }
    }

    /// Creates a label at the present end of the code.
    pub(crate) fn here(&mut self) -> Label {
        let label = self.label();
        self.place(label);
        label
    }

    /// Begins an instruction line.
    pub(crate) fn line(&mut self, range: TextRange) {
        let line = self.later_line(range);
        self.begin_line(line);
    }

    /// Declares a line here in source order, which [begins](Self::begin_line) later in the code. Returns the line's
    /// number.
    pub(crate) fn later_line(&mut self, range: TextRange) -> usize {
        self.lines.push(SourceLine { op: 0, range: source_range(range), row: self.row(range) });
        self.lines.len() - 1
    }

    /// Begins the line with this number. A branch side that begins with the line shares its counter.
    pub(crate) fn begin_line(&mut self, line: usize) {
        let range = self.lines.get(line).map(|line| line.range).unwrap_or_default();
        let mark = match (self.counting.counts(range.start), self.pending) {
            (true, LineMark::CountedSide(counter)) => LineMark::CountedLine(counter),
            (is_counted, _) => {
                self.begin();
                if is_counted { LineMark::CountedLine(self.counting.counter()) } else { LineMark::Line }
            }
        };
        let here = count(&self.steps);
        if let Some(line) = self.lines.get_mut(line) {
            line.op = here;
        }
        self.pending = mark;
    }

    /// Marks the next operation as the stop at a keyword that closes a block.
    pub(crate) fn closing(&mut self, range: TextRange) {
        self.begin();
        let place = SourceLine { op: count(&self.steps), range: source_range(range), row: self.row(range) };
        self.closings.push(place);
    }

    /// Declares a branch at the condition with this range. `None` if the branch is not counted.
    pub(crate) fn branch(&mut self, condition: TextRange) -> Option<BranchId> {
        let row = self.row(condition);
        self.counting.branch(condition, row)
    }

    /// Begins a branch side with the next operation, which must not be reachable in any other way. `block` contains the
    /// side's statements.
    pub(crate) fn side(&mut self, branch: Option<BranchId>, name: &str, block: &[Stmt]) {
        if let Some(branch) = branch
            && let Some(counter) = self.counting.side(branch, name, block)
        {
            self.begin();
            self.pending = LineMark::CountedSide(counter);
        }
    }

    /// Adds the operation for the next iteration of a `for`, which counts as a line.
    pub(crate) fn next_round(&mut self, op: Op) {
        self.begin();
        self.steps.push(Opcode { op, mark: LineMark::Line });
    }

    /// Returns the line of the file in which a range begins, from 1.
    pub(crate) fn row(&self, range: TextRange) -> u32 {
        u32::try_from(self.file_lines.line(range.start().into()) + 1).unwrap_or(u32::MAX)
    }

    /// Returns the number of a string in the table.
    pub(crate) fn text(&mut self, text: &SmolStr) -> Result<Register> {
        let text = Text::from(text.as_str());
        if let Some(known) = self.constants.get(&text) {
            return Ok(*known);
        }
        let number = Register::try_from(self.texts.len()).map_err(|_| CompileLimit::Items)?;
        self.texts.push(text);
        self.constants.insert(text, number);
        Ok(number)
    }

    /// Adds a copy or comparison to the table.
    pub(crate) fn copy_site(&mut self, site: CopySite) -> u32 {
        add(&mut self.copies, site)
    }

    /// Adds an instruction.
    pub(crate) fn instruction(&mut self, site: InstructionSite) {
        let site = add(&mut self.instructions, site);
        self.emit(Op::Instruction { site });
    }

    /// Adds a program call.
    pub(crate) fn call(&mut self, site: CallSite) {
        let site = add(&mut self.calls, site);
        self.emit(Op::Call { site });
    }

    /// Adds the creation of a task.
    pub(crate) fn task(&mut self, site: TaskSite) {
        let site = add(&mut self.tasks, site);
        self.emit(Op::CreateTask { site });
    }

    /// Returns the operations, with resolved jump targets.
    pub(crate) fn finish(&mut self) -> Result<Vec<Opcode>> {
        self.counters = std::mem::take(&mut self.counting).finish()?;
        u32::try_from(self.steps.len()).map_err(|_| CompileLimit::Operations)?;
        let mut steps = std::mem::take(&mut self.steps);
        for target in steps.iter_mut().filter_map(|step| step.op.target_mut()) {
            *target = self.labels.get(*target as usize).copied().ok_or(CompileLimit::Unclear)?;
        }
        Ok(steps)
    }
}

/// Converts a range.
pub(crate) fn source_range(range: TextRange) -> SourceRange {
    SourceRange { start: range.start().into(), end: range.end().into() }
}

fn count<T>(items: &[T]) -> u32 {
    u32::try_from(items.len()).unwrap_or(u32::MAX)
}

fn add<T>(table: &mut Vec<T>, item: T) -> u32 {
    table.push(item);
    count(table) - 1
}
