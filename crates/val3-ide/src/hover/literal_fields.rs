//! Hover for a value in `{…}`: the field that it initialises.

use val3_analysis::body::{Expr, body};
use val3_analysis::db::{Db, Project};
use val3_analysis::infer::infer;
use val3_analysis::items::project::items;
use val3_analysis::ty::Base;
use val3_lang::types::fields;

use super::field_line;
use super::text::Hover;
use crate::FilePosition;
use crate::markdown::fenced;

/// Field of the innermost literal that has a value at the position.
pub(super) fn hover(db: &dyn Db, project: Project, at: FilePosition) -> Option<Hover> {
    let body = body(db, at.file);
    let literals = body.exprs().filter_map(|(id, expr, range)| match expr {
        Expr::Struct(values) if range.contains_inclusive(at.offset) => Some((id, values, range)),
        _ => None,
    });
    let (id, values, _) = literals.min_by_key(|(.., range)| range.len())?;
    let holds = |value: &Option<_>| value.is_some_and(|value| body.range(value).contains_inclusive(at.offset));
    let number = values.iter().position(holds)?;
    let value = values.get(number).copied().flatten()?;
    let Base::Builtin(ty, arm) = infer(db, project, at.file).ty(id).base else { return None };
    let field = fields(ty, arm.or(items(db, project).arm)).get(number)?;
    let line = fenced(&format!("{} {}.{}", field.ty.name(), ty.name(), field.name));
    Some(Hover { range: body.range(value), markdown: line + "\n" + &field_line(db, project, field) })
}

#[cfg(test)]
mod tests {
    use crate::hover::hover;
    use crate::testing::MarkedListing;

    fn shown(listing: &str) -> String {
        let marked = MarkedListing::new(listing);
        hover(marked.db(), marked.at()).map(|hover| hover.markdown).unwrap_or_default()
    }

    #[test]
    fn values_of_literals_have_the_page_of_their_field() {
        let found = shown("trsf trA\ntrA={1,2,3,4,5$0,6}");
        assert!(found.contains("num trsf.ry"), "{found}");
        let found = shown("point pA\npA={{1,2,3$0,4,5,6},{sfree,efree,wfree}}");
        assert!(found.contains("num trsf.z"), "{found}");
        assert_eq!(shown("num nA\nnA=3$0.5"), "");
    }
}
