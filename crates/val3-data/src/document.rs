//! New data files.

use val3_syntax::{TextEdit, never, xml};

use crate::SavedData;
use crate::layout::DataLayout;

/// Data file without data.
const EMPTY: &str = r#"<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas />
</Database>
"#;

/// Data with its access.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DeclaredData {
    /// Whether other projects can use the data.
    pub is_public: bool,
    /// Name, type and values.
    pub data: SavedData,
}

/// A new data file of s7 and s8 with these data. Values and attributes that are the default of their type are omitted,
/// as by the vendor's tools.
#[must_use]
pub fn document(data: &[DeclaredData]) -> String {
    let parse = val3_syntax::parse(EMPTY);
    let root = xml::root(parse.view());
    let Some((root, list)) = root.and_then(|root| Some((root, root.elements().next()?))) else {
        never!("the empty data file has no list");
        return EMPTY.to_owned();
    };
    let layout = DataLayout::of(EMPTY, root);
    let lines: Vec<String> = data.iter().flat_map(|declared| layout.data(&declared.data, declared.is_public)).collect();
    if lines.is_empty() {
        return EMPTY.to_owned();
    }
    let (range, text) = layout.filled(list, &lines);
    TextEdit::apply_all(EMPTY, &[TextEdit { range, text }])
}

#[cfg(test)]
mod tests {
    use expect_test::expect;
    use proptest::prelude::*;

    use super::*;
    use crate::{SavedContainer, SavedContent, SavedField, SavedValue, read};

    fn num(name: &str, sizes: &[u32], values: &[(&str, f64)]) -> SavedData {
        let value = |(key, number): &(&str, f64)| SavedValue {
            key: (*key).to_owned(),
            content: SavedContent::Attributes(vec![("value".into(), number.to_string())]),
        };
        let shape = SavedContainer::Sizes(sizes.to_vec());
        let values = values.iter().map(value).collect();
        SavedData { name: name.into(), type_name: "num".into(), shape, values, is_part: false }
    }

    #[test]
    fn data_are_written_as_by_the_tools() {
        let field = SavedField { initial: false, data: num("nID", &[1], &[("0", 7.0)]) };
        let slot = SavedData {
            type_name: "Slot".into(),
            values: vec![SavedValue { key: "1".to_owned(), content: SavedContent::Fields(vec![field]) }],
            ..num("tSlot", &[2], &[])
        };
        let all = [
            DeclaredData { is_public: true, data: num("nA", &[2, 3], &[("0,1", 1.5), ("1,2", 0.0)]) },
            DeclaredData { is_public: false, data: num("l_nB", &[1], &[]) },
            DeclaredData { is_public: false, data: slot },
        ];
        expect![[r#"
            <?xml version="1.0" encoding="utf-8"?>
            <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
              <Datas>
                <Data name="nA" access="public" xsi:type="array" type="num" size="2 3">
                  <Value key="0,1" value="1.5" />
                </Data>
                <Data name="l_nB" access="private" xsi:type="array" type="num" size="1" />
                <Data name="tSlot" access="private" xsi:type="array" type="Slot" size="2">
                  <Value key="1">
                    <Field name="nID" xsi:type="array" type="num" size="1">
                      <Value key="0" value="7" />
                    </Field>
                  </Value>
                </Data>
              </Datas>
            </Database>
        "#]]
        .assert_eq(&document(&all));
        assert_eq!(document(&[]), EMPTY);
    }

    proptest! {
        #[test]
        fn written_texts_are_read_again(texts in proptest::collection::vec("[a-z<>&\"' \n\u{e4}]{1,8}", 0..5)) {
            let content = |text: &String| SavedContent::Attributes(vec![("value".into(), text.clone())]);
            let value = |(key, text): (usize, &String)| SavedValue { key: key.to_string(), content: content(text) };
            let data = SavedData {
                type_name: "string".into(),
                values: texts.iter().enumerate().map(value).collect(),
                ..num("sTexts", &[5], &[])
            };
            let text = document(&[DeclaredData { is_public: false, data: data.clone() }]);
            let parse = val3_syntax::parse(&text);
            prop_assert!(parse.errors().is_empty());
            let list = xml::root(parse.view()).and_then(|root| root.elements().next());
            let element = list.and_then(|list| list.elements().next());
            prop_assert_eq!(element.map(read), Some(data));
        }
    }
}
