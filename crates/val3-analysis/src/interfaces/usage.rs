//! Uses of library identifiers in a program.

use rustc_hash::FxHashSet;
use smol_str::SmolStr;
use val3_lang::instructions;
use val3_lang::operators::BinaryOp;
use val3_syntax::TextRange;

use crate::body::{Body, Expr, ExprId, body};
use crate::db::{Db, File};

/// Library items that a program uses, and libraries that it loads.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct LibraryUses {
    /// Identifier and item of every `library:item`, without instructions on the identifier.
    pub items: FxHashSet<(SmolStr, SmolStr)>,
    /// Items whose existence is tested: `isDefined(library:item)`, `library:libExist("item")`.
    pub guarded: FxHashSet<(SmolStr, SmolStr)>,
    /// All `library:libLoad(…)` calls.
    pub loads: Vec<Load>,
    /// Paths in `library:libSave(…)` and `libSave(…)`.
    pub saves: Vec<LoadedPath>,
}

/// A `library:libLoad(…)`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Load {
    /// Library identifier.
    pub alias: SmolStr,
    /// Constant part of the path.
    pub path: LoadedPath,
    /// Range of the path argument.
    pub range: TextRange,
}

/// Constant part of a library's path.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum LoadedPath {
    /// The entire path.
    Whole(SmolStr),
    /// A prefix of the path.
    Prefix {
        /// Prefix.
        text: SmolStr,
        /// Range of the prefix.
        range: TextRange,
    },
    /// No constant part.
    Unknown,
}

/// Returns the uses of library identifiers in the program in `file`.
#[salsa::tracked]
pub fn uses(db: &dyn Db, file: File) -> LibraryUses {
    let body = body(db, file);
    let mut uses = LibraryUses::default();
    for (_, expr, _) in body.exprs() {
        match expr {
            Expr::Path { library, item } if !is_instruction(item) => {
                uses.items.insert((library.clone(), item.clone()));
            }
            Expr::Call(callee, args) => call(body, *callee, args, &mut uses),
            _ => {}
        }
    }
    uses
}

/// Whether the item is an instruction on the library identifier, for example `library:libLoad`, instead of a library
/// item.
pub(super) fn is_instruction(item: &str) -> bool {
    item.starts_with('$')
        || instructions::find(item).is_some_and(|found| found.overloads.iter().any(|form| form.on_library))
}

fn call(body: &Body, callee: ExprId, args: &[ExprId], uses: &mut LibraryUses) {
    match (body.expr(callee), args.first()) {
        (Expr::Path { library, item }, Some(first)) if item == instructions::LIB_LOAD => {
            let load = Load { alias: library.clone(), path: path(body, *first), range: body.range(*first) };
            uses.loads.push(load);
        }
        (Expr::Path { item: name, .. } | Expr::Name(name), Some(first)) if name == instructions::LIB_SAVE => {
            uses.saves.push(path(body, *first));
        }
        (Expr::Path { library, item }, Some(first)) if item == instructions::LIB_EXIST => {
            if let Some(symbol) = body.string(*first) {
                let symbol = symbol.strip_suffix("()").unwrap_or(&symbol);
                uses.guarded.insert((library.clone(), symbol.into()));
            }
        }
        (Expr::Name(name), Some(first)) if name == instructions::IS_DEFINED => {
            if let Expr::Path { library, item } = body.expr(root(body, *first)) {
                uses.guarded.insert((library.clone(), item.clone()));
            }
        }
        _ => {}
    }
}

/// Returns the root variable of an element or field.
fn root(body: &Body, mut id: ExprId) -> ExprId {
    while let Expr::Index(base, _) | Expr::Field { base, .. } | Expr::Paren(base) = body.expr(id) {
        id = *base;
    }
    id
}

fn path(body: &Body, id: ExprId) -> LoadedPath {
    if let Some(text) = body.string(id) {
        return LoadedPath::Whole(text);
    }
    let mut at = body.without_parentheses(id);
    while let Expr::Binary(BinaryOp::Add, left, _) = body.expr(at) {
        at = body.without_parentheses(*left);
        if let Some(text) = body.string(at) {
            return LoadedPath::Prefix { text, range: body.range(at) };
        }
    }
    LoadedPath::Unknown
}
