//! Entries of the tables of a program: copies, instructions, calls, tasks. The text has them at their operation.

use val3_lang::instructions;
use val3_lang::memory::{Kind, Lanes};
use val3_lang::operators::{BinaryOp, UnaryOp};

use super::operands::{self, Num, read_operand, write_operand};
use super::reader::{Label, Reader};
use super::values::{ArmType, Type};
use super::writer::Writer;
use super::{Form, Result};
use crate::{
    ArgumentSite, CallSite, Callee, ContainerRef, CopySite, InstructionSite, ProgramRef, Subscript, TaskSite,
    TextOperand,
};

/// Tables of a program: the form of the number of an entry is the entry.
macro_rules! tables {
    ($($form:ident $field:ident: $site:ty;)+) => {
        $(
            #[doc = concat!("An entry of `", stringify!($field), "`.")]
            pub(super) struct $form;

            impl Form for $form {
                type Value = u32;

                fn write(value: &u32, to: &mut Writer<'_>) {
                    match to.code.and_then(|code| code.$field.get(*value as usize)) {
                        Some(site) => <$site>::write(site, to),
                        None => to.put("?"),
                    }
                }

                fn read(from: &mut Reader<'_>) -> Result<u32> {
                    let site = <$site>::read(from)?;
                    from.code.$field.push(site);
                    Ok(u32::try_from(from.code.$field.len() - 1).unwrap_or(u32::MAX))
                }
            }
        )+
    };
}

tables! {
    Copies copies: CopySite;
    Instructions instructions: InstructionSite;
    Calls calls: CallSite;
    Tasks tasks: TaskSite;
}

impl Form for CopySite {
    type Value = Self;

    fn write(value: &Self, to: &mut Writer<'_>) {
        let size = value.kind.size;
        Type::write(&value.kind, to);
        to.put(" ");
        write_operand(value.to, size, to);
        to.put(" ");
        write_operand(value.from, size, to);
    }

    fn read(from: &mut Reader<'_>) -> Result<Self> {
        let kind = Type::read(from)?;
        let to = read_operand(from)?;
        Ok(Self { kind, to, from: read_operand(from)? })
    }
}

impl Form for InstructionSite {
    type Value = Self;

    fn write(value: &Self, to: &mut Writer<'_>) {
        Callee::write(&value.callee, to);
        to.put(" ");
        write_arguments(&value.arguments, to);
        if let Some((result, base)) = value.result {
            to.put(" -> ");
            ArgumentSite::write(&ArgumentSite::Value(result, base), to);
        }
    }

    fn read(from: &mut Reader<'_>) -> Result<Self> {
        let callee = Callee::read(from)?;
        let arguments = read_arguments(from)?;
        let result = if from.accept("->") { Some(ArgumentSite::read(from)?) } else { None };
        let result = match result {
            Some(ArgumentSite::Value(result, base)) => Some((result, base)),
            None => None,
            Some(_) => return from.fail("a result has a built-in type and a place, such as `num n0`"),
        };
        Ok(Self { arguments, result, ..Self::new(callee) })
    }
}

impl Form for Callee {
    type Value = Self;

    fn write(value: &Self, to: &mut Writer<'_>) {
        match value {
            Self::Form(instruction, form) => {
                to.name(instruction.name);
                let number = instruction.overloads.iter().position(|other| other == *form).unwrap_or(0);
                if number > 0 {
                    to.put(&format!("#{number}"));
                }
            }
            Self::Binary(op, base, arm) => {
                to.put(&format!("binary \"{}\" ", op.symbol()));
                ArmType::write(&(*base, *arm), to);
            }
            Self::Unary(op, base) => to.put(&format!("unary \"{}\" {}", op.symbol(), base.name())),
            Self::Assignment(target, value) => to.put(&format!("assign {} {}", target.name(), value.name())),
            Self::Print(arm) => {
                to.put("print");
                if let Some(arm) = arm {
                    to.put(arm.suffix());
                }
            }
            Self::MissingItem(name) => {
                to.put("missing ");
                to.quoted(name);
            }
            Self::Invalid => to.put("invalid"),
            Self::Lacking(name) => {
                to.put("lacking ");
                to.quoted(name);
            }
        }
    }

    fn read(from: &mut Reader<'_>) -> Result<Self> {
        let is_quoted = from.peek().starts_with('"');
        let name = from.name()?;
        let word = if is_quoted { "" } else { name.as_str() };
        match word {
            "binary" => {
                let symbol = from.quoted()?;
                let Some(op) = BinaryOp::from_symbol(&symbol) else { return from.fail("an operator is expected here") };
                let (base, arm) = ArmType::read(from)?;
                Ok(Self::Binary(op, base, arm))
            }
            "unary" => {
                let symbol = from.quoted()?;
                let found = [UnaryOp::Negate, UnaryOp::Not].into_iter().find(|op| op.symbol() == symbol);
                let Some(op) = found else { return from.fail("an operator is expected here") };
                Ok(Self::Unary(op, ArmType::read(from)?.0))
            }
            "assign" => Ok(Self::Assignment(ArmType::read(from)?.0, ArmType::read(from)?.0)),
            "missing" => from.quoted().map(Self::MissingItem),
            "invalid" => Ok(Self::Invalid),
            "lacking" => from.quoted().map(Self::Lacking),
            _ => match word.strip_prefix("print").map(ArmType::arm) {
                Some(Some(arm)) => Ok(Self::Print(arm)),
                _ => form(&name, from),
            },
        }
    }
}

/// A form of an instruction, the first one without a number.
fn form(name: &str, from: &mut Reader<'_>) -> Result<Callee> {
    let Some(instruction) = instructions::find(name) else {
        return from.fail(&format!("there is no instruction `{name}`"));
    };
    let number = if from.accept("#") { from.number::<usize>()? } else { 0 };
    match instruction.overloads.get(number) {
        Some(form) => Ok(Callee::Form(instruction, form)),
        None => from.fail(&format!("`{name}` has {} forms, counted from 0", instruction.overloads.len())),
    }
}

fn write_arguments(arguments: &[ArgumentSite], to: &mut Writer<'_>) {
    to.put("(");
    to.list(arguments, ", ", ArgumentSite::write);
    to.put(")");
}

fn read_arguments(from: &mut Reader<'_>) -> Result<Vec<ArgumentSite>> {
    from.expect("(")?;
    from.list((",", ")"), ArgumentSite::read)
}

impl Form for ArgumentSite {
    type Value = Self;

    fn write(value: &Self, to: &mut Writer<'_>) {
        match value {
            Self::Value(operand, base) => {
                to.put(&format!("{} ", base.name()));
                write_operand(*operand, Kind::builtin(*base, None).size, to);
            }
            Self::UserValue(operand) => {
                to.put("user ");
                write_operand(*operand, Lanes::default(), to);
            }
            Self::View(container, start) => {
                to.put("view ");
                ContainerRef::write(container, to);
                if let Some(start) = start {
                    to.put(" from ");
                    Num::write(start, to);
                }
            }
            Self::Slot(container, at) => {
                to.put("slot ");
                ContainerRef::write(container, to);
                Subscript::write(at, to);
            }
            Self::Library(number) => {
                to.put("library ");
                to.library(*number);
            }
        }
    }

    fn read(from: &mut Reader<'_>) -> Result<Self> {
        if from.accept("user") {
            return read_operand(from).map(Self::UserValue);
        }
        if from.accept("view") {
            let container = ContainerRef::read(from)?;
            let start = if from.accept("from") { Some(Num::read(from)?) } else { None };
            return Ok(Self::View(container, start));
        }
        if from.accept("slot") {
            return Ok(Self::Slot(ContainerRef::read(from)?, Subscript::read(from)?));
        }
        if from.accept("library") {
            return from.library().map(Self::Library);
        }
        let (base, _) = ArmType::read(from)?;
        Ok(Self::Value(read_operand(from)?, base))
    }
}

impl Form for CallSite {
    type Value = Self;

    fn write(value: &Self, to: &mut Writer<'_>) {
        match value.program {
            ProgramRef::Own(number) => {
                let image = to.image;
                to.item(image.programs.iter().map(|program| program.name.as_str()), number.into());
            }
            ProgramRef::Import(number) => to.put(&format!("import {number}")),
        }
        to.put(" ");
        write_arguments(&value.arguments, to);
    }

    fn read(from: &mut Reader<'_>) -> Result<Self> {
        let name = from.name()?;
        let is_import = name == "import" && from.peek() != "(";
        let program = if is_import {
            ProgramRef::Import(from.number()?)
        } else {
            let used = from.last();
            let number = operands::number(&mut from.callees, Label { name, used, target: None });
            ProgramRef::Own(u16::try_from(number).unwrap_or(u16::MAX))
        };
        Ok(Self { program, arguments: read_arguments(from)?, passes: None })
    }
}

impl Form for TaskSite {
    type Value = Self;

    fn write(value: &Self, to: &mut Writer<'_>) {
        TextOperand::write(&value.name, to);
        to.put(" ");
        Num::write(&value.rate, to);
        to.put(" ");
        if let Some(overrun) = value.overrun {
            to.put("overrun ");
            write_operand(overrun, Lanes::nums(1), to);
            to.put(" ");
        }
        CallSite::write(&value.call, to);
    }

    fn read(from: &mut Reader<'_>) -> Result<Self> {
        let (name, rate) = (TextOperand::read(from)?, Num::read(from)?);
        let overrun = if from.accept("overrun") { Some(read_operand(from)?) } else { None };
        Ok(Self { name, rate, overrun, call: CallSite::read(from)? })
    }
}

#[cfg(test)]
mod tests {
    use super::instructions;

    #[test]
    fn words_for_callees_are_no_instructions() {
        for word in ["binary", "unary", "assign", "missing", "invalid", "lacking", "print", "printRs"] {
            assert!(instructions::find(word).is_none(), "{word}");
        }
    }
}
