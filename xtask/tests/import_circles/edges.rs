//! Dependencies between files: for each file, the items that it names in other files.

use std::collections::{BTreeMap, BTreeSet};

use camino::Utf8PathBuf;

use crate::modules::{Crate, Module, ModuleId, Segments};

/// For each file, the files whose items it names, with the paths by which it names them.
pub(crate) type Edges = BTreeMap<Utf8PathBuf, BTreeMap<Utf8PathBuf, BTreeSet<String>>>;

/// Returns the edges between the files of a crate. A mere re-export or `mod` causes none.
pub(crate) fn edges(krate: &Crate) -> Edges {
    let mut edges = Edges::new();
    for (id, module) in krate.modules.iter().enumerate() {
        for path in module.imports.iter().map(|import| &import.path).chain(&module.paths) {
            let is_found = !is_local(module, path) || !resolve(krate, id, path).is_empty();
            assert!(is_found, "{} names {}: not found", module.file, path.join("::"));
        }
        let imports = module.imports.iter().filter(|import| !import.is_exported).map(|import| &import.path);
        let imports = imports.map(|path| (path, resolve(krate, id, path)));
        // If an import names both a module and an item, its uses determine which one is meant.
        let imports = imports.filter(|(_, targets)| !targets.iter().any(|target| matches!(target, Target::Module(_))));
        let paths = module.paths.iter().map(|path| (path, resolve(krate, id, path)));
        for (path, targets) in imports.chain(paths) {
            let definers = targets.into_iter().filter_map(|target| match target {
                Target::Item(definer) => Some(&krate.modules[definer].file),
                Target::Module(_) | Target::Foreign => None,
            });
            for file in definers.filter(|file| **file != module.file) {
                let names = edges.entry(module.file.clone()).or_default().entry(file.clone()).or_default();
                names.insert(path.join("::"));
            }
        }
    }
    edges
}

/// Whether a path certainly begins in this crate.
fn is_local(module: &Module, path: &[String]) -> bool {
    let first = &path[0];
    ["crate", "super", "self"].contains(&first.as_str()) || module.children.contains_key(first)
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Target {
    Module(ModuleId),
    /// An item, by the module that defines it.
    Item(ModuleId),
    /// An item that is imported from another crate.
    Foreign,
}

/// Returns the module or the first item that a path in `module` names. Empty if it is in another crate.
fn resolve(krate: &Crate, module: ModuleId, path: &[String]) -> BTreeSet<Target> {
    resolve_path(krate, module, path, &mut BTreeSet::new())
}

/// Names that are being looked up, to stop at circular imports.
type Open = BTreeSet<(ModuleId, String)>;

fn resolve_path(krate: &Crate, module: ModuleId, path: &[String], open: &mut Open) -> BTreeSet<Target> {
    let Some((first, rest)) = path.split_first() else { return BTreeSet::new() };
    let targets = match first.as_str() {
        "crate" => BTreeSet::from([Target::Module(0)]),
        "self" => BTreeSet::from([Target::Module(module)]),
        "super" => BTreeSet::from([Target::Module(krate.modules[module].parent)]),
        name => lookup(krate, module, name, open),
    };
    follow(krate, targets, rest, open)
}

fn follow(krate: &Crate, targets: BTreeSet<Target>, rest: &[String], open: &mut Open) -> BTreeSet<Target> {
    let Some((name, rest)) = rest.split_first() else { return targets };
    let modules = targets.iter().filter_map(|target| match target {
        Target::Module(module) => Some(*module),
        Target::Item(_) | Target::Foreign => None,
    });
    let mut found = BTreeSet::new();
    for module in modules {
        let next = match name.as_str() {
            "super" => BTreeSet::from([Target::Module(krate.modules[module].parent)]),
            name => lookup(krate, module, name, open),
        };
        found.extend(follow(krate, next, rest, open));
    }
    if found.is_empty() {
        targets.into_iter().filter(|target| !matches!(target, Target::Module(_))).collect()
    } else {
        found
    }
}

/// Returns the meaning of `name` in a module.
fn lookup(krate: &Crate, id: ModuleId, name: &str, open: &mut Open) -> BTreeSet<Target> {
    let module = &krate.modules[id];
    let mut found = BTreeSet::new();
    found.extend(module.items.contains(name).then_some(Target::Item(id)));
    found.extend(module.children.get(name).map(|child| Target::Module(*child)));
    let key = (id, name.to_owned());
    // While `use a::a` is followed, `a` is the module.
    if !open.insert(key.clone()) {
        return found;
    }
    for import in module.imports.iter().filter(|import| import.name == name) {
        let targets = resolve_path(krate, id, &import.path, open);
        let is_foreign = targets.is_empty() && !is_local(module, &import.path);
        found.extend(targets);
        found.extend(is_foreign.then_some(Target::Foreign));
    }
    if found.is_empty() {
        let globs = module.globs.iter();
        found = globs.flat_map(|glob| lookup_in_glob(krate, id, glob, name, open)).collect();
    }
    if found.is_empty() {
        let mut macros = module.macro_calls.iter().filter_map(|name| krate.macros.get(name));
        let is_defined = module.macro_idents.contains(name) || macros.any(|items| items.contains(name));
        found.extend(is_defined.then_some(Target::Item(id)));
    }
    open.remove(&key);
    found
}

fn lookup_in_glob(krate: &Crate, id: ModuleId, glob: &Segments, name: &str, open: &mut Open) -> BTreeSet<Target> {
    let path: Segments = glob.iter().cloned().chain([name.to_owned()]).collect();
    let modules = resolve_path(krate, id, glob, open);
    // Enum variants are not looked up, because the path before the `*` already names the enum.
    if modules.iter().any(|target| matches!(target, Target::Module(_))) {
        resolve_path(krate, id, &path, open)
    } else {
        BTreeSet::new()
    }
}
