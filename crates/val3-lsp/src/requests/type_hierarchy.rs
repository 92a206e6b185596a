//! `textDocument/prepareTypeHierarchy`, `typeHierarchy/supertypes` and `subtypes`

use tower_lsp::lsp_types::*;
use val3_analysis::db::{Db, File};
use val3_ide::TypeItem;

use crate::snapshot::{Refusal, Snapshot};

type HierarchyResult = Result<Option<Vec<TypeHierarchyItem>>, Refusal>;

pub(crate) fn prepare(snapshot: &Snapshot, params: &TypeHierarchyPrepareParams) -> HierarchyResult {
    let at = snapshot.position(&params.text_document_position_params)?;
    Ok(val3_ide::type_item(snapshot.db(), at).map(|found| vec![item(snapshot, &found)]))
}

pub(crate) fn supertypes(snapshot: &Snapshot, params: &TypeHierarchySupertypesParams) -> HierarchyResult {
    related(snapshot, &params.item, val3_ide::supertypes)
}

pub(crate) fn subtypes(snapshot: &Snapshot, params: &TypeHierarchySubtypesParams) -> HierarchyResult {
    related(snapshot, &params.item, val3_ide::subtypes)
}

fn related(snapshot: &Snapshot, of: &TypeHierarchyItem, find: fn(&dyn Db, File) -> Vec<TypeItem>) -> HierarchyResult {
    let file = snapshot.file(&of.uri)?;
    Ok(Some(find(snapshot.db(), file).iter().map(|found| item(snapshot, found)).collect()))
}

/// Converts a type. A user type is a project file in which its name does not appear, so the range is the start of the
/// file.
fn item(snapshot: &Snapshot, found: &TypeItem) -> TypeHierarchyItem {
    TypeHierarchyItem {
        name: found.name.clone(),
        kind: SymbolKind::STRUCT,
        tags: None,
        detail: None,
        uri: snapshot.uri(found.file),
        range: Range::default(),
        selection_range: Range::default(),
        data: None,
    }
}
