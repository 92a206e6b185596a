//! Programs: the head, then operations with labels and source lines.

use std::collections::BTreeSet;
use std::sync::Arc;

use val3_lang::memory::{Lanes, PartInit, ValueType};
use val3_lang::types::Container;

use super::ListingForm;
use super::counters::counted;
use super::error::Result;
use super::forms::{Flag, Name, Public};
use super::operands::{self, Num, Part, Place, View, read_lanes, write_operand};
use super::reader::ListingReader;
use super::values::{Brackets, ListedType};
use super::writer::Writer;
use crate::{
    FrameSize, FrameVariable, LineMark, Op, Opcode, Operand, Program, ProgramParam, SourceLine, SourceRange, Storage,
};

impl<'i> Writer<'i> {
    pub(super) fn program(&mut self, program: &'i Program) {
        self.code = Some(program);
        self.constants.clear();
        let code = self.aside(|to| to.code(program));
        self.put("\n");
        self.each::<(Flag<Public>, Name)>("program", &[(program.public, program.name.clone())]);
        self.head(program);
        // Constants are numbered in the order of first use. A list is needed only if the compiler used another order.
        if !self.constants.iter().copied().map(usize::from).eq(0..program.texts.len()) {
            self.put("    texts ");
            self.list(&program.texts, ", ", |text, to| to.quoted(text));
            self.put("\n");
        }
        self.put(&code);
        self.put("end\n");
    }

    fn head(&mut self, program: &Program) {
        self.put(&format!("    file {} stack {}\n", program.file, program.stack_bytes));
        for (at, variable) in program.variables.iter().enumerate() {
            self.put(if at < program.params.len() { "    param " } else { "    local " });
            <(Name, ListedType, Brackets)>::write(&declared(variable), self);
            self.put(" ");
            match variable.storage {
                Storage::Value(lanes) => write_operand(Operand::Frame(lanes), variable.kind.size, self),
                Storage::Part(number) => Part::write(&number, self),
                Storage::Place(number) => Place::write(&number, self),
                Storage::View(number) => View::write(&number, self),
            }
            self.put("\n");
        }
        let FrameSize { lanes, places, views } = program.frame;
        let sorts = [('n', lanes.num), ('t', lanes.text), ('l', lanes.link), ('p', places), ('v', views)];
        let sizes: Vec<_> = sorts.into_iter().filter(|(_, size)| *size > 0).collect();
        if !sizes.is_empty() {
            self.put("    frame ");
            operands::write_numbers(&sizes, self);
            self.put("\n");
        }
        let presets: Vec<_> = (0..).zip(&program.nums).filter(|(_, value)| value.to_bits() != 0).collect();
        if !presets.is_empty() {
            self.put("    nums ");
            self.list(presets, ", ", |(at, value): (u32, &f64), to| to.put(&format!("n{at}={value}")));
            self.put("\n");
        }
        self.each::<PartInit>("    container", &program.parts);
        self.branches(program);
    }

    fn code(&mut self, program: &Program) {
        let targets = program.code.iter().filter_map(|operation| ({ operation.op }).target_mut().copied());
        let targets: BTreeSet<u32> = targets.collect();
        for (at, operation) in (0u32..).zip(&program.code) {
            if targets.contains(&at) {
                self.put(&format!("L{at}:\n"));
            }
            for line in program.lines.iter().filter(|line| line.op == at) {
                let SourceRange { start, end } = line.range;
                self.put(&format!("line {} at {start} {end}", line.row));
                self.line_counter(operation.mark);
                self.put("\n");
            }
            self.side_counter(operation.mark);
            for closing in program.closings.iter().filter(|closing| closing.op == at) {
                let SourceRange { start, end } = closing.range;
                self.put(&format!("closing {} at {start} {end}\n", closing.row));
            }
            self.put("    ");
            Op::write(&operation.op, self);
            self.put("\n");
        }
    }
}

/// Returns a variable without its location.
fn declared(variable: &FrameVariable) -> (String, Arc<ValueType>, Container) {
    (variable.name.clone(), variable.kind.clone(), variable.container)
}

impl ListingReader<'_> {
    /// Reads a program after its first word.
    pub(super) fn program(&mut self) -> Result<()> {
        let (public, name) = <(Flag<Public>, Name)>::read(self)?;
        self.code = Program { public, name, ..Program::default() };
        self.labels.clear();
        let mut mark = LineMark::Within;
        while self.is_label() || !self.accept("end") {
            match self.peek() {
                _ if self.is_label() => self.label()?,
                "line" => {
                    self.line()?;
                    mark = self.line_mark()?;
                }
                "closing" => {
                    let closing = self.source_line()?;
                    self.code.closings.push(closing);
                }
                "side" => mark = self.side_mark()?,
                "branch" => self.branch()?,
                "file" => self.code.file = self.after_word()?,
                "stack" => self.code.stack_bytes = self.after_word()?,
                "param" => self.variable(true)?,
                "local" => self.variable(false)?,
                "frame" => self.frame()?,
                "nums" => self.nums()?,
                "texts" => self.texts()?,
                "container" => self.container()?,
                _ => {
                    let op = Op::read(self)?;
                    if matches!(op, Op::ForNext { .. } | Op::ForNextUp { .. }) {
                        mark = LineMark::Line;
                    }
                    self.code.code.push(Opcode { op, mark: std::mem::replace(&mut mark, LineMark::Within) });
                }
            }
        }
        if mark != LineMark::Within {
            return self.fail("an operation is missing after the last `line` or `side`");
        }
        self.end_program()
    }

    pub(super) fn after_word(&mut self) -> Result<u32> {
        self.take();
        self.number()
    }

    /// Reads `line 5 at 120 131`: the row, and the byte range in the file.
    fn line(&mut self) -> Result<()> {
        let line = self.source_line()?;
        self.code.lines.push(line);
        Ok(())
    }

    fn source_line(&mut self) -> Result<SourceLine> {
        let row = self.after_word()?;
        let range = if self.accept("at") {
            SourceRange { start: self.number()?, end: self.number()? }
        } else {
            SourceRange::default()
        };
        Ok(SourceLine { op: self.here(), range, row })
    }

    /// Returns the number of the next operation.
    fn here(&self) -> u32 {
        u32::try_from(self.code.code.len()).unwrap_or(u32::MAX)
    }

    fn variable(&mut self, is_param: bool) -> Result<()> {
        self.take();
        let (name, kind, container) = <(Name, ListedType, Brackets)>::read(self)?;
        let storage = match self.peek().chars().next() {
            Some('c') => Storage::Part(Part::read(self)?),
            Some('p') => Storage::Place(Place::read(self)?),
            Some('v') => Storage::View(View::read(self)?),
            _ => Storage::Value(read_lanes(self)?),
        };
        if is_param {
            self.code.params.push(ProgramParam { name: name.clone(), kind: kind.clone(), container, storage });
        }
        self.code.variables.push(FrameVariable { name, kind, container, storage });
        Ok(())
    }

    /// Reads `frame n2/t1`: the numbers, texts, links, places and views of a frame.
    fn frame(&mut self) -> Result<()> {
        self.take();
        let [num, text, link, places, views] = operands::read_numbers(['n', 't', 'l', 'p', 'v'], self)?;
        self.code.frame = FrameSize { lanes: Lanes { num, text, link, part: 0 }, places, views };
        self.code.nums = vec![0.0; num as usize];
        Ok(())
    }

    /// Reads `nums n0=2.5, n3=1`: numbers of a new frame.
    fn nums(&mut self) -> Result<()> {
        self.after_each_comma(|from| {
            let register = Num::read(from)?;
            let known = from.code.nums.len();
            from.expect("=")?;
            let value = from.number()?;
            match from.code.nums.get_mut(usize::from(register)) {
                Some(num) => *num = value,
                None => return from.fail(&format!("the frame has {known} numbers")),
            }
            Ok(())
        })
    }

    fn texts(&mut self) -> Result<()> {
        self.after_each_comma(|from| {
            let text = operands::text(from)?;
            from.code.texts.push(text);
            Ok(())
        })
    }

    /// Reads items after a word and after each following comma.
    fn after_each_comma(&mut self, read: impl Fn(&mut Self) -> Result<()>) -> Result<()> {
        loop {
            self.take();
            read(self)?;
            if self.peek() != "," {
                return Ok(());
            }
        }
    }

    fn container(&mut self) -> Result<()> {
        self.take();
        let part = PartInit::read(self)?;
        self.code.parts.push(part);
        Ok(())
    }

    fn label(&mut self) -> Result<()> {
        let (name, here, used) = (self.name()?, self.here(), self.last());
        self.expect(":")?;
        let number = operands::number(&mut self.labels, super::reader::Label { name, used, target: None });
        let label = self.labels.get_mut(number as usize);
        match label.map(|label| label.target.replace(here)) {
            Some(Some(_)) => self.fail_at(used, "this label is set twice"),
            _ => Ok(()),
        }
    }

    /// Completes the frame, the lines and the jumps at the end of the program.
    fn end_program(&mut self) -> Result<()> {
        if let Some(label) = self.labels.iter().find(|label| label.target.is_none()) {
            return self.fail_at(label.used, &format!("the label `{}` is missing", label.name));
        }
        let mut program = std::mem::take(&mut self.code);
        for target in program.code.iter_mut().filter_map(|operation| operation.op.target_mut()) {
            *target = self.labels.get(*target as usize).and_then(|label| label.target).unwrap_or(u32::MAX);
        }
        // Lines are in source order, in which the head of a `while` precedes its block.
        program.lines.sort_by_key(|line| line.range.start);
        program.counters.count = counted(&program);
        program.frame.lanes.part = u32::try_from(program.parts.len()).unwrap_or(u32::MAX);
        self.image.programs.push(program);
        Ok(())
    }
}
