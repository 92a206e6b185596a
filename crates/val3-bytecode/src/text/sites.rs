//! Entries of a program's tables: copies, instructions, calls, tasks. In the text they appear at their operation.

use val3_lang::instructions;
use val3_lang::memory::ValueType;
use val3_lang::operators::{BinaryOp, UnaryOp};
use val3_lang::types::BaseType;

use super::ListingForm;
use super::error::Result;
use super::forms::{From, InArm, Listed, Number, Optional, Overrun, Quoted, To, choices, sequences};
use super::image::Library;
use super::operands::{self, Num, write_operand};
use super::reader::{Label, ListingReader};
use super::values::{ArmName, BaseName, ListedType};
use super::writer::Writer;
use crate::{
    ArgumentSite, CallSite, Callee, ContainerRef, CopySite, InstructionSite, Operand, ProgramRef, Subscript, TaskSite,
    TextOperand,
};

/// Tables of a program: the text contains the entry in place of the entry's number.
macro_rules! tables {
    ($($form:ident $field:ident: $site:ty;)+) => {$(
        #[doc = concat!("An entry of `", stringify!($field), "`.")]
        pub(super) struct $form;

        impl ListingForm for $form {
            type Value = u32;

            fn write(value: &u32, to: &mut Writer<'_>) {
                match to.code.and_then(|code| code.$field.get(*value as usize)) {
                    Some(site) => <$site>::write(site, to),
                    None => to.put("?"),
                }
            }

            fn read(from: &mut ListingReader<'_>) -> Result<u32> {
                let site = <$site>::read(from)?;
                from.code.$field.push(site);
                Ok(u32::try_from(from.code.$field.len() - 1).unwrap_or(u32::MAX))
            }
        }
    )+};
}

tables! {
    Copies copies: CopySite;
    Instructions instructions: InstructionSite;
    Calls calls: CallSite;
    Tasks tasks: TaskSite;
}

sequences! {
    CopySite { kind: ListedType, to: Operand, from: Operand };
    TaskSite { name: TextOperand, rate: Num, overrun: Optional<Overrun, Operand>, call: CallSite };
}

choices! {
    ArgumentSite, "an argument" {
        "user" UserValue(value: Operand),
        "view" View(container: ContainerRef, start: Optional<From, Num>),
        "slot" Slot(container: ContainerRef, at: Subscript),
        "library" Library(number: Library),
        _ => TypedArgument,
    }
    Callee, "an instruction" {
        "binary" Binary(op: Operator<BinaryOp>, base: BaseName, arm: Optional<InArm, ArmName>),
        "unary" Unary(op: Operator<UnaryOp>, base: BaseName),
        "assign" Assignment(to: BaseName, from: BaseName),
        "print" Print(arm: Optional<InArm, ArmName>),
        "missing" MissingItem(name: Quoted),
        "invalid" Invalid,
        "lacking" Lacking(name: Quoted),
        _ => InstructionForm,
    }
}

/// A value of a built-in type: `num n0`.
struct TypedValue;

impl ListingForm for TypedValue {
    type Value = (Operand, BaseType);

    fn write(value: &Self::Value, to: &mut Writer<'_>) {
        let (operand, base) = value;
        to.put(&format!("{} ", base.name()));
        write_operand(*operand, ValueType::builtin(*base, None).size, to);
    }

    fn read(from: &mut ListingReader<'_>) -> Result<Self::Value> {
        let base = BaseName::read(from)?;
        Ok((Operand::read(from)?, base))
    }
}

struct TypedArgument;

impl ListingForm for TypedArgument {
    type Value = ArgumentSite;

    fn write(value: &ArgumentSite, to: &mut Writer<'_>) {
        if let ArgumentSite::Value(operand, base) = value {
            TypedValue::write(&(*operand, *base), to);
        }
    }

    fn read(from: &mut ListingReader<'_>) -> Result<ArgumentSite> {
        TypedValue::read(from).map(|(operand, base)| ArgumentSite::Value(operand, base))
    }
}

impl ListingForm for InstructionSite {
    type Value = Self;

    fn write(value: &Self, to: &mut Writer<'_>) {
        to.part(|to| Callee::write(&value.callee, to));
        to.part(|to| Listed::<ArgumentSite>::write(&value.arguments, to));
        to.part(|to| Optional::<To, TypedValue>::write(&value.result, to));
    }

    fn read(from: &mut ListingReader<'_>) -> Result<Self> {
        let callee = Callee::read(from)?;
        let arguments = Listed::<ArgumentSite>::read(from)?;
        Ok(Self { arguments, result: Optional::<To, TypedValue>::read(from)?, ..Self::new(callee) })
    }
}

/// An instruction form, with its number unless it is the first form: `sin`, `insert#1`.
struct InstructionForm;

impl ListingForm for InstructionForm {
    type Value = Callee;

    fn write(value: &Callee, to: &mut Writer<'_>) {
        let Callee::Form(instruction, form) = value else { return };
        to.name(instruction.name);
        match instruction.overloads.iter().position(|other| other == *form) {
            Some(0) | None => {}
            Some(number) => to.put(&format!("#{number}")),
        }
    }

    fn read(from: &mut ListingReader<'_>) -> Result<Callee> {
        let name = from.name()?;
        let Some(instruction) = instructions::find(&name) else {
            return from.fail(&format!("there is no instruction `{name}`"));
        };
        let number = if from.accept("#") { Number::<usize>::read(from)? } else { 0 };
        match instruction.overloads.get(number) {
            Some(form) => Ok(Callee::Form(instruction, form)),
            None => from.fail(&format!("`{name}` has {} forms, counted from 0", instruction.overloads.len())),
        }
    }
}

/// Operator symbol.
struct Operator<O>(std::marker::PhantomData<O>);

macro_rules! operators {
    ($($op:ty: $find:expr;)+) => {$(
        impl ListingForm for Operator<$op> {
            type Value = $op;

            fn write(value: &$op, to: &mut Writer<'_>) {
                to.quoted(value.symbol());
            }

            fn read(from: &mut ListingReader<'_>) -> Result<$op> {
                let symbol = from.quoted()?;
                $find(symbol.as_str()).map_or_else(|| from.fail(&format!("`{symbol}` is no operator here")), Ok)
            }
        }
    )+};
}

operators! {
    BinaryOp: BinaryOp::from_symbol;
    UnaryOp: |symbol: &str| [UnaryOp::Negate, UnaryOp::Not].into_iter().find(|op| op.symbol() == symbol);
}

impl ListingForm for CallSite {
    type Value = Self;

    fn write(value: &Self, to: &mut Writer<'_>) {
        match value.program {
            ProgramRef::Own(number) => {
                let image = to.image;
                to.item(image.programs.iter().map(|program| program.name.as_str()), number.into());
            }
            ProgramRef::Import(number) => to.put(&format!("import {number}")),
        }
        to.part(|to| Listed::<ArgumentSite>::write(&value.arguments, to));
    }

    fn read(from: &mut ListingReader<'_>) -> Result<Self> {
        let name = from.name()?;
        let program = if name == "import" && from.peek() != "(" {
            ProgramRef::Import(from.number()?)
        } else {
            let used = from.last();
            let number = operands::number(&mut from.callees, Label { name, used, target: None });
            ProgramRef::Own(u16::try_from(number).unwrap_or(u16::MAX))
        };
        Ok(Self { program, arguments: Listed::<ArgumentSite>::read(from)?, passes: None })
    }
}

#[cfg(test)]
mod tests {
    use super::instructions;

    #[test]
    fn words_for_callees_are_no_instructions() {
        for word in ["binary", "unary", "assign", "print", "missing", "invalid", "lacking"] {
            assert!(instructions::find(word).is_none(), "{word}");
        }
    }
}
