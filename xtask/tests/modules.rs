//! Modules of a crate with the names that they define, import and use, without tests.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test may fail loudly")]

use std::collections::{BTreeMap, BTreeSet};

use camino::{Utf8Path, Utf8PathBuf};
use cargo_metadata::{Metadata, TargetKind};
use proc_macro2::{TokenStream, TokenTree};
use syn::visit::{self, Visit};

/// Names between the `::` of a path.
pub(crate) type Segments = Vec<String>;

pub(crate) type ModuleId = usize;

/// Modules of a crate. The first one is its root.
#[derive(Debug, Default)]
pub(crate) struct Crate {
    pub(crate) modules: Vec<Module>,
    /// Macros of the crate, each with the names of the items that its definition contains.
    pub(crate) macros: BTreeMap<String, BTreeSet<String>>,
}

#[derive(Debug, Default)]
pub(crate) struct Module {
    pub(crate) parent: ModuleId,
    pub(crate) file: Utf8PathBuf,
    pub(crate) children: BTreeMap<String, ModuleId>,
    pub(crate) items: BTreeSet<String>,
    /// Identifiers in macros and in macro calls, which may define items.
    pub(crate) macro_idents: BTreeSet<String>,
    /// Names of the macros that the module calls for its items.
    pub(crate) macro_calls: BTreeSet<String>,
    pub(crate) imports: Vec<Import>,
    pub(crate) globs: Vec<Segments>,
    pub(crate) paths: BTreeSet<Segments>,
}

/// A name that a `use` adds to the scope.
#[derive(Debug)]
pub(crate) struct Import {
    pub(crate) name: String,
    pub(crate) path: Segments,
    pub(crate) is_exported: bool,
}

/// Returns the roots of all crates: libraries and binaries.
pub(crate) fn roots(metadata: &Metadata) -> impl Iterator<Item = &Utf8Path> {
    let targets = metadata.workspace_packages().into_iter().flat_map(|package| &package.targets);
    let built = |kind: &TargetKind| matches!(kind, TargetKind::Lib | TargetKind::Bin);
    targets.filter(move |target| target.kind.iter().any(built)).map(|target| target.src_path.as_path())
}

/// Reads the crate with the root `file`.
pub(crate) fn read(file: &Utf8Path) -> Crate {
    let mut result = Crate::default();
    let items = parse(file);
    result.add(0, file.to_owned(), file.parent().unwrap().to_owned(), items);
    result
}

fn parse(file: &Utf8Path) -> Vec<syn::Item> {
    let text = std::fs::read_to_string(file).unwrap();
    syn::parse_file(&text).unwrap_or_else(|error| panic!("{file}: {error}")).items
}

/// Returns the file of the module whose submodules are in `folder`.
fn file_of(folder: &Utf8Path) -> Option<Utf8PathBuf> {
    [folder.with_extension("rs"), folder.join("mod.rs")].into_iter().find(|file| file.exists())
}

impl Crate {
    /// Adds a module of `file`, whose submodules are files of `folder`.
    fn add(&mut self, parent: ModuleId, file: Utf8PathBuf, folder: Utf8PathBuf, items: Vec<syn::Item>) -> ModuleId {
        let id = self.modules.len();
        self.modules.push(Module { parent, file, ..Module::default() });
        let mut calls = Vec::new();
        for item in items.into_iter().filter(|item| !is_test(attributes(item))) {
            match item {
                syn::Item::Mod(module) => self.add_child(id, &folder, module),
                item => {
                    self.add_item(id, &item);
                    if let syn::Item::Macro(call) = item {
                        calls.push(call.mac.tokens);
                    }
                }
            }
        }
        calls.into_iter().for_each(|tokens| self.add_listed(id, &folder, tokens));
        id
    }

    fn add_child(&mut self, parent: ModuleId, folder: &Utf8Path, module: syn::ItemMod) {
        let name = module.ident.to_string();
        if name == "tests" {
            return;
        }
        let inner = folder.join(&name);
        let id = match module.content {
            Some((_, items)) => self.add(parent, self.modules[parent].file.clone(), inner, items),
            None => {
                let file = file_of(&inner).unwrap_or_else(|| panic!("no file for {inner}"));
                let items = parse(&file);
                self.add(parent, file, inner, items)
            }
        };
        self.modules[parent].children.insert(name, id);
    }

    /// Adds the modules that a macro call lists by names of files in `folder`, or of its folders before brackets with such
    /// names.
    fn add_listed(&mut self, parent: ModuleId, folder: &Utf8Path, tokens: TokenStream) {
        let mut tokens = tokens.into_iter().peekable();
        while let Some(token) = tokens.next() {
            let TokenTree::Ident(name) = token else { continue };
            let inner = folder.join(name.to_string());
            let is_known = self.modules[parent].children.contains_key(&name.to_string());
            if let Some(file) = file_of(&inner).filter(|_| !is_known) {
                let items = parse(&file);
                let id = self.add(parent, file, inner, items);
                self.modules[parent].children.insert(name.to_string(), id);
            } else if inner.is_dir()
                && let Some(TokenTree::Group(group)) = tokens.peek()
            {
                let id = self.add(parent, self.modules[parent].file.clone(), inner.clone(), Vec::new());
                self.add_listed(id, &inner, group.stream());
                self.modules[parent].children.insert(name.to_string(), id);
            }
        }
    }

    fn add_item(&mut self, id: ModuleId, item: &syn::Item) {
        if let syn::Item::Macro(call) = item {
            add_idents(call.mac.tokens.clone(), &mut self.modules[id].macro_idents);
            if let Some(name) = &call.ident {
                add_definitions(call.mac.tokens.clone(), self.macros.entry(name.to_string()).or_default());
            }
            self.modules[id].macro_calls.extend(call.mac.path.segments.last().map(|name| name.ident.to_string()));
        }
        if let Some(name) = defined_name(item) {
            self.modules[id].items.insert(name.clone());
            if attributes(item).iter().any(|attribute| attribute.path().is_ident("macro_export")) {
                // The name is visible in the root, but defined in this module.
                let path = self.path(id).into_iter().chain([name.clone()]).collect();
                self.modules[0].imports.push(Import { name, path, is_exported: true });
            }
        }
        Names { module: &mut self.modules[id] }.visit_item(item);
    }

    /// Returns the path of a module, beginning with `crate`.
    fn path(&self, id: ModuleId) -> Segments {
        if id == 0 {
            return vec!["crate".to_owned()];
        }
        let parent = self.modules[id].parent;
        let name = self.modules[parent].children.iter().find(|(_, child)| **child == id);
        self.path(parent).into_iter().chain(name.map(|(name, _)| name.clone())).collect()
    }
}

fn attributes(item: &syn::Item) -> &[syn::Attribute] {
    match item {
        syn::Item::Const(item) => &item.attrs,
        syn::Item::Enum(item) => &item.attrs,
        syn::Item::Fn(item) => &item.attrs,
        syn::Item::Impl(item) => &item.attrs,
        syn::Item::Macro(item) => &item.attrs,
        syn::Item::Mod(item) => &item.attrs,
        syn::Item::Static(item) => &item.attrs,
        syn::Item::Struct(item) => &item.attrs,
        syn::Item::Trait(item) => &item.attrs,
        syn::Item::Type(item) => &item.attrs,
        syn::Item::Use(item) => &item.attrs,
        _ => &[],
    }
}

/// Whether an item exists only in tests.
fn is_test(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().filter(|attribute| attribute.path().is_ident("cfg")).any(|attribute| {
        let condition = attribute.meta.require_list().unwrap().tokens.to_string();
        condition.split(|c: char| !c.is_alphanumeric()).any(|word| word == "test") && !condition.contains("not")
    })
}

fn defined_name(item: &syn::Item) -> Option<String> {
    let name = match item {
        syn::Item::Const(item) => &item.ident,
        syn::Item::Enum(item) => &item.ident,
        syn::Item::Fn(item) => &item.sig.ident,
        syn::Item::Macro(item) => item.ident.as_ref()?,
        syn::Item::Static(item) => &item.ident,
        syn::Item::Struct(item) => &item.ident,
        syn::Item::Trait(item) => &item.ident,
        syn::Item::Type(item) => &item.ident,
        syn::Item::Union(item) => &item.ident,
        _ => return None,
    };
    Some(name.to_string())
}

/// Adds the names of items that the tokens of a macro's definition define.
fn add_definitions(tokens: TokenStream, names: &mut BTreeSet<String>) {
    let mut defines = false;
    for token in tokens {
        match &token {
            TokenTree::Ident(word) if defines => _ = names.insert(word.to_string()),
            TokenTree::Group(group) => add_definitions(group.stream(), names),
            _ => {}
        }
        defines = matches!(&token, TokenTree::Ident(word) if ["const", "enum", "fn", "static", "struct"].iter().any(|kind| word == kind));
    }
}

fn add_idents(tokens: TokenStream, idents: &mut BTreeSet<String>) {
    for token in tokens {
        match token {
            TokenTree::Ident(ident) => drop(idents.insert(ident.to_string())),
            TokenTree::Group(group) => add_idents(group.stream(), idents),
            _ => {}
        }
    }
}

/// Collects an item's paths and imports.
struct Names<'a> {
    module: &'a mut Module,
}

impl<'ast> Visit<'ast> for Names<'_> {
    fn visit_path(&mut self, path: &'ast syn::Path) {
        if path.leading_colon.is_none() {
            self.module.paths.insert(path.segments.iter().map(|segment| segment.ident.to_string()).collect());
        }
        visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, call: &'ast syn::Macro) {
        visit::visit_macro(self, call);
        self.add_token_paths(call.tokens.clone());
    }

    fn visit_attribute(&mut self, attribute: &'ast syn::Attribute) {
        if let syn::Meta::List(list) = &attribute.meta {
            self.add_token_paths(list.tokens.clone());
        }
    }

    fn visit_impl_item(&mut self, item: &'ast syn::ImplItem) {
        let is_test = matches!(item, syn::ImplItem::Fn(function) if is_test(&function.attrs));
        if !is_test {
            visit::visit_impl_item(self, item);
        }
    }

    fn visit_item_use(&mut self, item: &'ast syn::ItemUse) {
        if item.leading_colon.is_none() {
            let is_exported = !matches!(item.vis, syn::Visibility::Inherited);
            self.add_imports(&mut Vec::new(), &item.tree, is_exported);
        }
    }
}

impl Names<'_> {
    fn add_imports(&mut self, prefix: &mut Segments, tree: &syn::UseTree, is_exported: bool) {
        match tree {
            syn::UseTree::Path(path) => {
                prefix.push(path.ident.to_string());
                self.add_imports(prefix, &path.tree, is_exported);
                prefix.pop();
            }
            syn::UseTree::Name(name) => self.add_import(prefix, &name.ident, &name.ident, is_exported),
            syn::UseTree::Rename(rename) => self.add_import(prefix, &rename.ident, &rename.rename, is_exported),
            syn::UseTree::Glob(_) => self.module.globs.push(prefix.clone()),
            syn::UseTree::Group(group) => {
                group.items.iter().for_each(|tree| self.add_imports(prefix, tree, is_exported));
            }
        }
    }

    fn add_import(&mut self, prefix: &[String], last: &syn::Ident, name: &syn::Ident, is_exported: bool) {
        let mut path = prefix.to_vec();
        let mut name = name.to_string();
        if last == "self" {
            name = if name == "self" { path.last().unwrap().clone() } else { name };
        } else {
            path.push(last.to_string());
        }
        self.module.imports.push(Import { name, path, is_exported });
    }

    /// Adds the paths in the tokens of a macro: names that are joined by `::`, except fields and methods.
    fn add_token_paths(&mut self, tokens: TokenStream) {
        let mut path = Segments::new();
        let mut before = String::new();
        for token in tokens {
            let text = match &token {
                TokenTree::Ident(ident) => ident.to_string(),
                TokenTree::Punct(punct) => punct.as_char().to_string(),
                _ => String::new(),
            };
            let is_name = matches!(token, TokenTree::Ident(_));
            if is_name && before == "::" {
                path.push(text.clone());
            } else if is_name || text != ":" {
                self.module.paths.extend((!path.is_empty()).then(|| std::mem::take(&mut path)));
                path.extend((is_name && before != ".").then(|| text.clone()));
            }
            if let TokenTree::Group(group) = token {
                self.add_token_paths(group.stream());
            }
            before = if text == ":" && before == ":" { "::".to_owned() } else { text };
        }
        self.module.paths.extend((!path.is_empty()).then_some(path));
    }
}
