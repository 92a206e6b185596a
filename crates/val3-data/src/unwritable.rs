//! Values that a data file cannot contain, so that saving them would write a file with other values, or a file that
//! cannot be loaded.

use std::fmt;

use val3_lang::types::{AttributeValue, BaseType, attribute};
use val3_syntax::characters::is_allowed;
use val3_syntax::xml::XmlElement;

use crate::{SavedContent, SavedData, SavedValue, lists, reference, saved_data};

/// A value that a data file cannot contain.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnwritableValue {
    /// Path of the data, for example `sName[2]` or `tSlot[0].nWeight[0]`.
    pub path: String,
    /// Reason.
    pub reason: UnwritableReason,
}

/// Reason why a data file cannot contain a value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum UnwritableReason {
    /// A character that no XML file can contain, not even as a reference such as `&#27;`.
    Character(char),
    /// A number that is infinite or not a number.
    Number(String),
    /// In s5 and s6, all values of a variable have one father: the father of another value.
    OtherFather(String),
    /// A father that has no form in the files of s5 and s6, such as an element of a collection.
    Father(String),
}

impl fmt::Display for UnwritableValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let path = &self.path;
        match &self.reason {
            UnwritableReason::Character(character) => write!(
                f,
                "`{path}` contains the character U+{:04X}, which a data file cannot contain: remove it before saving",
                u32::from(*character)
            ),
            UnwritableReason::Number(text) => write!(
                f,
                "a number of `{path}` is {text}, which a data file cannot contain: set another value before saving"
            ),
            UnwritableReason::OtherFather(father) => write!(
                f,
                "`{path}` and another value of its variable have different fathers, but files of s5 and s6 contain one \
                 father for the entire variable: link all values to `{father}`, or use two variables"
            ),
            UnwritableReason::Father(father) => {
                write!(f, "files of s5 and s6 cannot contain `{father}`, the father of `{path}`: link it to other data")
            }
        }
    }
}

/// Checks that a file can contain new values of the variable that `element` declares.
///
/// # Errors
/// The first value that it cannot contain.
pub(crate) fn check(element: XmlElement<'_>, data: &SavedData) -> Result<(), UnwritableValue> {
    check_texts(data, &data.name)?;
    if element.name() == "Data" { Ok(()) } else { check_fathers(element, data) }
}

fn check_texts(data: &SavedData, path: &str) -> Result<(), UnwritableValue> {
    for value in &data.values {
        let path = format!("{path}[{}]", value.key);
        check_characters(&value.key, &path)?;
        match &value.content {
            SavedContent::Attributes(attributes) => {
                for (name, text) in attributes {
                    check_characters(text, &path)?;
                    check_number(&data.type_name, name, text, &path)?;
                }
            }
            SavedContent::Fields(fields) => {
                let mut fields = fields.iter().map(|field| &field.data);
                fields.try_for_each(|field| check_texts(field, &format!("{path}.{}", field.name)))?;
            }
        }
    }
    Ok(())
}

fn check_characters(text: &str, path: &str) -> Result<(), UnwritableValue> {
    match text.chars().find(|character| !is_allowed(*character)) {
        Some(character) => {
            // The path may contain the character itself.
            let path = path.chars().map(|shown| if is_allowed(shown) { shown } else { char::REPLACEMENT_CHARACTER });
            Err(UnwritableValue { path: path.collect(), reason: UnwritableReason::Character(character) })
        }
        None => Ok(()),
    }
}

fn check_number(type_name: &str, name: &str, text: &str, path: &str) -> Result<(), UnwritableValue> {
    let attribute = BaseType::from_file_name(type_name).and_then(|(ty, arm)| attribute(ty, arm, name));
    let is_number = attribute.is_some_and(|attribute| matches!(attribute.value, AttributeValue::Number));
    if is_number && text.trim().parse::<f64>().is_ok_and(|number| !number.is_finite()) {
        return Err(UnwritableValue { path: path.to_owned(), reason: UnwritableReason::Number(text.to_owned()) });
    }
    Ok(())
}

/// Checks the fathers of a variable of s5 and s6, whose file contains one father for all values. Values without a
/// father, for example after `append`, have this father when the file is loaded.
fn check_fathers(element: XmlElement<'_>, data: &SavedData) -> Result<(), UnwritableValue> {
    let Some((first, father)) = lists::common_father(data) else { return Ok(()) };
    if !reference::is_old_reference(father) || !lists::has_father(element) {
        return Err(unwritable(data, first, UnwritableReason::Father(father.to_owned())));
    }
    match data.values.iter().find(|value| has_other_father(value, &data.type_name, father)) {
        Some(value) => Err(unwritable(data, value, UnwritableReason::OtherFather(father.to_owned()))),
        None => Ok(()),
    }
}

/// Whether the value has a father, which is not `father`.
fn has_other_father(value: &SavedValue, type_name: &str, father: &str) -> bool {
    let own = lists::father_of(value);
    own.is_some() && !saved_data::same_text(type_name, "fatherId", own, Some(father))
}

/// Creates the error for a value of the variable.
fn unwritable(data: &SavedData, value: &SavedValue, reason: UnwritableReason) -> UnwritableValue {
    UnwritableValue { path: format!("{}[{}]", data.name, value.key), reason }
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};
    use proptest::prelude::{Strategy, any, prop_assert, prop_assert_eq, prop_oneof, proptest};
    use val3_syntax::xml;

    use super::*;
    use crate::{SavedContainer, SavedField, number_text, read, rewrite};

    const NEW: &str = r#"<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"><Datas>
<Data name="sA" access="private" xsi:type="array" type="string" size="1" />
<Data name="trA" access="private" xsi:type="array" type="trsf" size="2" />
<Data name="tA" access="private" xsi:type="array" type="Slot" size="1" />
<Data name="nC" access="private" xsi:type="collection" type="num" />
</Datas></Database>"#;

    const OLD: &str = r#"<dataList><stringSection>
<string name="sA" public="false"><valueString index="0" value="" /></string>
</stringSection><frameSection>
<frame name="fA" public="false"><fFather alias="" name="fB" fatherIndex="0" />
<valueFrame index="0"><tfValue x="0" y="0" z="0" rx="0" ry="0" rz="0" /></valueFrame>
<valueFrame index="1"><tfValue x="0" y="0" z="0" rx="0" ry="0" rz="0" /></valueFrame>
<valueFrame index="2"><tfValue x="0" y="0" z="0" rx="0" ry="0" rz="0" /></valueFrame></frame>
</frameSection></dataList>"#;

    fn data(name: &str, ty: &str, values: &[(&str, &[(&str, &str)])]) -> SavedData {
        let attributes = |given: &[(&str, &str)]| {
            SavedContent::Attributes(given.iter().map(|(name, text)| ((*name).into(), (*text).to_owned())).collect())
        };
        let values =
            values.iter().map(|(key, given)| SavedValue { key: (*key).to_owned(), content: attributes(given) });
        let values: Vec<SavedValue> = values.collect();
        let shape = match name {
            "nC" => SavedContainer::Keys,
            _ => SavedContainer::Sizes(vec![u32::try_from(values.len()).unwrap()]),
        };
        SavedData { name: name.into(), type_name: ty.into(), shape, values, is_part: false }
    }

    #[track_caller]
    fn check(text: &str, data: SavedData, expected: Expect) {
        expected.assert_eq(&rewrite(text, &[data]).unwrap_err().to_string());
    }

    #[test]
    fn the_message_names_the_value() {
        let expected =
            expect!["`sA[0]` contains the character U+001B, which a data file cannot contain: remove it before saving"];
        check(NEW, data("sA", "string", &[("0", &[("value", "\u{1b}x")])]), expected);
        let expected =
            expect!["a number of `trA[1]` is inf, which a data file cannot contain: set another value before saving"];
        check(NEW, data("trA", "trsf", &[("0", &[("x", "1")]), ("1", &[("x", "inf")])]), expected);
        let expected = expect![
            "`nC[a�]` contains the character U+0000, which a data file cannot contain: remove it before saving"
        ];
        check(NEW, data("nC", "num", &[("a\0", &[])]), expected);
        let field = SavedField { initial: false, data: data("nWeight", "num", &[("0", &[("value", "NaN")])]) };
        let slot = SavedValue { key: "0".to_owned(), content: SavedContent::Fields(vec![field]) };
        let expected = expect![
            "a number of `tA[0].nWeight[0]` is NaN, which a data file cannot contain: set another value before saving"
        ];
        check(NEW, SavedData { values: vec![slot], ..data("tA", "Slot", &[]) }, expected);
    }

    fn frames(fathers: &[&str]) -> SavedData {
        let attributes: Vec<[(&str, &str); 1]> = fathers.iter().map(|father| [("fatherId", *father)]).collect();
        let values: Vec<(&str, &[(&str, &str)])> =
            ["0", "1", "2"].into_iter().zip(&attributes).map(|(key, given)| (key, given.as_slice())).collect();
        data("fA", "frame", &values)
    }

    #[test]
    fn old_files_have_one_father_for_a_variable() {
        let father = |fathers| {
            let text = rewrite(OLD, &[frames(fathers)]).unwrap();
            let start = text.find("<fFather").unwrap();
            text[start..].split(" />").next().unwrap().to_owned()
        };
        assert_eq!(father(&["fB[0]", "fB[0]", ""]), r#"<fFather alias="" name="fB" fatherIndex="0""#);
        assert_eq!(father(&["", "lib:fC[2]", "lib:fC[2]"]), r#"<fFather alias="lib" name="fC" fatherIndex="2""#);
        let expected = expect![
            "`fA[2]` and another value of its variable have different fathers, but files of s5 and s6 contain one father for the entire variable: link all values to `fB[0]`, or use two variables"
        ];
        check(OLD, frames(&["fB[0]", "fB[0]", "fB[1]"]), expected);
        let expected = expect![[
            r#"files of s5 and s6 cannot contain `lib:fC["a"]`, the father of `fA[0]`: link it to other data"#
        ]];
        check(OLD, frames(&[r#"lib:fC["a"]"#, "", ""]), expected);
    }

    fn texts() -> impl Strategy<Value = String> {
        prop_oneof![".{0,6}", proptest::collection::vec(any::<char>(), 0..4).prop_map(String::from_iter)]
    }

    proptest! {
        /// What is saved without an error is read again.
        #[test]
        fn a_written_value_is_read_again(text in texts(), key in texts(), number in any::<f64>(), old in any::<bool>()) {
            let number = number_text(number);
            let all = [
                data("sA", "string", &[("0", &[("value", &text)])]),
                data("trA", "trsf", &[("0", &[("x", &number)]), ("1", &[("rz", &number)])]),
                data("nC", "num", &[(&key, &[("value", &number)])]),
            ];
            for data in &all {
                let Ok(written) = rewrite(if old { OLD } else { NEW }, std::slice::from_ref(data)) else { continue };
                let parse = val3_syntax::parse(&written);
                prop_assert!(parse.errors().is_empty(), "{written}");
                let root = xml::root(parse.view()).unwrap();
                let named = |element: &XmlElement<'_>| element.value("name").as_deref() == Some(&*data.name);
                let Some(element) = crate::layout::elements(root).find(named) else { continue };
                let found = read(element);
                for value in &data.values {
                    let same = found.values.iter().find(|found| found.key == value.key);
                    prop_assert!(saved_data::is_same(&data.type_name, Some(value), same), "{written}");
                }
            }
        }

        /// Each value that is rejected has a reason to be.
        #[test]
        fn ordinary_values_are_written(text in "[ -~\u{a0}-\u{d7ff}\t\r\n]{0,8}", number in proptest::num::f64::NORMAL) {
            let number = number_text(number);
            let all = [
                data("sA", "string", &[("0", &[("value", &text)])]),
                data("nC", "num", &[(&text, &[("value", &number)])]),
            ];
            prop_assert_eq!(rewrite(NEW, &all).err(), None);
            prop_assert_eq!(rewrite(OLD, &all).err(), None);
        }
    }
}
