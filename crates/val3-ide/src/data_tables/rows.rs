//! Data of a file and their values.

use val3_analysis::items::data;
use val3_analysis::xml::XmlElement;
use val3_data::{SavedContainer, SavedContent, SavedData, SavedValue};
use val3_lang::types::Container;
use val3_syntax::TextRange;
use val3_syntax::view::View;

use super::{DataType, DatumValue, TableVariable};

/// Variables in a file and their name ranges, in order. Elements without a name are omitted.
pub(super) fn elements(file: View<'_>) -> impl Iterator<Item = (XmlElement<'_>, TextRange)> {
    data::elements(file).filter_map(|element| Some((element, element.attribute("name")?.range)))
}

/// A variable as rows of the tables.
pub(super) fn row(element: XmlElement<'_>, name: TextRange, types: &[DataType]) -> TableVariable {
    let public = match element.name() {
        "Data" => element.value("access").is_some_and(|access| access.trim() != "private"),
        _ => element.value("public").is_some_and(|public| public.trim() == "true"),
    };
    TableVariable { public, range: name, ..datum(val3_data::read(element), types) }
}

fn datum(saved: SavedData, types: &[DataType]) -> TableVariable {
    let columns: Vec<&str> = types
        .iter()
        .find(|ty| ty.name == saved.type_name)
        .map_or_else(Vec::new, |ty| ty.columns.iter().map(|column| column.id).collect());
    let (container, sizes) = match saved.shape {
        SavedContainer::Keys => (Container::Collection, vec![u32::try_from(saved.values.len()).unwrap_or(u32::MAX)]),
        SavedContainer::Sizes(sizes) => (Container::Array { dims: u8::try_from(sizes.len()).unwrap_or(1) }, sizes),
    };
    let values = saved.values.into_iter().map(|saved| value(saved, &columns, types)).collect();
    let (name, type_name) = (saved.name, saved.type_name);
    TableVariable { name, public: true, type_name, container, sizes, range: TextRange::default(), values }
}

fn value(saved: SavedValue, columns: &[&str], types: &[DataType]) -> DatumValue {
    let key = saved.key;
    match saved.content {
        SavedContent::Fields(fields) => {
            let fields = fields.into_iter().map(|field| datum(field.data, types)).collect();
            DatumValue { key, texts: Vec::new(), fields }
        }
        SavedContent::Attributes(mut attributes) => {
            let texts = columns.iter().map(|column| {
                let attribute = attributes.iter_mut().find(|(name, _)| name == *column);
                attribute.map(|(_, text)| std::mem::take(text))
            });
            DatumValue { key, texts: texts.collect(), fields: Vec::new() }
        }
    }
}
