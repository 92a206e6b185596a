//! Selection of the form that matches the arguments of a call, or report of the argument that matches no form.

use crate::db::FileRange;
use smallvec::SmallVec;
use smol_str::{SmolStr, format_smolstr};
use val3_lang::instruction::ArgumentForm;
use val3_lang::instructions::{self, LEN};
use val3_lang::types::{Arm, Container};

use super::Infer;
use super::fit::{Argument, Formal, Formals, Misfit, misfit};
use super::value::{DeclaredVariable, Form, InferredValue};
use crate::body::{Expr, ExprId};
use crate::problem::{ProblemKind, RelatedRole};
use crate::ty::{Base, brackets};

/// A callee with all its forms.
pub(super) struct Callee<'a> {
    /// Name as written in the code.
    pub(super) name: SmolStr,
    pub(super) forms: SmallVec<[Formals<'a>; 4]>,
    /// Returns the syntax lines; called only for a message that contains them.
    pub(super) lines: &'a dyn Fn() -> Vec<SmolStr>,
    /// Returns the location of the declaration; called only for a message, because it reads another file.
    pub(super) declared: &'a dyn Fn() -> Option<FileRange>,
    /// Whether the controller may have other forms, so that a mismatch is not reported.
    pub(super) may_have_others: bool,
}

impl Callee<'_> {
    /// Whether some form accepts an absent index or key at `position`, as `insert` and `isDefined` do.
    fn takes_slot(&self, position: usize) -> bool {
        let mut formals = self.forms.iter().filter_map(|form| form.get(position));
        formals.any(|formal| matches!(formal.shape, ArgumentForm::Slot | ArgumentForm::Item))
    }
}

/// Forms of a callee that match the arguments.
pub(super) enum MatchingForms {
    /// The matching form, or else the most likely one.
    Form(usize),
    /// Several forms, because an argument type is unknown.
    Several(Vec<usize>),
    /// No form matches. The mismatch was reported, unless the controller may have other forms.
    None,
}

/// First argument that does not match a form.
#[derive(Clone, Copy)]
struct MismatchedArgument<'a> {
    position: usize,
    formal: Formal<'a>,
    misfit: Misfit,
}

impl Infer<'_> {
    /// Matches the arguments against the forms.
    pub(super) fn arguments(&mut self, call: ExprId, args: &[ExprId], callee: &Callee<'_>) -> MatchingForms {
        let arguments: SmallVec<[Argument; 4]> =
            args.iter().enumerate().map(|(position, id)| self.argument(*id, callee.takes_slot(position))).collect();
        let candidates = callee.forms.iter().copied().enumerate().filter(|(_, form)| form.len() == args.len());
        let misses: SmallVec<[(usize, Option<MismatchedArgument<'_>>); 4]> =
            candidates.map(|(index, form)| (index, first_miss(self.scope.arm(), &arguments, form))).collect();
        if misses.is_empty() {
            self.literals_alone(&arguments);
            if !callee.may_have_others {
                self.argument_count(call, args.len(), callee);
            }
            return MatchingForms::None;
        }
        let mut fits = misses.iter().filter(|(_, miss)| miss.is_none()).map(|(index, _)| *index).peekable();
        if let Some(&first) = fits.peek() {
            self.literals(&arguments, callee.forms.get(first).copied());
            let certain = arguments.iter().all(|argument| argument.literal.is_some() || !argument.value.is_unknown());
            return if certain { MatchingForms::Form(first) } else { MatchingForms::Several(fits.collect()) };
        }
        if callee.may_have_others {
            self.literals_alone(&arguments);
            return MatchingForms::None;
        }
        self.report_miss(&arguments, &misses, callee);
        MatchingForms::Several(misses.iter().map(|(index, _)| *index).collect())
    }

    /// Infers an argument; `slot` means that it may name an absent value. `{…}` is inferred later, with the parameter's
    /// type.
    fn argument(&mut self, id: ExprId, slot: bool) -> Argument {
        if let Expr::Struct(values) = self.body.expr(self.body.without_parentheses(id)) {
            let literal = values.iter().map(|value| value.is_some_and(|value| self.is_literal(value))).collect();
            return Argument { id, literal: Some(literal), value: InferredValue::UNKNOWN };
        }
        let outer = std::mem::replace(&mut self.may_be_absent, slot);
        let value = self.expr(id);
        self.may_be_absent = outer;
        Argument { id, literal: None, value }
    }

    /// Infers the `{…}` arguments with the types of the parameters.
    fn literals(&mut self, arguments: &[Argument], form: Option<Formals<'_>>) {
        for (position, argument) in arguments.iter().enumerate() {
            if argument.literal.is_some() {
                let expected = form.and_then(|form| form.get(position)).and_then(|formal| formal.base);
                self.expr_as(argument.id, expected);
            }
        }
    }

    /// Infers the values inside `{…}` without an expected type.
    fn literals_alone(&mut self, arguments: &[Argument]) {
        for argument in arguments.iter().filter(|argument| argument.literal.is_some()) {
            self.expr_as(argument.id, Some(Base::Unknown));
        }
    }

    fn argument_count(&mut self, call: ExprId, found: usize, callee: &Callee<'_>) {
        let mut expected: Vec<usize> = callee.forms.iter().map(|form| form.len()).collect();
        expected.sort_unstable();
        expected.dedup();
        let kind = ProblemKind::ArgumentCount { callee: callee.name.clone(), expected, found, forms: (callee.lines)() };
        self.sink.report_with(call, kind, RelatedRole::Declared, (callee.declared)());
    }

    /// Reports the first mismatch of the form that matches the most leading arguments.
    fn report_miss(
        &mut self,
        arguments: &[Argument],
        misses: &[(usize, Option<MismatchedArgument<'_>>)],
        callee: &Callee<'_>,
    ) {
        let furthest = misses.iter().filter_map(|(_, miss)| miss.as_ref()).map(|miss| miss.position).max();
        let best: Vec<&MismatchedArgument<'_>> = misses
            .iter()
            .filter_map(|(_, miss)| miss.as_ref())
            .filter(|miss| Some(miss.position) == furthest)
            .collect();
        // A container or constant mismatch is more helpful than another form's type mismatch.
        let chosen = best.iter().find(|miss| miss.misfit != Misfit::Type).or(best.first());
        let Some(&&miss) = chosen else { return };
        let others: Vec<Argument> = arguments
            .iter()
            .enumerate()
            .filter(|(at, _)| *at != miss.position)
            .map(|(_, other)| other.clone())
            .collect();
        self.literals_alone(&others);
        let Some(argument) = arguments.get(miss.position) else { return };
        if argument.literal.is_some() && miss.misfit == Misfit::Type {
            let expected = if best.len() == 1 { miss.formal.base } else { None };
            self.expr_as(argument.id, expected);
            return;
        }
        let mut expected: Vec<SmolStr> = best.iter().map(|miss| miss.formal.display(self.scope.db())).collect();
        expected.dedup();
        let kind = self.miss_kind(argument, miss, expected, callee);
        self.sink.report_with(argument.id, kind, RelatedRole::Declared, (callee.declared)());
    }

    /// Returns the types of a parameter and its argument with their files, if they are different user types with the
    /// same name.
    fn homonyms(&self, miss: MismatchedArgument<'_>, argument: &Argument) -> Option<[SmolStr; 2]> {
        let (expected, found) = (miss.formal.base?, argument.value.base);
        let is_homonym = self.scope.show(expected) == self.scope.show(found);
        is_homonym.then(|| self.scope.show_both([expected, found]))
    }

    fn miss_kind(
        &self,
        argument: &Argument,
        miss: MismatchedArgument<'_>,
        expected: Vec<SmolStr>,
        callee: &Callee<'_>,
    ) -> ProblemKind {
        let (name, parameter) = (callee.name.clone(), SmolStr::from(miss.formal.name));
        let found = argument.value.ty().display(self.scope.db());
        let base = self.scope.show(argument.value.base);
        let text = self.text(argument.id);
        match miss.misfit {
            Misfit::Type if let Some([expected, found]) = self.homonyms(miss, argument) => {
                ProblemKind::ArgumentType { callee: name, parameter, expected: vec![expected], found }
            }
            Misfit::Type
                if (miss.formal.shape == ArgumentForm::Value || miss.formal.shape == ArgumentForm::Reference)
                    && !is_counted(argument, &name) =>
            {
                ProblemKind::ArgumentType { callee: name, parameter, expected, found: base }
            }
            Misfit::Type => ProblemKind::ArgumentType { callee: name, parameter, expected, found },
            Misfit::Arm => {
                let expected = miss
                    .formal
                    .base
                    .map_or_else(SmolStr::default, |base| self.scope.show(base.on_arm(self.scope.arm())));
                ProblemKind::WrongArm { found: base, expected }
            }
            Misfit::Constant => ProblemKind::VariableExpected { callee: name, parameter },
            Misfit::Container => {
                let expected = expected.first().cloned().unwrap_or_default();
                ProblemKind::ContainerMismatch { callee: name, parameter, expected, found }
            }
            Misfit::IndexMissing if changes_one_dimension(argument, miss, &name) => {
                let expected = format_smolstr!("{base}{}", brackets(Container::Array { dims: 1 }));
                ProblemKind::ContainerMismatch { callee: name, parameter, expected, found }
            }
            Misfit::IndexMissing => ProblemKind::IndexMissing { name: text, ty: found },
            Misfit::IndexNotAllowed => ProblemKind::IndexNotAllowed { name: text, ty: found, callee: Some(name) },
        }
    }
}

/// Whether the argument is an array of several dimensions, for an instruction that only changes the size of arrays with
/// one dimension. An index would not help.
fn changes_one_dimension(argument: &Argument, miss: MismatchedArgument<'_>, callee: &str) -> bool {
    miss.formal.shape == ArgumentForm::Slot
        && matches!(argument.value.container(), Container::Array { dims: 2.. })
        && instructions::resizes(callee)
}

/// Whether the argument is an array whose number of elements is probably meant: `len` measures a string.
fn is_counted(argument: &Argument, callee: &str) -> bool {
    let is_array = |variable: &DeclaredVariable| matches!(variable.container, Container::Array { .. });
    callee == LEN && matches!(&argument.value.form, Form::Whole(variable) if is_array(variable) && !variable.single)
}

/// Returns the first argument that does not match `form`.
fn first_miss<'a>(arm: Option<Arm>, arguments: &[Argument], form: Formals<'a>) -> Option<MismatchedArgument<'a>> {
    arguments.iter().enumerate().find_map(|(position, argument)| {
        let formal = form.get(position)?;
        misfit(arm, argument, formal).map(|misfit| MismatchedArgument { position, formal, misfit })
    })
}
