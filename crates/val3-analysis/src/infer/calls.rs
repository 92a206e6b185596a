//! Inference of instruction calls, including add-on instructions.

use smallvec::SmallVec;
use smol_str::{SmolStr, format_smolstr};
use val3_lang::add_on::AddOnOverload;
use val3_lang::instruction::{Availability, CallClass, Instruction, Overload};
use val3_lang::instructions;
use val3_lang::types::BaseType;

use super::arguments::{Callee, MatchingForms};
use super::fit::Formals;
use super::value::InferredValue;
use super::{AddOnCall, Infer, InstructionCall};
use crate::body::{Expr, ExprId};
use crate::problem::ProblemKind;
use crate::ty::{Base, Ty};

/// Result type and class of a form.
type Outcome = (Option<BaseType>, CallClass);

/// Result of resolving a call.
struct ResolvedCall {
    /// Result type; `None` if the call returns no value.
    result: Option<Base>,
    class: CallClass,
}

impl Infer<'_> {
    /// Infers a call whose value is used.
    pub(super) fn call_value(&mut self, id: ExprId, callee: ExprId, args: &[ExprId]) -> InferredValue {
        match self.call(id, callee, args) {
            Some(ResolvedCall { result: Some(base), .. }) => InferredValue::computed(base),
            Some(ResolvedCall { result: None, .. }) => {
                let callee = self.text(callee);
                self.report(id, ProblemKind::NoValue { callee });
                InferredValue::UNKNOWN
            }
            None => InferredValue::UNKNOWN,
        }
    }

    /// Infers a call as a statement: it must have an effect.
    pub(super) fn instruction_stmt(&mut self, id: ExprId, callee: ExprId, args: &[ExprId]) {
        if let Some(called) = self.call(id, callee, args) {
            self.table.set_type(id, called.result.map_or(Ty::UNKNOWN, Ty::element));
            if called.class == CallClass::Function {
                self.report(id, ProblemKind::NoEffect);
            }
        }
    }

    /// Infers any instruction call; `None` if it has a fault.
    fn call(&mut self, id: ExprId, callee: ExprId, args: &[ExprId]) -> Option<ResolvedCall> {
        match self.body.expr(callee) {
            Expr::Name(name) => {
                let name = name.clone();
                self.instruction(id, callee, &name, None, args)
            }
            Expr::Path { library, item } => {
                let (library, item) = (library.clone(), item.clone());
                if !self.scope.has_library(&library) {
                    let interface = self.scope.interface(&library);
                    self.resolved(callee, interface);
                    self.arguments_alone(args);
                    return None;
                }
                self.instruction(id, callee, &item, Some(&library), args)
            }
            _ => {
                self.expr(callee);
                self.arguments_alone(args);
                None
            }
        }
    }

    pub(super) fn arguments_alone(&mut self, args: &[ExprId]) {
        for arg in args {
            self.expr_as(*arg, Some(Base::Unknown));
        }
    }

    fn instruction(
        &mut self,
        id: ExprId,
        callee: ExprId,
        name: &SmolStr,
        library: Option<&SmolStr>,
        args: &[ExprId],
    ) -> Option<ResolvedCall> {
        if name.starts_with('$') {
            return self.add_on_instruction(id, callee, name, library.is_some(), args);
        }
        let found = instructions::find(name)
            .filter(|found| found.overloads.iter().any(|form| form.on_library == library.is_some()));
        match found {
            Some(instruction) => self.known_instruction(id, callee, instruction, library.is_some(), args),
            None => {
                self.arguments_alone(args);
                self.report(callee, self.scope.unknown_instruction(name, library));
                None
            }
        }
    }

    fn known_instruction(
        &mut self,
        id: ExprId,
        callee: ExprId,
        instruction: &'static Instruction,
        on_library: bool,
        args: &[ExprId],
    ) -> Option<ResolvedCall> {
        let forms = forms(instruction, on_library);
        let chosen = self.form_of_catalogue(id, callee, instruction, &forms, args);
        self.outcome(&chosen, &outcomes(&forms))
    }

    /// Matches the arguments against the forms of an instruction, and records the call.
    fn form_of_catalogue(
        &mut self,
        id: ExprId,
        callee: ExprId,
        instruction: &'static Instruction,
        forms: &[&'static Overload],
        args: &[ExprId],
    ) -> MatchingForms {
        let lines = || signatures(instruction, forms);
        let callee = Callee {
            name: self.text(callee),
            forms: forms.iter().map(|form| Formals::Instruction(form.params)).collect(),
            lines: &lines,
            declared: &|| None,
            may_have_others: matches!(instruction.availability, Availability::AddOn(_)),
        };
        let chosen = self.arguments(id, args, &callee);
        let form = if let MatchingForms::Form(index) = chosen { forms.get(index).copied() } else { None };
        self.table.add_call(InstructionCall { id, instruction, form });
        chosen
    }

    /// Returns the result of a call. If several forms or no form match, returns the result if all of them agree.
    fn outcome(&self, chosen: &MatchingForms, outcomes: &[Outcome]) -> Option<ResolvedCall> {
        let mut possible: SmallVec<[Outcome; 4]> = match chosen {
            MatchingForms::Form(index) => outcomes.get(*index).copied().into_iter().collect(),
            MatchingForms::Several(indexes) => {
                indexes.iter().filter_map(|index| outcomes.get(*index).copied()).collect()
            }
            MatchingForms::None => outcomes.into(),
        };
        possible.dedup();
        let [(result, class)] = possible.as_slice() else { return None };
        Some(ResolvedCall { result: result.map(|ty| Base::of(ty).on_arm(self.scope.arm())), class: *class })
    }

    /// Resolves an instruction that only an add-on provides, by the add-on's table in the cell.
    fn add_on_instruction(
        &mut self,
        id: ExprId,
        callee: ExprId,
        name: &SmolStr,
        on_library: bool,
        args: &[ExprId],
    ) -> Option<ResolvedCall> {
        let mut forms = self.scope.add_on_forms(name, on_library);
        if forms.is_empty() {
            if let Some(ty) = self.scope.stand_in_type(name) {
                self.report(callee, self.scope.missing_add_on(name, Vec::new()));
                self.arguments_alone(args);
                return Some(ResolvedCall { result: Some(Base::of(ty)), class: CallClass::Modifier });
            }
            forms = self.scope.stand_in_forms(name, on_library);
            if forms.is_empty() {
                return self.resolve_by_catalogue(id, callee, name, on_library, args);
            }
            self.report(callee, self.scope.missing_add_on(name, Vec::new()));
        }
        let lines = || forms.iter().map(|form| add_on_line(name, form)).collect();
        let formals = forms.iter().map(|form| Formals::AddOn(&form.params)).collect();
        let callee = Callee {
            name: self.text(callee),
            forms: formals,
            lines: &lines,
            declared: &|| None,
            may_have_others: false,
        };
        let chosen = self.arguments(id, args, &callee);
        if let MatchingForms::Form(index) = chosen
            && let Some(&form) = forms.get(index)
        {
            self.table.add_add_on_call(AddOnCall { id, name: name.clone(), form: form.clone() });
        }
        let outcomes: SmallVec<[Outcome; 4]> = forms.iter().map(|form| (form.result, form.class)).collect();
        self.outcome(&chosen, &outcomes)
    }

    /// Resolves an add-on instruction without a table by the forms of the catalogue, which the virtual controller
    /// executes. The installed add-on may have other forms, so a mismatch is only mentioned.
    fn resolve_by_catalogue(
        &mut self,
        id: ExprId,
        callee: ExprId,
        name: &SmolStr,
        on_library: bool,
        args: &[ExprId],
    ) -> Option<ResolvedCall> {
        let Some(instruction) = instructions::find(name) else {
            self.report(callee, self.scope.missing_add_on(name, Vec::new()));
            self.arguments_alone(args);
            return None;
        };
        let forms = forms(instruction, on_library);
        let chosen = self.form_of_catalogue(id, callee, instruction, &forms, args);
        let others = if let MatchingForms::None = chosen { signatures(instruction, &forms) } else { Vec::new() };
        self.report(callee, self.scope.missing_add_on(name, others));
        if self.table.retract_without_form(id) {
            return None;
        }
        self.outcome(&chosen, &outcomes(&forms))
            .filter(|called| called.result.is_some())
            .map(|called| ResolvedCall { class: CallClass::Modifier, ..called })
    }
}

/// Returns the forms that are called on a library identifier, or the other forms.
fn forms(instruction: &'static Instruction, on_library: bool) -> SmallVec<[&'static Overload; 4]> {
    instruction.overloads.iter().filter(|form| form.on_library == on_library).collect()
}

fn signatures(instruction: &Instruction, forms: &[&Overload]) -> Vec<SmolStr> {
    forms.iter().map(|form| form.signature(instruction.name).into()).collect()
}

fn outcomes(forms: &[&Overload]) -> SmallVec<[Outcome; 4]> {
    forms.iter().map(|form| (form.result, form.class)).collect()
}

/// Formats a syntax line, for example `num $fileOpen(string s1, num& n2[])`.
fn add_on_line(name: &str, form: &AddOnOverload) -> SmolStr {
    let params: Vec<String> = form
        .params
        .iter()
        .map(|param| {
            let ty = param.ty.map_or("any type", BaseType::name);
            let reference = if param.shape.is_by_reference() { "&" } else { "" };
            format!("{ty}{reference} {}", param.name)
        })
        .collect();
    let result = form.result.map_or("void", BaseType::name);
    format_smolstr!("{result} {name}({})", params.join(", "))
}
