//! Functions outside of tests: a closure with a name fits on its line, a parameter is no tuple, and a check whose name reads
//! as a question returns the answer.

#![allow(clippy::unwrap_used, reason = "a test may fail loudly")]

use std::collections::BTreeSet;

use cargo_metadata::MetadataCommand;
use syn::spanned::Spanned as _;
use syn::visit::{self, Visit};
use syn::{
    Attribute, Expr, FnArg, ImplItemFn, Item, ItemFn, Local, Meta, Pat, ReturnType, Signature, TraitItemFn, Type,
};

use crate::modules;

/// First words of names that read as a question.
const QUESTIONS: &[&str] = &["is_", "has_", "can_", "are_"];

/// Faults of a file, each with its line.
#[derive(Debug, Default)]
struct Faults(Vec<(usize, String)>);

impl Faults {
    fn of(text: &str) -> Vec<(usize, String)> {
        let mut faults = Self::default();
        faults.visit_file(&syn::parse_file(text).unwrap());
        faults.0
    }

    fn check_signature(&mut self, signature: &Signature) {
        let name = signature.ident.to_string();
        let line = signature.ident.span().start().line;
        if signature.inputs.iter().any(is_tuple) {
            self.0.push((line, format!("{name}: a tuple as a parameter")));
        }
        if QUESTIONS.iter().any(|question| name.starts_with(question)) && returns_no_answer(&signature.output) {
            self.0.push((line, format!("{name}: a question without an answer")));
        }
    }
}

impl<'a> Visit<'a> for Faults {
    fn visit_item(&mut self, item: &'a Item) {
        let attributes = match item {
            Item::Mod(module) => &module.attrs,
            Item::Fn(function) => &function.attrs,
            _ => return visit::visit_item(self, item),
        };
        if !attributes.iter().any(is_for_tests) {
            visit::visit_item(self, item);
        }
    }

    fn visit_item_fn(&mut self, function: &'a ItemFn) {
        self.check_signature(&function.sig);
        visit::visit_item_fn(self, function);
    }

    fn visit_impl_item_fn(&mut self, function: &'a ImplItemFn) {
        self.check_signature(&function.sig);
        visit::visit_impl_item_fn(self, function);
    }

    fn visit_trait_item_fn(&mut self, function: &'a TraitItemFn) {
        self.check_signature(&function.sig);
        visit::visit_trait_item_fn(self, function);
    }

    fn visit_local(&mut self, local: &'a Local) {
        let is_closure = local.init.as_ref().is_some_and(|init| matches!(*init.expr, Expr::Closure(_)));
        let (start, end) = (local.span().start().line, local.span().end().line);
        if is_closure && end > start {
            self.0.push((start, "a closure with a name, longer than a line".to_owned()));
        }
        visit::visit_local(self, local);
    }
}

/// Whether an item with this attribute exists only in tests: `#[test]`, `#[cfg(test)]`, `#[cfg(all(test, …))]`.
fn is_for_tests(attribute: &Attribute) -> bool {
    match &attribute.meta {
        Meta::Path(path) => path.is_ident("test"),
        Meta::List(list) if list.path.is_ident("cfg") => {
            list.tokens.to_string().split(|letter: char| !letter.is_alphanumeric()).any(|word| word == "test")
        }
        _ => false,
    }
}

/// Whether a parameter is several ones in a pair of brackets: `(a, b): (A, B)`.
fn is_tuple(parameter: &FnArg) -> bool {
    let FnArg::Typed(parameter) = parameter else { return false };
    let ty = match &*parameter.ty {
        Type::Reference(reference) => &reference.elem,
        _ => &parameter.ty,
    };
    matches!((&*parameter.pat, &**ty), (Pat::Tuple(_), Type::Tuple(_)))
}

/// Whether a function returns nothing, or `Result<(), …>`.
fn returns_no_answer(output: &ReturnType) -> bool {
    let ReturnType::Type(_, output) = output else { return true };
    let Type::Path(path) = &**output else { return false };
    let last = path.path.segments.last().unwrap();
    let syn::PathArguments::AngleBracketed(arguments) = &last.arguments else { return false };
    let is_unit = |argument: &syn::GenericArgument| matches!(argument, syn::GenericArgument::Type(Type::Tuple(unit)) if unit.elems.is_empty());
    last.ident == "Result" && arguments.args.first().is_some_and(is_unit)
}

#[test]
fn functions_have_the_shapes_of_the_project() {
    let metadata = MetadataCommand::new().no_deps().exec().unwrap();
    let crates = modules::roots(&metadata).map(modules::read);
    let files: BTreeSet<_> = crates.flat_map(|read| read.modules).map(|module| module.file).collect();
    // Rules and instructions are modules that macros declare.
    let names: BTreeSet<_> = files.iter().filter_map(|file| file.file_name()).collect();
    assert!(names.is_superset(&BTreeSet::from(["unused_parameter.rs", "get_latch.rs"])));
    let mut faults = Vec::new();
    for file in &files {
        let path = file.strip_prefix(&metadata.workspace_root).unwrap();
        let found = Faults::of(&std::fs::read_to_string(file).unwrap());
        faults.extend(found.into_iter().map(|(line, fault)| format!("{path}:{line}: {fault}\n")));
    }
    assert!(faults.is_empty(), "{}", faults.concat());
}

#[test]
fn faults_are_found_outside_of_tests() {
    let text = "
fn is_valid((a, b): (A, B)) -> Result<(), E> {
    let short = |x| x + 1;
    let long = |x| {
        short(x)
    };
}
fn is_known() -> Result<bool, E> {}
#[cfg(test)]
mod tests {
    fn has_tests((a, b): (A, B)) {}
}
";
    let lines: Vec<_> = Faults::of(text).into_iter().map(|(line, fault)| format!("{line} {fault}")).collect();
    let expected = [
        "2 is_valid: a tuple as a parameter",
        "2 is_valid: a question without an answer",
        "4 a closure with a name, longer than a line",
    ];
    assert_eq!(lines, expected);
}
