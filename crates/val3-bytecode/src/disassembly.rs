//! Images as text, for people and tests.

use std::fmt::Write;

use val3_lang::memory::{Kind, Lanes};

use crate::{
    ArgumentSite, CallSite, CopySite, InstructionSite, Op, Operand, Program, ProgramRef, Register, Subscript,
    TextOperand, TextSource,
};

/// The operations of a program, each in a line of its own. One that begins an instruction line has the number of that
/// line before it.
///
/// Lanes are written as `n3` (numbers), `t0` (texts), `l0` (links), places as `p2`.
#[must_use]
pub fn disassemble(program: &Program) -> String {
    let mut text = String::new();
    for (at, step) in (0u32..).zip(&program.code) {
        let line = program.lines.iter().position(|line| line.op == at);
        let number = line.map_or(String::new(), |line| (line + 1).to_string());
        // Writing to a string does not fail.
        let _ = writeln!(text, "{number:>4} {at:>5}  {}", shown(&step.op, program));
    }
    text
}

fn shown(op: &Op, program: &Program) -> String {
    fn find<T>(table: &[T], site: u32, show: impl Fn(&T) -> String) -> String {
        table.get(site as usize).map_or_else(|| "?".to_owned(), show)
    }
    match op {
        Op::Instruction { site } => find(&program.instructions, *site, instruction),
        Op::Copy { site } => find(&program.copies, *site, |site| format!("Copy {}", copy(site))),
        Op::Compare { to, site } => find(&program.copies, *site, |site| format!("Compare n{to}, {}", copy(site))),
        Op::Call { site } => find(&program.calls, *site, |site| format!("Call {}", call(site))),
        Op::CreateTask { site } => find(&program.tasks, *site, |site| {
            let overrun = site.overrun.map_or(String::new(), |overrun| format!(", {}", operand(overrun, ONE_NUM)));
            format!("CreateTask {}, n{}{overrun}, {}", text(site.name), site.rate, call(&site.call))
        }),
        other => format!("{other:?}"),
    }
}

fn instruction(site: &InstructionSite) -> String {
    let result = site.result.map_or(String::new(), |(result, _)| format!(" -> {}", operand(result, ALL)));
    format!("Instruction {}({}){result}", site.name, arguments(&site.arguments))
}

fn call(site: &CallSite) -> String {
    let program = match site.program {
        ProgramRef::Own(number) => format!("program {number}"),
        ProgramRef::Import(number) => format!("import {number}"),
    };
    format!("{program}({})", arguments(&site.arguments))
}

fn copy(site: &CopySite) -> String {
    format!("{} from {}", operand(site.to, site.kind.size), operand(site.from, site.kind.size))
}

fn arguments(sites: &[ArgumentSite]) -> String {
    sites.iter().map(argument).collect::<Vec<_>>().join(", ")
}

fn argument(site: &ArgumentSite) -> String {
    let from = |start: &Option<Register>| start.map_or(String::new(), |start| format!(" from n{start}"));
    match site {
        ArgumentSite::Value(value, base) => {
            format!("{} {}", base.name(), operand(*value, Kind::builtin(*base, None).size))
        }
        ArgumentSite::UserValue(value) => format!("user {}", operand(*value, ALL)),
        ArgumentSite::View(container, start) => format!("{container:?}{}", from(start)),
        ArgumentSite::Slot(container, at) => format!("{container:?}{}", subscript(*at)),
        ArgumentSite::Library(number) => format!("library {number}"),
    }
}

fn subscript(at: Subscript) -> String {
    match at {
        Subscript::Whole => String::new(),
        Subscript::One(i) => format!("[n{i}]"),
        Subscript::Two([i, j]) => format!("[n{i},n{j}]"),
        Subscript::Three([i, j, k]) => format!("[n{i},n{j},n{k}]"),
        Subscript::Key(key) => format!("[{}]", text(key)),
    }
}

fn text(operand: TextOperand) -> String {
    match operand.source() {
        TextSource::Register(register) => format!("t{register}"),
        TextSource::Place(place) => format!("p{place}"),
        TextSource::Constant(number) => format!("constant {number}"),
        TextSource::First(container) => format!("{container:?}"),
    }
}

const ONE_NUM: Lanes = Lanes::nums(1);

/// The lanes shown for a value of unknown type.
const ALL: Lanes = Lanes { num: 1, text: 1, link: 1, part: 0 };

/// The lanes of an operand that a value of this size uses.
fn operand(operand: Operand, size: Lanes) -> String {
    let lanes = |lanes: Lanes| {
        let sorts = [('n', lanes.num, size.num), ('t', lanes.text, size.text), ('l', lanes.link, size.link)];
        let used = sorts.into_iter().filter(|(_, _, size)| *size > 0);
        used.map(|(sort, at, _)| format!("{sort}{at}")).collect::<Vec<_>>().join("/")
    };
    match operand {
        Operand::Frame(at) => lanes(at),
        Operand::First(container, offset) if offset == Lanes::default() => format!("{container:?}"),
        Operand::First(container, offset) => format!("{container:?}+{}", lanes(offset)),
        Operand::Place(place, offset) if offset == Lanes::default() => format!("p{place}"),
        Operand::Place(place, offset) => format!("p{place}+{}", lanes(offset)),
    }
}
