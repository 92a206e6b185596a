//! Uses of global data with a literal index or key, for container conversions.

use val3_analysis::application::{application, unlisted_may_use};
use val3_analysis::body::{Body, Expr, ExprId, body};
use val3_analysis::db::{Db, File, Project};
use val3_analysis::infer::infer;
use val3_analysis::items::parse;
use val3_analysis::items::program;
use val3_analysis::items::project::{data_files, items};
use val3_analysis::occurrences::{Symbol, Usage, occurrences};
use val3_analysis::pages::is_bindings;
use val3_lang::instruction::ArgumentForm;
use val3_syntax::{SyntaxKind, TextRange, text_at};

use crate::RefactoringError;
use crate::edit::FileEdit;
use crate::navigate::{implemented, implementing};
use crate::references::{projects_using, uses};
use crate::rename::{Index, index};

/// A literal index or key.
pub(super) struct IndexUse {
    file: File,
    /// Range, including quotes.
    range: TextRange,
    /// Text without quotes and with entities decoded.
    pub(super) text: String,
    /// Whether it is a string, the key of a collection.
    pub(super) is_key: bool,
    /// Quote character for the surrounding code or attribute.
    quote: &'static str,
}

impl IndexUse {
    /// Edit that replaces it with a number.
    pub(super) fn number(&self, number: usize) -> FileEdit {
        FileEdit { file: self.file, range: self.range, text: number.to_string() }
    }

    /// Edit that replaces it with the text as a key.
    pub(super) fn key(&self) -> FileEdit {
        FileEdit { file: self.file, range: self.range, text: format!("{0}{1}{0}", self.quote, self.text) }
    }
}

/// All uses of the data in all projects, or the reason why the container cannot be converted.
pub(super) fn index_uses(db: &dyn Db, project: Project, name: &str) -> Result<Vec<IndexUse>, RefactoringError> {
    let users = projects_using(db, project);
    if users.iter().any(|user| items(db, *user).types.values().any(|of| *of == Some(project))) {
        return Err("the fields of user types are arrays".into());
    }
    let is_public = items(db, project).data.get(name).is_some_and(|item| item.decl.may_be_public());
    if is_public && implementing(db, project).chain(implemented(db, project)).next().is_some() {
        return Err(format!("`{name}` is part of an interface").into());
    }
    let reads_text = |user: &Project| application(db, *user).is_named_in_text(name);
    if users.iter().any(reads_text) || unlisted_may_use(db, project, name) {
        return Err(
            format!("a program may read `{name}` by its name, as a text, or is not listed in the project").into()
        );
    }
    let symbol = Symbol::Data(project, name.into());
    let mut found = Vec::new();
    for (file, user, range) in uses(db, &symbol) {
        let declares = occurrences(db, user, file).iter().any(|it| it.range == range && it.usage == Usage::Declaration);
        if !declares {
            found.push(IndexUses { db, user, file }.at(range).map_err(|problem| problem.shown(db, file, name))?);
        }
    }
    found.sort_by_key(|found| (found.file.path(db), found.range.start()));
    found.dedup_by_key(|found| (found.file, found.range));
    Ok(found)
}

/// Reason why a use prevents the conversion.
enum Obstacle {
    NoIndex,
    Computed,
    HandedOver,
    Bound,
    Broken,
}

impl Obstacle {
    fn shown(&self, db: &dyn Db, file: File, name: &str) -> String {
        let path = file.path(db).file_name().unwrap_or("");
        match self {
            Self::NoIndex => format!("`{path}` uses `{name}` as a whole, without an index"),
            Self::Computed => format!("`{path}` computes an index of `{name}`"),
            Self::HandedOver => format!("`{path}` hands over a part of `{name}`, not one value"),
            Self::Bound => format!("`{path}` binds `{name}` to a page"),
            Self::Broken => format!("`{path}` has a syntax error"),
        }
    }
}

/// Uses in one file as part of a project.
struct IndexUses<'db> {
    db: &'db dyn Db,
    user: Project,
    file: File,
}

impl IndexUses<'_> {
    /// Index after the name at this range.
    fn at(&self, name: TextRange) -> Result<IndexUse, Obstacle> {
        if is_bindings(self.db, self.file) {
            return Err(Obstacle::Bound);
        }
        if !parse(self.db, self.file).errors().is_empty() {
            return Err(Obstacle::Broken);
        }
        if data_files(self.db, self.user).contains(&self.file) {
            return self.in_father(name);
        }
        let body = body(self.db, self.file);
        let indexed = body.exprs().find_map(|(id, expr, _)| match expr {
            Expr::Index(base, indexes) if body.range(*base).end() == name.end() => Some((id, indexes)),
            _ => None,
        });
        let (id, indexes) = indexed.ok_or(Obstacle::NoIndex)?;
        let [index] = indexes.as_ref() else { return Err(Obstacle::Computed) };
        if self.is_handed_over(body, id, name) {
            return Err(Obstacle::HandedOver);
        }
        let (text, is_key) = match body.expr(*index) {
            Expr::Number(_) => (self.slice(body.range(*index)).to_owned(), false),
            Expr::String(key) => (key.to_string(), true),
            _ => return Err(Obstacle::Computed),
        };
        Ok(IndexUse { file: self.file, range: body.range(*index), text, is_key, quote: self.quote() })
    }

    /// Index in a father reference, for example `fTable[0]` or `tTrack["home"].fTable[0]`.
    fn in_father(&self, name: TextRange) -> Result<IndexUse, Obstacle> {
        match index(self.file.text(self.db), name.end()) {
            Index::Literal { text, whole, is_key, .. } => {
                Ok(IndexUse { file: self.file, range: whole, text, is_key, quote: ESCAPED })
            }
            Index::Computed => Err(Obstacle::Computed),
            Index::None => Err(Obstacle::NoIndex),
        }
    }

    fn slice(&self, range: TextRange) -> &str {
        text_at(self.file.text(self.db), range)
    }

    fn quote(&self) -> &'static str {
        let parse = parse(self.db, self.file);
        let code = program::code(parse.view());
        let is_plain = code.is_some_and(|code| code.token(SyntaxKind::CDATA_OPEN).is_some());
        if is_plain { "\"" } else { ESCAPED }
    }

    /// Whether the element is an argument that may stand for more than one value, for example an array from an index
    /// on.
    fn is_handed_over(&self, body: &Body, element: ExprId, name: TextRange) -> bool {
        let inference = infer(self.db, self.user, self.file);
        body.exprs().any(|(call, expr, _)| {
            let Expr::Call(_, arguments) = expr else { return false };
            let position = arguments.iter().position(|argument| body.without_parentheses(*argument) == element);
            let Some(at) = position else { return false };
            let Some(known) = inference.call(call) else { return self.is_reference(name) };
            let shape = known.form.and_then(|form| form.params.get(at)).map(|param| param.shape);
            !matches!(shape, Some(ArgumentForm::Value | ArgumentForm::Reference))
        })
    }

    fn is_reference(&self, name: TextRange) -> bool {
        let found = occurrences(self.db, self.user, self.file).iter().find(|found| found.range == name);
        found.is_none_or(|found| found.usage == Usage::Reference)
    }
}

/// Quote in an attribute, or in code without a CDATA section.
const ESCAPED: &str = "&quot;";
