//! Finds out from a line's operations whether it reads watched data.
//!
//! All operations of the line count, including operands that a condition skips and every argument of an instruction. If
//! an array or collection element is watched, reading any other element counts too.

use std::ops::Range;

use rustc_hash::FxHashSet;
use val3_bytecode::{
    ArgumentSite, CallSite, ContainerKind, ContainerRef, Op, Operand, Pass, Program, Register, TextOperand, TextSource,
};
use val3_lang::memory::{Lanes, Memory, StoreId};
use val3_vm::{Frame, Imported, Instance};

/// Containers, and lanes of a stack, that contain watched data.
#[derive(Debug, Default)]
pub(crate) struct Extent {
    pub(crate) stores: FxHashSet<StoreId>,
    pub(crate) nums: Range<u32>,
    pub(crate) texts: Range<u32>,
    pub(crate) links: Range<u32>,
}

impl Extent {
    /// Returns the lanes of a value on the stack.
    pub(crate) fn on_stack(start: Lanes, size: Lanes) -> Self {
        Self {
            stores: FxHashSet::default(),
            nums: start.num..start.num + size.num,
            texts: start.text..start.text + size.text,
            links: start.link..start.link + size.link,
        }
    }

    fn overlaps(&self, start: Lanes, size: Lanes) -> bool {
        let meets = |own: &Range<u32>, start: u32, size: u32| own.start < start + size && start < own.end;
        meets(&self.nums, start.num, size.num)
            || meets(&self.texts, start.text, size.text)
            || meets(&self.links, start.link, size.link)
    }
}

/// An executed line: its program, its stack frame and its first operation.
pub(crate) struct ExecutedLine<'a> {
    pub(crate) instance: &'a Instance,
    pub(crate) program: &'a Program,
    pub(crate) frame: &'a Frame,
    pub(crate) op: u32,
    /// Memory after the line, with the stack of the task.
    pub(crate) memory: &'a Memory,
}

impl ExecutedLine<'_> {
    /// Whether the line reads the data.
    pub(crate) fn reads(&self, extent: &Extent) -> bool {
        let rest = self.program.code.get(self.op as usize..).unwrap_or_default();
        let further = rest.iter().skip(1).take_while(|step| !step.mark.begins_line());
        rest.iter().take(1).chain(further).any(|step| self.operation_reads(&step.op, extent))
    }

    fn operation_reads(&self, op: &Op, extent: &Extent) -> bool {
        let nums = |registers: &[Register]| registers.iter().any(|number| self.number(*number, extent));
        let texts = |operands: &[TextOperand]| operands.iter().any(|text| self.text(*text, extent));
        let container = |container| self.container(container).is_some_and(|store| extent.stores.contains(&store));
        match *op {
            Op::JumpUnless { condition, .. } | Op::JumpIf { condition, .. } | Op::WaitUntil { condition, .. } => {
                nums(&[condition])
            }
            Op::Watch { condition, seconds, .. } => nums(&[condition, seconds]),
            Op::IfLess { a, b, .. }
            | Op::IfLessEqual { a, b, .. }
            | Op::UnlessLess { a, b, .. }
            | Op::UnlessLessEqual { a, b, .. }
            | Op::UnlessEqual { a, b, .. }
            | Op::IfEqual { a, b, .. }
            | Op::Add { a, b, .. }
            | Op::Subtract { a, b, .. }
            | Op::Multiply { a, b, .. }
            | Op::Divide { a, b, .. }
            | Op::Remainder { a, b, .. }
            | Op::Less { a, b, .. }
            | Op::LessEqual { a, b, .. }
            | Op::Equal { a, b, .. }
            | Op::NotEqual { a, b, .. } => nums(&[a, b]),
            Op::Negate { a, .. } | Op::Not { a, .. } => nums(&[a]),
            Op::Function { a, b, c, .. } => nums(&[a, b, c]),
            Op::Move { from, .. } | Op::StoreFirst { from, .. } | Op::Store { from, .. } => nums(&[from]),
            Op::TextMove { from, .. } => texts(&[from]),
            Op::Concatenate { a, b, .. }
            | Op::TextEqual { a, b, .. }
            | Op::IfTextEqual { a, b, .. }
            | Op::UnlessTextEqual { a, b, .. } => texts(&[a, b]),
            Op::LoadFirst { container: from, .. } => container(from),
            Op::LoadElement { container: from, index, .. } => container(from) || nums(&[index]),
            Op::LoadElement2 { container: from, i, j, .. } => container(from) || nums(&[i, j]),
            Op::LoadKey { container: from, key, .. } => container(from) || texts(&[key]),
            Op::StoreElement { index, from, .. } => nums(&[index, from]),
            Op::StoreElement2 { i, j, from, .. } => nums(&[i, j, from]),
            Op::StoreKey { key, from, .. } => nums(&[from]) || texts(&[key]),
            Op::ElementField { index, .. } | Op::Locate { index, .. } => nums(&[index]),
            Op::Locate2 { i, j, .. } => nums(&[i, j]),
            Op::Locate3 { i, .. } => nums(&[i, i.saturating_add(1), i.saturating_add(2)]),
            Op::LocateKey { key, .. } => texts(&[key]),
            Op::Load { place, lane, .. } => self.place(place, lane, 1, extent),
            Op::Copy { site } => {
                let site = self.program.copies.get(site as usize);
                site.is_some_and(|site| self.operand(&site.from, site.kind.size, extent))
            }
            Op::Compare { site, .. } => {
                let site = self.program.copies.get(site as usize);
                site.is_some_and(|site| {
                    [&site.from, &site.to].iter().any(|one| self.operand(one, site.kind.size, extent))
                })
            }
            Op::Instruction { site } => {
                let site = self.program.instructions.get(site as usize);
                site.is_some_and(|site| site.arguments.iter().any(|argument| self.argument(argument, extent)))
            }
            Op::Call { site } => self.program.calls.get(site as usize).is_some_and(|site| self.call(site, extent)),
            Op::CreateTask { site } => {
                let site = self.program.tasks.get(site as usize);
                site.is_some_and(|site| texts(&[site.name]) || nums(&[site.rate]) || self.call(&site.call, extent))
            }
            Op::ForTest { counter, limit, .. }
            | Op::ForNext { counter, limit, .. }
            | Op::ForNextUp { counter, limit, .. } => nums(&[counter, limit, limit.saturating_add(1)]),
            Op::Line
            | Op::Jump { .. }
            | Op::FirstField { .. }
            | Op::Field { .. }
            | Op::LocateFirst { .. }
            | Op::Return => false,
        }
    }

    fn number(&self, register: Register, extent: &Extent) -> bool {
        extent.nums.contains(&(self.frame.base.num + u32::from(register)))
    }

    fn text(&self, text: TextOperand, extent: &Extent) -> bool {
        match text.source() {
            TextSource::Register(number) => extent.texts.contains(&(self.frame.base.text + u32::from(number))),
            TextSource::First(kind) => self.found(kind).is_some_and(|store| extent.stores.contains(&store)),
            TextSource::Place(number) => self.place(number, 0, 0, extent),
            TextSource::Constant(_) => false,
        }
    }

    fn container(&self, container: ContainerRef) -> Option<StoreId> {
        self.found(container.kind())
    }

    fn found(&self, kind: ContainerKind) -> Option<StoreId> {
        let (base, stack) = (&self.frame.base, &self.memory.stack);
        match kind {
            ContainerKind::Data(number) => self.instance.data.get(usize::from(number)).copied(),
            ContainerKind::Part(number) => stack.parts.get(base.part as usize + usize::from(number)).copied(),
            ContainerKind::View(number) => {
                stack.views.get(base.view as usize + usize::from(number)).map(|view| view.store)
            }
            ContainerKind::Import(number) => match self.instance.imports.get(usize::from(number)) {
                Some(Some(Imported::Data(store))) => Some(*store),
                _ => None,
            },
            ContainerKind::Builtin(0) => Some(Memory::WORLD),
            ContainerKind::Builtin(_) => Some(Memory::FLANGE),
        }
    }

    /// Whether reading numbers at a place reads the data. For a text `count` is 0, and every text at the place counts.
    fn place(&self, number: Register, lane: u16, count: u32, extent: &Extent) -> bool {
        let at = self.frame.base.place as usize + usize::from(number);
        self.memory.stack.places.get(at).is_some_and(|place| match place.store {
            StoreId::STACK => {
                let start = Lanes { num: place.num + u32::from(lane), text: place.text, link: place.link, part: 0 };
                extent.overlaps(start, Lanes { num: count, text: u32::from(count == 0), link: 0, part: 0 })
            }
            store => extent.stores.contains(&store),
        })
    }

    fn operand(&self, operand: &Operand, size: Lanes, extent: &Extent) -> bool {
        match *operand {
            Operand::Frame(lanes) => {
                let place = self.frame.place(lanes);
                let start = Lanes { num: place.num, text: place.text, link: place.link, part: place.part };
                let first_part = self.memory.stack.parts.get(place.part as usize);
                extent.overlaps(start, size)
                    || (size.part > 0 && first_part.is_some_and(|part| extent.stores.contains(part)))
            }
            Operand::First(container, _) => {
                self.container(container).is_some_and(|store| extent.stores.contains(&store))
            }
            Operand::Place(number, _) => {
                let at = self.frame.base.place as usize + usize::from(number);
                self.memory.stack.places.get(at).is_some_and(|place| match place.store {
                    StoreId::STACK => {
                        let start = Lanes { num: place.num, text: place.text, link: place.link, part: place.part };
                        extent.overlaps(start, size)
                    }
                    store => extent.stores.contains(&store),
                })
            }
        }
    }

    fn argument(&self, argument: &ArgumentSite, extent: &Extent) -> bool {
        let of_part = Lanes { num: 0, text: 0, link: 0, part: 1 };
        match argument {
            ArgumentSite::Value(operand, base) => {
                let size = val3_lang::memory::ValueType::builtin(*base, None).size;
                self.operand(operand, size, extent)
            }
            ArgumentSite::UserValue(operand) => self.operand(operand, of_part, extent),
            ArgumentSite::View(container, _) | ArgumentSite::Slot(container, _) => {
                self.container(*container).is_some_and(|store| extent.stores.contains(&store))
            }
            ArgumentSite::Library(_) => false,
        }
    }

    /// Whether the arguments of a call read the data. Arguments by reference do not, because the call itself does not
    /// read them.
    fn call(&self, site: &CallSite, extent: &Extent) -> bool {
        match &site.passes {
            Some(passes) => passes.iter().any(|pass| match *pass {
                Pass::Number(from, _) => self.number(from, extent),
                Pass::Text(from, _) => self.text(from, extent),
                Pass::Reference(..) | Pass::Container(..) => false,
            }),
            None => site.arguments.iter().any(|argument| self.argument(argument, extent)),
        }
    }
}
