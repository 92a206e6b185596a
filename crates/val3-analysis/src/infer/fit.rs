//! Matching of arguments against parameters (2.6).

use smallvec::SmallVec;
use smol_str::{SmolStr, format_smolstr};
use val3_lang::add_on::AddOnParam;
use val3_lang::instruction::ArgumentForm;
use val3_lang::operators;
use val3_lang::types::{self, Arm, BaseType, Container};

use super::value::{Form, InferredValue};
use crate::body::ExprId;
use crate::db::Db;
use crate::items::project::SignatureParam;
use crate::ty::{Base, brackets};

/// A parameter: of a program, an instruction or an add-on instruction.
#[derive(Debug, Clone, Copy)]
pub(super) struct Formal<'a> {
    pub(super) name: &'a str,
    /// Type; `None` accepts any type.
    pub(super) base: Option<Base>,
    pub(super) shape: ArgumentForm,
    /// Whether it is a parameter of the old dialect, which accepts constants and does not distinguish an element by
    /// reference from an array.
    pub(super) loose: bool,
}

/// Parameters of a form.
#[derive(Debug, Clone, Copy)]
pub(super) enum Formals<'a> {
    Instruction(&'a [val3_lang::instruction::InstructionParam]),
    AddOn(&'a [AddOnParam]),
    Program(&'a [SignatureParam]),
}

impl<'a> Formals<'a> {
    pub(super) fn len(self) -> usize {
        match self {
            Self::Instruction(params) => params.len(),
            Self::AddOn(params) => params.len(),
            Self::Program(params) => params.len(),
        }
    }

    pub(super) fn get(self, index: usize) -> Option<Formal<'a>> {
        match self {
            Self::Instruction(params) => params.get(index).map(|param| Formal {
                name: param.name,
                base: param.ty.map(Base::of),
                shape: param.shape,
                loose: false,
            }),
            Self::AddOn(params) => params.get(index).map(|param| Formal {
                name: &param.name,
                base: param.ty.map(Base::of),
                shape: param.shape,
                loose: false,
            }),
            Self::Program(params) => params.get(index).map(of_program),
        }
    }
}

fn of_program(param: &SignatureParam) -> Formal<'_> {
    Formal { name: &param.name, base: Some(param.base), shape: param.shape(), loose: param.loose }
}

/// An inferred argument, to be matched against every form.
#[derive(Debug, Clone)]
pub(super) struct Argument {
    pub(super) id: ExprId,
    /// Values of a `{…}`, whose type depends on the parameter: whether each of them is a `{…}`, too.
    pub(super) literal: Option<SmallVec<[bool; 8]>>,
    pub(super) value: InferredValue,
}

/// Mismatch between an argument and a parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Misfit {
    Type,
    /// The type belongs to another kind of arm.
    Arm,
    /// A variable is required.
    Constant,
    /// Another container is required.
    Container,
    /// The index or key is missing.
    IndexMissing,
    /// A whole container is required.
    IndexNotAllowed,
}

/// Returns the mismatch between `argument` and `formal`; `None` if they match.
pub(super) fn misfit(arm: Option<Arm>, argument: &Argument, formal: Formal<'_>) -> Option<Misfit> {
    if formal.base == Some(Base::Unknown) {
        return None;
    }
    if let Some(values) = &argument.literal {
        return literal_misfit(arm, values, formal);
    }
    let value = &argument.value;
    if value.is_unknown() {
        return None;
    }
    if formal.shape != ArgumentForm::Value && !value.is_variable() && !formal.loose {
        return Some(type_misfit(arm, value, formal).unwrap_or(Misfit::Constant));
    }
    container_misfit(value, formal).or_else(|| type_misfit(arm, value, formal))
}

fn literal_misfit(arm: Option<Arm>, values: &[bool], formal: Formal<'_>) -> Option<Misfit> {
    match formal.base {
        Some(base) if !literal_suits(arm, values, base) => Some(Misfit::Type),
        _ if formal.shape != ArgumentForm::Value && !formal.loose => Some(Misfit::Constant),
        Some(_) => None,
        None => Some(Misfit::Type),
    }
}

fn type_misfit(arm: Option<Arm>, value: &InferredValue, formal: Formal<'_>) -> Option<Misfit> {
    let base = formal.base?.on_arm(arm);
    if base.same_as(value.base) {
        return None;
    }
    match (base, value.base) {
        (Base::Builtin(a, _), Base::Builtin(b, _)) if a == b => Some(Misfit::Arm),
        // An input or output is read where a boolean is expected.
        (Base::Builtin(a, _), Base::Builtin(b, _))
            if formal.shape == ArgumentForm::Value && operators::reads_as_bool(a) && operators::reads_as_bool(b) =>
        {
            (a == BaseType::Dio).then_some(Misfit::Type)
        }
        _ => Some(Misfit::Type),
    }
}

fn container_misfit(value: &InferredValue, formal: Formal<'_>) -> Option<Misfit> {
    let container = value.container();
    match formal.shape {
        ArgumentForm::Value | ArgumentForm::Reference => value.lacks_index().then_some(Misfit::IndexMissing),
        ArgumentForm::Array { dims: 1 } if formal.loose => value.lacks_index().then_some(Misfit::Container),
        ArgumentForm::Array { dims: 1 } => match (&value.form, container) {
            (Form::Indexed { of: Container::Array { dims: 2.. } }, _) => Some(Misfit::Container),
            (_, Container::Array { dims: 2.. } | Container::Collection) => Some(Misfit::Container),
            _ => None,
        },
        ArgumentForm::Array { .. } => {
            whole(value, formal.shape, |found| ArgumentForm::Array { dims: dims(found) } == formal.shape)
        }
        ArgumentForm::Collection => whole(value, formal.shape, |found| found == Container::Collection),
        ArgumentForm::Whole => match &value.form {
            Form::Indexed { of: Container::Array { dims: 2.. } | Container::Collection } => {
                Some(Misfit::IndexNotAllowed)
            }
            _ => None,
        },
        ArgumentForm::Slot => value.lacks_index().then_some(Misfit::IndexMissing),
        ArgumentForm::Item | ArgumentForm::ProgramCall => None,
    }
}

/// Whether `{…}` with these values may be a value of `base`. Only fields of structures may be `{…}` again.
fn literal_suits(arm: Option<Arm>, values: &[bool], base: Base) -> bool {
    match base {
        Base::Unknown | Base::User(_) => true,
        Base::Builtin(ty, own) => {
            let fields = types::fields(ty, own.or(arm));
            let is_structure = |ty| !types::fields(ty, own.or(arm)).is_empty();
            let mut pairs = fields.iter().zip(values);
            !fields.is_empty()
                && values.len() <= fields.len()
                && pairs.all(|(field, is_literal)| !is_literal || is_structure(field.ty))
        }
    }
}

impl Formal<'_> {
    /// Formats the parameter's type as in a program.
    pub(super) fn display(self, db: &dyn Db) -> SmolStr {
        let base = self.base.map_or(SmolStr::new_static("any type"), |base| base.display(db));
        let container = match self.shape {
            ArgumentForm::Array { dims } => Container::Array { dims },
            ArgumentForm::Collection => Container::Collection,
            _ => Container::Element,
        };
        format_smolstr!("{base}{}", brackets(container))
    }
}

fn dims(container: Container) -> u8 {
    match container {
        Container::Array { dims } => dims,
        Container::Element | Container::Collection => 0,
    }
}

/// Matches an argument for a whole container, which must have no index (2.6.3).
fn whole(value: &InferredValue, shape: ArgumentForm, suits: impl Fn(Container) -> bool) -> Option<Misfit> {
    match &value.form {
        Form::Indexed { of } if suits(*of) => Some(Misfit::IndexNotAllowed),
        Form::Whole(variable) if suits(variable.container) => None,
        // In the old dialect, the number of dimensions is unknown for an array parameter.
        Form::Whole(variable) if variable.loose && shape != ArgumentForm::Collection => None,
        _ => Some(Misfit::Container),
    }
}
