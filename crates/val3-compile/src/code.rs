//! The code that grows: operations, jumps to places that are not known yet, tables.

use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_bytecode::{CallSite, CopySite, InstructionSite, Line, Op, Register, SourceRange, TaskSite};
use val3_lang::values::Text;
use val3_syntax::TextRange;

use crate::error::{Limit, Result};

/// The operations of a program and what they refer to. Until [`finish`](Self::finish) the targets of jumps are labels.
#[derive(Debug, Default)]
pub(crate) struct Code {
    ops: Vec<Op>,
    labels: Vec<u32>,
    constants: FxHashMap<SmolStr, Register>,
    /// Where the lines of the file begin.
    rows: Vec<u32>,
    pub(crate) lines: Vec<Line>,
    pub(crate) texts: Vec<Text>,
    pub(crate) copies: Vec<CopySite>,
    pub(crate) instructions: Vec<InstructionSite>,
    pub(crate) calls: Vec<CallSite>,
    pub(crate) tasks: Vec<TaskSite>,
}

/// A place in the code that jumps lead to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Label(pub(crate) u32);

impl Code {
    /// Code of a program in a file with this text.
    pub(crate) fn new(text: &str) -> Self {
        let ends = (1u32..).zip(text.bytes()).filter(|(_, byte)| *byte == b'\n');
        Self { rows: std::iter::once(0).chain(ends.map(|(behind, _)| behind)).collect(), ..Self::default() }
    }

    /// Adds an operation.
    pub(crate) fn emit(&mut self, op: Op) {
        self.ops.push(op);
    }

    /// How many operations there are.
    pub(crate) fn mark(&self) -> u32 {
        count(&self.ops)
    }

    /// Takes back the operations since.
    pub(crate) fn take_back(&mut self, mark: u32) {
        self.ops.truncate(mark as usize);
    }

    /// A label that gets its place later.
    pub(crate) fn label(&mut self) -> Label {
        self.labels.push(0);
        Label(count(&self.labels) - 1)
    }

    /// The label stands here.
    pub(crate) fn place(&mut self, label: Label) {
        let here = count(&self.ops);
        if let Some(slot) = self.labels.get_mut(label.0 as usize) {
            *slot = here;
        }
    }

    /// A label that stands here.
    pub(crate) fn here(&mut self) -> Label {
        let label = self.label();
        self.place(label);
        label
    }

    /// An instruction line begins.
    pub(crate) fn line(&mut self, range: TextRange) {
        self.lines.push(Line { op: count(&self.ops), range: source_range(range), row: self.row(range) });
        self.emit(Op::Line);
    }

    /// The line of the file in which a range begins, from 1.
    pub(crate) fn row(&self, range: TextRange) -> u32 {
        let row = self.rows.partition_point(|start| *start <= u32::from(range.start()));
        u32::try_from(row).unwrap_or(u32::MAX)
    }

    /// The number of a text in the table.
    pub(crate) fn text(&mut self, text: &SmolStr) -> Result<Register> {
        if let Some(known) = self.constants.get(text) {
            return Ok(*known);
        }
        let number = Register::try_from(self.texts.len()).map_err(|_| Limit::Items)?;
        self.texts.push(Text::from(text.as_str()));
        self.constants.insert(text.clone(), number);
        Ok(number)
    }

    /// Adds a copy or comparison to the table.
    pub(crate) fn copy_site(&mut self, site: CopySite) -> u32 {
        add(&mut self.copies, site)
    }

    /// Calls an instruction.
    pub(crate) fn instruction(&mut self, site: InstructionSite) {
        let site = add(&mut self.instructions, site);
        self.emit(Op::Instruction { site });
    }

    /// Calls a program.
    pub(crate) fn call(&mut self, site: CallSite) {
        let site = add(&mut self.calls, site);
        self.emit(Op::Call { site });
    }

    /// Creates a task.
    pub(crate) fn task(&mut self, site: TaskSite) {
        let site = add(&mut self.tasks, site);
        self.emit(Op::CreateTask { site });
    }

    /// The operations, with the places of labels in their jumps.
    pub(crate) fn finish(&mut self) -> Result<Vec<Op>> {
        u32::try_from(self.ops.len()).map_err(|_| Limit::Operations)?;
        for target in self.ops.iter_mut().filter_map(Op::target_mut) {
            *target = self.labels.get(*target as usize).copied().ok_or(Limit::Unclear)?;
        }
        let mut ops = std::mem::take(&mut self.ops);
        join_lines(&mut ops);
        Ok(ops)
    }
}

/// Lets a jump to a line begin that line.
fn join_lines(ops: &mut [Op]) {
    for at in 0..ops.len() {
        if let Some(Op::Jump { to }) = ops.get(at).copied()
            && ops.get(to as usize) == Some(&Op::Line)
            && let Some(op) = ops.get_mut(at)
        {
            *op = Op::JumpToLine { to };
        }
    }
}

/// The bytes of a file.
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
