//! The data of a file and their values.

use val3_analysis::items::data;
use val3_analysis::xml::Element;
use val3_data::{Content, SavedData, SavedValue, Shape};
use val3_lang::types::Container;
use val3_syntax::TextRange;
use val3_syntax::view::View;

use super::{DataType, Datum, DatumValue, Dialect};

/// A variable as its file declares it.
pub(super) struct Declared {
    pub(super) saved: SavedData,
    public: bool,
    range: TextRange,
}

/// The variables of a file, in order. Elements without a name are left out.
pub(super) fn data(file: View<'_>, dialect: Dialect) -> Vec<Declared> {
    data::elements(file).filter_map(|element| declared(element, dialect)).collect()
}

fn declared(element: Element<'_>, dialect: Dialect) -> Option<Declared> {
    let range = element.attribute("name")?.range;
    let public = match dialect {
        Dialect::New => element.value("access").is_some_and(|access| access.trim() != "private"),
        Dialect::Old => element.value("public").is_some_and(|public| public.trim() == "true"),
    };
    Some(Declared { saved: val3_data::read(element), public, range })
}

/// The same as rows of tables.
pub(super) fn with_columns(data: Vec<Declared>, types: &[DataType]) -> Vec<Datum> {
    let datum =
        |declared: Declared| Datum { public: declared.public, range: declared.range, ..datum(declared.saved, types) };
    data.into_iter().map(datum).collect()
}

fn datum(saved: SavedData, types: &[DataType]) -> Datum {
    let columns: Vec<&str> = types
        .iter()
        .find(|ty| ty.name == saved.type_name)
        .map_or_else(Vec::new, |ty| ty.columns.iter().map(|column| column.id).collect());
    let (container, sizes) = match saved.shape {
        Shape::Keys => (Container::Collection, vec![u32::try_from(saved.values.len()).unwrap_or(u32::MAX)]),
        Shape::Sizes(sizes) => (Container::Array { dims: u8::try_from(sizes.len()).unwrap_or(1) }, sizes),
    };
    let values = saved.values.into_iter().map(|saved| value(saved, &columns, types)).collect();
    let (name, type_name) = (saved.name, saved.type_name);
    Datum { name, public: true, type_name, container, sizes, range: TextRange::default(), values }
}

fn value(saved: SavedValue, columns: &[&str], types: &[DataType]) -> DatumValue {
    let key = saved.key;
    match saved.content {
        Content::Fields(fields) => {
            let fields = fields.into_iter().map(|field| datum(field.data, types)).collect();
            DatumValue { key, texts: Vec::new(), fields }
        }
        Content::Attributes(mut attributes) => {
            let mut text = |column: &&str| {
                let found = attributes.iter_mut().find(|(name, _)| name == *column);
                found.map(|(_, text)| std::mem::take(text))
            };
            DatumValue { key, texts: columns.iter().map(&mut text).collect(), fields: Vec::new() }
        }
    }
}
