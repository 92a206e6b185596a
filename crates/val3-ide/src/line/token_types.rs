//! Type inference from tokens in an incomplete line, for completion and signature help.

use val3_analysis::db::{Db, File, Project};
use val3_analysis::items::program::{Header, header};
use val3_analysis::items::project::{Items, Signature, fields, items, resolve_type, signature};
use val3_analysis::ty::{Base, Ty};
use val3_lang::instruction::Overload;
use val3_lang::types::{BaseType, Container, field};
use val3_lang::{builtins, enumerations, instructions};
use val3_syntax::SyntaxKind::*;
use val3_syntax::{SyntaxToken, TextSlice};

use super::call::{CallSite, Callee};
use super::open_bracket;
use crate::variables::declares_variable;

/// Names visible in a program.
pub(crate) struct VisibleNames<'db> {
    pub(crate) db: &'db dyn Db,
    pub(crate) project: Project,
    pub(crate) items: &'db Items,
    pub(crate) header: &'db Header,
}

impl<'db> VisibleNames<'db> {
    /// Names visible in the program in `file`, resolved in `project`.
    pub(crate) fn new(db: &'db dyn Db, project: Project, file: File) -> Self {
        Self { db, project, items: items(db, project), header: header(db, file) }
    }

    /// Type of the operand at the end of the tokens: a variable with its indexes and fields, a call, or a literal.
    pub(crate) fn ty(&self, tokens: &[SyntaxToken]) -> Ty {
        let Some((last, before)) = tokens.split_last() else { return Ty::UNKNOWN };
        match last.kind() {
            NUMBER => Ty::of(BaseType::Num),
            STRING => Ty::of(BaseType::String),
            TRUE_KW | FALSE_KW => Ty::of(BaseType::Bool),
            IDENT => self.name(before, last.text()),
            R_BRACK => {
                let base = open_bracket(before).and_then(|open| before.get(..open)).map(|base| self.ty(base).base);
                Ty::element(base.unwrap_or(Base::Unknown))
            }
            R_PAREN => open_bracket(before).map_or(Ty::UNKNOWN, |open| self.parentheses(tokens, open)),
            _ => Ty::UNKNOWN,
        }
    }

    /// Type of a name, of `field` in `base.field`, or of `item` in `library:item`.
    fn name(&self, before: &[SyntaxToken], name: &str) -> Ty {
        match before.split_last() {
            Some((dot, base)) if dot.kind() == DOT => self.field(self.ty(base).base, name),
            Some((colon, library)) if colon.kind() == COLON => {
                library.last().map_or(Ty::UNKNOWN, |library| self.library_item(library.text(), name))
            }
            _ => self.variable(name),
        }
    }

    fn field(&self, base: Base, name: &str) -> Ty {
        match base {
            Base::Builtin(ty, arm) => {
                let arm = arm.or(self.items.arm);
                field(ty, arm, name).map_or(Ty::UNKNOWN, |field| Ty::element(Base::of(field.ty).on_arm(arm)))
            }
            Base::User(project) => fields(self.db, project).get(name).map_or(Ty::UNKNOWN, |item| Ty {
                base: item.base,
                container: shape(item.decl.container, &item.decl.sizes),
            }),
            Base::Unknown => Ty::UNKNOWN,
        }
    }

    fn library_item(&self, library: &str, name: &str) -> Ty {
        let interface = self.interface(library).map(|interface| items(self.db, interface));
        let item = interface.and_then(|items| items.data.get(name));
        item.map_or(Ty::UNKNOWN, |item| Ty { base: item.base, container: shape(item.decl.container, &item.decl.sizes) })
    }

    /// Type of the variable, constant or enumerator `name`.
    pub(crate) fn variable(&self, name: &str) -> Ty {
        let base = |name: &str| resolve_type(&self.items.types, name).unwrap_or(Base::Unknown).on_arm(self.items.arm);
        if let Some(local) = self.header.locals.iter().find(|local| local.name == name) {
            return Ty { base: base(&local.type_name), container: shape(local.container, &local.sizes) };
        }
        if let Some(param) = self.header.params.iter().find(|param| param.name == name) {
            return Ty { base: base(&param.type_name), container: param.container };
        }
        if let Some(item) = self.items.data.get(name) {
            return Ty { base: item.base, container: shape(item.decl.container, &item.decl.sizes) };
        }
        let builtin = builtins::find(name).map(|builtin| Ty::of(builtin.ty));
        builtin.or_else(|| enumerations::find(name).map(|found| Ty::of(found.ty))).unwrap_or(Ty::UNKNOWN)
    }

    /// Type of `( … )` or an instruction call.
    fn parentheses(&self, tokens: &[SyntaxToken], open: usize) -> Ty {
        let Some(call) = CallSite::at_bracket(tokens, open) else {
            return self.ty(tokens.part(open + 1..tokens.len() - 1));
        };
        let result = self.form(&call, usize::MAX).and_then(|form| form.result);
        result.map_or(Ty::UNKNOWN, |result| Ty::element(Base::of(result).on_arm(self.items.arm)))
    }

    /// Form of an instruction that fits the arguments before `index`.
    pub(crate) fn form(&self, call: &CallSite<'_>, index: usize) -> Option<&'static Overload> {
        self.forms(call, index).first().copied()
    }

    /// Forms of an instruction that fit the arguments before `index` and have a parameter there. If none fits, the
    /// first form with enough parameters.
    pub(crate) fn forms(&self, call: &CallSite<'_>, index: usize) -> Vec<&'static Overload> {
        let Some(instruction) = instructions::find(&call.callee.name) else { return Vec::new() };
        let types: Vec<Ty> = call.arguments.iter().take(index).map(|argument| self.ty(argument)).collect();
        let is_on_library = call.callee.library.is_some();
        let forms = instruction.overloads.iter().filter(|form| form.on_library == is_on_library);
        let forms = forms.filter(|form| index == usize::MAX || form.params.len() > index);
        let suiting: Vec<&Overload> = forms.clone().filter(|form| accepts(form, &types)).collect();
        if suiting.is_empty() { forms.take(1).collect() } else { suiting }
    }

    /// Declared array sizes: of a variable, a library item, or a field of a user type.
    pub(crate) fn sizes(&self, tokens: &[SyntaxToken]) -> Option<Vec<u32>> {
        let (name, before) = tokens.split_last().filter(|(name, _)| name.kind() == IDENT)?;
        let name = name.text();
        match before.split_last() {
            Some((dot, base)) if dot.kind() == DOT => {
                let Base::User(project) = self.ty(base).base else { return None };
                fields(self.db, project).get(name).map(|item| item.decl.sizes.clone())
            }
            Some((colon, library)) if colon.kind() == COLON => {
                let interface = self.interface(library.last()?.text())?;
                items(self.db, interface).data.get(name).map(|item| item.decl.sizes.clone())
            }
            _ if self.header.params.iter().any(|param| param.name == name) => None,
            _ => {
                let local = self.header.locals.iter().find(|local| local.name == name);
                let data = || self.items.data.get(name).map(|item| item.decl.sizes.clone());
                local.map(|local| local.sizes.clone()).or_else(data)
            }
        }
    }

    /// Whether a variable, program, library identifier or user type has this name.
    pub(crate) fn is_declared(&self, name: &str) -> bool {
        declares_variable(self.header, name)
            || self.items.data.contains_key(name)
            || self.items.programs.contains_key(name)
            || self.items.libraries.contains_key(name)
            || self.items.types.contains_key(name)
    }

    /// Interface project of a library identifier.
    pub(crate) fn interface(&self, library: &str) -> Option<Project> {
        self.items.libraries.get(library)?.interface
    }

    /// Program of a callee, with its project.
    pub(crate) fn program(&self, callee: &Callee) -> Option<(Project, File)> {
        let project = match &callee.library {
            Some(library) => self.interface(library)?,
            None => self.project,
        };
        Some((project, *items(self.db, project).programs.get(callee.name.as_str())?))
    }

    /// Signature of the callee's program.
    pub(crate) fn signature(&self, callee: &Callee) -> Option<&'db Signature> {
        self.program(callee).map(|(project, file)| signature(self.db, project, file))
    }
}

/// Whether the arguments may have the types of the form's first parameters.
fn accepts(form: &Overload, types: &[Ty]) -> bool {
    form.params.iter().zip(types).all(|(param, ty)| param.ty.is_none_or(|wanted| ty.base.same_as(Base::of(wanted))))
}

/// Container of a variable. A single value is declared as an array of size 1.
fn shape(container: Container, sizes: &[u32]) -> Container {
    if sizes == [1] { Container::Element } else { container }
}
