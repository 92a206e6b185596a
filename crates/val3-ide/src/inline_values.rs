//! Variables in the code whose values a debugger displays while it is stopped.

use rustc_hash::{FxHashMap, FxHashSet};
use val3_analysis::body::{Body, Expr, ExprId, body};
use val3_analysis::db::{Db, File};
use val3_analysis::occurrences::{Symbol, occurrences};
use val3_syntax::{TextRange, decode_entities, text_at};

use crate::owner::owner;

/// A variable, element or field whose value can be displayed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct InlineValue {
    /// Range of the expression.
    pub range: TextRange,
    /// Expression for the debugger to evaluate.
    pub expression: String,
}

/// Variables of the program in `file` within a range, each at its last use, in the order of the text. Elements and
/// fields whose evaluation has side effects are omitted.
pub fn inline_values(db: &dyn Db, file: File, within: TextRange) -> Vec<InlineValue> {
    let Some(project) = owner(db, file) else { return Vec::new() };
    let body = body(db, file);
    let variables: FxHashSet<_> = occurrences(db, project, file)
        .iter()
        .filter(|found| matches!(found.symbol, Symbol::Local(..) | Symbol::Param(..) | Symbol::Data(..)))
        .map(|found| found.range.end())
        .collect();
    let parts = parts(body);
    let mut last = FxHashMap::default();
    for (id, _, range) in body.exprs().filter(|(_, _, range)| within.contains_range(*range)) {
        let is_variable = root(body, id).is_some_and(|root| variables.contains(&body.range(root).end()));
        if is_variable && !parts.contains(&id) {
            let text = text_at(file.text(db), range);
            let place: &mut TextRange = last.entry(decode_entities(text).into_owned()).or_insert(range);
            if place.start() < range.start() {
                *place = range;
            }
        }
    }
    let mut found: Vec<_> = last.into_iter().map(|(expression, range)| InlineValue { range, expression }).collect();
    found.sort_by_key(|found| found.range.start());
    found
}

/// Expressions that are the start of a longer variable expression, or the name of a callee.
fn parts(body: &Body) -> FxHashSet<ExprId> {
    let parts = body.exprs().filter_map(|(_, expr, _)| match expr {
        Expr::Field { base, .. } | Expr::Index(base, _) | Expr::Call(base, _) => Some(*base),
        _ => None,
    });
    parts.collect()
}

/// Name at the start of a variable expression with indexes and fields; `None` for other expressions.
fn root(body: &Body, id: ExprId) -> Option<ExprId> {
    match body.expr(id) {
        Expr::Name(_) | Expr::Path { .. } => Some(id),
        Expr::Field { base, .. } => root(body, *base),
        Expr::Index(base, keys) => root(body, *base).filter(|_| !keys.iter().any(|key| acts(body, *key))),
        _ => None,
    }
}

/// Whether the expression contains a call or an assignment.
fn acts(body: &Body, id: ExprId) -> bool {
    body.within(id).any(|id| matches!(body.expr(id), Expr::Call(..) | Expr::Assign(..) | Expr::Missing))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::MarkedListing;

    /// Variables of the selected lines, each with its line number relative to the selection.
    fn shown(listing: &str) -> Vec<String> {
        let marked = MarkedListing::new(listing);
        let (file, within) = (marked.at().file, marked.selected.unwrap());
        let lines = |to: usize| file.text(marked.db())[usize::from(within.start())..to].matches('\n').count();
        let found = inline_values(marked.db(), file, within).into_iter();
        found.map(|found| format!("{} {}", lines(found.range.start().into()), found.expression)).collect()
    }

    #[test]
    fn variables_are_shown_where_they_are_named_last() {
        assert_eq!(
            shown("num nA\nnum nB\nnum nList[3]\npoint pA\nnB=1\n$0nA=nB+1\nnList[nA+1]=pA.trsf.x\nput(nA)\n$0nB=2"),
            ["0 nB", "1 nList[nA+1]", "1 pA.trsf.x", "2 nA"]
        );
    }

    #[test]
    fn calls_are_not_evaluated() {
        assert_eq!(shown("num nList[3]\n$0nList[get()]=1\ncall other()$0\nprogram other()\nbegin\nend"), [""; 0]);
    }

    #[test]
    fn items_of_libraries_and_escaped_keys_are_read() {
        let library = "library part \"Disk://part/part.pjx\"\n$0put(part:nWeight)$0\n--- part\npublic num nWeight";
        assert_eq!(shown(library), ["0 part:nWeight"]);
        let old = "dio dIn[\"\"]\n=== main/start.pgx\n<programList xmlns=\"ProgramNameSpace\">\n<program name=\"start\" public=\"false\"><source><code>begin\n$0put(dIn[&quot;a&quot;])$0\nend</code></source></program></programList>\n";
        assert_eq!(shown(old), ["0 dIn[\"a\"]"]);
    }
}
